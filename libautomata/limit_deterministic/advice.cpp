#include "libautomata/limit_deterministic/advice.hpp"

#include <algorithm>
#include <stdexcept>
#include <unordered_map>
#include <utility>

#include "libltl/structure/by_subformula.hpp"

namespace waymark::automata {
namespace {

using ltl::Formula;
using ltl::Op;

// Formulas under decisions: U and R subformulas that are in (true) or out. An image is unknown when it depends on one
// that is not decided; that one is remembered.
class AdviceEvaluation {
 public:
  enum class As { Safe, Cosafe };
  using Decisions = std::unordered_map<Formula, bool>;

  AdviceEvaluation(ltl::Arena& arena, const Decisions& decisions) : arena_(arena), decisions_(decisions) {}

  std::optional<Formula> image(Formula f, As as) {
    auto& known = known_[as == As::Safe ? 0 : 1];
    if (const auto at = known.find(f); at != known.end()) return at->second;
    const std::optional<Formula> made = make(f, as);
    known.emplace(f, made);
    return made;
  }
  const std::optional<Formula>& undecided() const { return undecided_; }

 private:
  std::optional<Formula> make(Formula f, As as) {
    switch (f.op()) {
      case Op::False:
      case Op::True:
      case Op::Atom:
      case Op::Not: return f;
      case Op::And:
      case Op::Or: return junction(f, as);
      case Op::Next: {
        const std::optional<Formula> operand = image(f[0], as);
        return operand ? std::optional(ltl::next(*operand)) : std::nullopt;
      }
      case Op::Until: return until(f, as);
      case Op::Release: return release(f, as);
      case Op::WeakNext:
      case Op::Yesterday:
      case Op::Since:
      case Op::Iff: break;
    }
    throw std::logic_error("advice is for negation normal forms over infinite words");
  }
  // The absorbing constant decides, whatever is unknown beside it.
  std::optional<Formula> junction(Formula f, As as) {
    const Formula absorbing = arena_.constant(f.op() == Op::Or);
    std::vector<Formula> images;
    bool all = true;
    for (Formula operand : f.operands()) {
      const std::optional<Formula> one = image(operand, as);
      if (one == absorbing) return absorbing;
      if (one) images.push_back(*one);
      all = all && one;
    }
    if (!all) return std::nullopt;
    return f.op() == Op::Or ? ltl::disjunction(arena_, images) : ltl::conjunction(arena_, images);
  }
  std::optional<Formula> until(Formula f, As as) {
    if (as == As::Safe) {
      const std::optional<bool> in = decision(f);
      if (!in) return std::nullopt;
      if (!*in) return arena_.constant(false);
    }
    const std::optional<Formula> left = image(f[0], as), right = image(f[1], as);
    if (right == arena_.constant(true)) return right;
    if (!left || !right) return std::nullopt;
    return as == As::Safe ? ltl::weak_until(*left, *right) : ltl::until(*left, *right);
  }
  std::optional<Formula> release(Formula f, As as) {
    if (as == As::Cosafe) {
      const std::optional<bool> in = decision(f);
      if (!in) return std::nullopt;
      if (*in) return arena_.constant(true);
    }
    const std::optional<Formula> left = image(f[0], as), right = image(f[1], as);
    if (right == arena_.constant(false)) return right;
    if (!left || !right) return std::nullopt;
    return as == As::Safe ? ltl::release(*left, *right) : ltl::strong_release(*left, *right);
  }
  std::optional<bool> decision(Formula f) {
    const auto at = decisions_.find(f);
    if (at != decisions_.end()) return at->second;
    if (!undecided_) undecided_ = f;
    return std::nullopt;
  }

  ltl::Arena& arena_;
  const Decisions& decisions_;
  std::unordered_map<Formula, std::optional<Formula>> known_[2];
  std::optional<Formula> undecided_;
};

std::vector<Formula> disjuncts(Formula f) {
  if (f.op() != Op::Or) return {f};
  return {f.operands().begin(), f.operands().end()};
}

// Of a safety formula: φ W ψ becomes G φ, φ R ψ becomes G ψ.
Formula without_goals(Formula f) {
  const auto image = [](Formula g, const ltl::BySubformula<Formula>& known) {
    std::vector<Formula> parts;
    if (g.op() == Op::Release) {  // φ W ψ is ψ R (φ ∨ ψ)
      const std::vector<Formula> goals = disjuncts(g[0]);
      for (Formula h : disjuncts(g[1]))
        if (std::find(goals.begin(), goals.end(), h) == goals.end()) parts.push_back(known.at(h));
      return ltl::always(ltl::disjunction(g.arena(), parts));
    }
    for (Formula operand : g.operands()) parts.push_back(known.at(operand));
    if (g.op() == Op::And) return ltl::conjunction(g.arena(), parts);
    if (g.op() == Op::Or) return ltl::disjunction(g.arena(), parts);
    return g.op() == Op::Next ? ltl::next(parts[0]) : g;
  };
  return ltl::BySubformula<Formula>(f, image).top();
}

class Enumeration {
 public:
  Enumeration(Formula f, std::size_t most) : formula_(f), arena_(f.arena()), most_(most) {}
  std::optional<std::vector<Advice>> run() {
    decide();
    if (made_.size() > most_) return std::nullopt;
    return std::move(made_);
  }

 private:
  void decide() {
    if (made_.size() > most_) return;
    AdviceEvaluation reading(arena_, decisions_);
    std::optional<Advice> advice = read(reading);
    if (!advice) return;
    if (!reading.undecided()) {
      advice->narrow = narrow(reading);
      made_.push_back(*std::move(advice));
      return;
    }
    const Formula next = *reading.undecided();
    order_.push_back(next);
    for (const bool in : {true, false}) {
      decisions_[next] = in;
      decide();
    }
    decisions_.erase(next);
    order_.pop_back();
  }
  // nullopt: false by its look. What is not known yet is left out.
  std::optional<Advice> read(AdviceEvaluation& reading) const {
    std::vector<Formula> safe;
    Advice out{formula_, {}, formula_};
    const auto add = [&](std::optional<Formula> image, std::vector<Formula>& to) {
      if (image && *image != arena_.constant(true)) to.push_back(*image);
      return image != arena_.constant(false);
    };
    if (!add(reading.image(formula_, AdviceEvaluation::As::Safe), safe)) return std::nullopt;
    for (Formula g : order_) {
      if (!decisions_.at(g)) continue;
      if (g.op() == Op::Until && !add(reading.image(g[1], AdviceEvaluation::As::Cosafe), out.often))
        return std::nullopt;
      if (g.op() == Op::Release) {
        const std::optional<Formula> image = reading.image(g[1], AdviceEvaluation::As::Safe);
        if (!add(image ? std::optional(ltl::always(*image)) : std::nullopt, safe)) return std::nullopt;
      }
    }
    out.safe = ltl::conjunction(arena_, safe);
    std::sort(out.often.begin(), out.often.end());
    out.often.erase(std::unique(out.often.begin(), out.often.end()), out.often.end());
    return out;
  }

  // The members of Y whole, G (φ₁ R φ₂) in place of G φ₂, so that there is something to give up.
  Formula narrow(AdviceEvaluation& reading) const {
    std::vector<Formula> all{reading.image(formula_, AdviceEvaluation::As::Safe).value()};
    for (Formula g : order_) {
      if (g.op() != Op::Release || !decisions_.at(g)) continue;
      std::optional<Formula> image = reading.image(g, AdviceEvaluation::As::Safe);
      if (!image) image = reading.image(g[1], AdviceEvaluation::As::Safe);
      all.push_back(ltl::always(image.value()));
    }
    return without_goals(ltl::conjunction(arena_, all));
  }

  Formula formula_;
  ltl::Arena& arena_;
  std::size_t most_;
  AdviceEvaluation::Decisions decisions_;
  std::vector<Formula> order_;  // decided, in this order
  std::vector<Advice> made_;
};

}  // namespace

std::optional<std::vector<Advice>> advices(Formula f, std::size_t most) { return Enumeration(f, most).run(); }

}  // namespace waymark::automata

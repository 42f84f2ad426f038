#include "libltl/rewriting/without_past.hpp"

#include <string>
#include <unordered_map>
#include <vector>

#include "libltl/structure/substitute.hpp"

namespace waymark::ltl {
namespace {

Formula fresh(Arena& arena) {
  std::string name = "history " + std::to_string(arena.vocabulary().size());
  while (arena.vocabulary().find(name)) name += "'";
  return arena.atom(name);
}

// From every letter that satisfies `now`, the next letter, if any, has the history exactly where `then` holds.
Formula goes_on(Formula now, Formula history, Formula then) {
  return always(implies(now, weak_next(iff(history, then))));
}

struct Image {
  Formula formula;
  bool future = false, mixed = false;  // an operator of the future occurs; … below one of the past
};

class Remover {
 public:
  explicit Remover(Arena& to) : to_(to) {}

  Image image(Formula f) {
    Image out{to_.constant(false)};
    std::vector<Formula> operands;
    for (Formula operand : f.operands()) {
      const Image& known = image_.at(operand);
      operands.push_back(known.formula);
      out.future = out.future || known.future;
      out.mixed = out.mixed || known.mixed;
    }
    if (is_past(f.op())) {
      out.mixed = out.mixed || out.future;
      out.formula = f.op() == Op::Yesterday ? of_yesterday(operands[0]) : of_since(operands[0], operands[1]);
    } else {
      const Op op = f.op();
      out.future = out.future || op == Op::Next || op == Op::WeakNext || op == Op::Until || op == Op::Release;
      out.formula = with_operands(f, to_, operands);
    }
    return out;
  }

  WithoutPast remove(Formula f) {
    for (Formula g : subformulas(f)) image_.emplace(g, image(g));
    const Image& whole = image_.at(f);
    conditions_.push_back(whole.formula);
    return {conjunction(to_, conditions_), !whole.mixed};
  }

 private:
  Formula of_yesterday(Formula f) {
    const Formula history = fresh(to_);
    conditions_.push_back(negate(history));
    conditions_.push_back(goes_on(f, history, to_.constant(true)));
    conditions_.push_back(goes_on(negate(f), history, to_.constant(false)));
    return history;
  }
  Formula of_since(Formula left, Formula right) {
    const Formula history = fresh(to_);
    conditions_.push_back(iff(history, right));
    conditions_.push_back(goes_on(history, history, disjunction(left, right)));
    conditions_.push_back(goes_on(negate(history), history, right));
    return history;
  }

  Arena& to_;
  std::unordered_map<Formula, Image> image_;
  std::vector<Formula> conditions_;
};

}  // namespace

WithoutPast without_past(Formula f, Arena& to) { return Remover(to).remove(f); }

}  // namespace waymark::ltl

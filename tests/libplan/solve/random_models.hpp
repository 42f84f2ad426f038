// Small random models, and the answers to questions about them by the plainest way there is.
#pragma once
#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "libautomata/finite/dfa.hpp"
#include "libltl/structure/random.hpp"
#include "libplan/model/mdp.hpp"

namespace waymark::plan::testing {

inline ltl::Vocabulary vocabulary_ab() {
  ltl::Vocabulary out;
  out.add("a");
  out.add("b");
  return out;
}

struct RandomModel {
  std::uint32_t states = 4;
  std::uint32_t most_choices = 3;
  bool deterministic = false;
  bool unit_costs = true;
};

// Letters on moves: an outcome carries any letter over {a, b}, whatever its target.
inline Mdp random_model(ltl::Random& random, const RandomModel& shape) {
  MdpBuilder builder(vocabulary_ab());
  const auto letter = [&] {
    ltl::Letter out;
    for (std::uint32_t p = 0; p < 2; ++p)
      if (random.below(3) == 0) out.insert(ltl::Proposition{p});
    return builder.letter(out);
  };
  for (std::uint32_t s = 0; s < shape.states; ++s) {
    builder.add_state();
    const std::size_t choices = 1 + random.below(shape.most_choices);
    for (std::size_t k = 0; k < choices; ++k) {
      builder.add_choice("c" + std::to_string(k), shape.unit_costs ? 1 : static_cast<double>(random.below(4)));
      const double p = shape.deterministic ? 1 : 0.25 * static_cast<double>(1 + random.below(4));
      builder.add_outcome(static_cast<std::uint32_t>(random.below(shape.states)), letter(), p);
      if (p < 1) builder.add_outcome(static_cast<std::uint32_t>(random.below(shape.states)), letter(), 1 - p);
    }
  }
  const LetterId first = letter();
  return std::move(builder).build(0, first);
}

// "0: c0 → 0.25·1{a} …", to find a failing case again.
inline std::string show(const Mdp& mdp) {
  std::string out = "starts with " + ltl::show(mdp.letters()[mdp.initial_letter()], mdp.letters().vocabulary()) + "\n";
  for (std::uint32_t s = 0; s < mdp.states(); ++s)
    for (std::uint32_t k = 0; k < mdp.choices(s); ++k) {
      out += std::to_string(s) + ": cost " + std::to_string(mdp.cost(s, k)) + " →";
      mdp.for_each_outcome(s, k, [&](std::uint32_t t, LetterId letter, double p) {
        out += " " + std::to_string(p) + "·" + std::to_string(t) +
               ltl::show(mdp.letters()[letter], mdp.letters().vocabulary());
      });
      out += "\n";
    }
  return out;
}

// Values of all pairs (place, automaton state) by sweeps without end conditions but a number: what is reached from
// below.
class Plainly {
 public:
  Plainly(const Mdp& mdp, const automata::Dfa& dfa) : mdp_(mdp), dfa_(dfa) {}

  enum class Best { Greatest, Least };
  double probability(Best best) const {
    std::vector<double> x(mdp_.states() * dfa_.states(), 0);
    for (int sweep = 0; sweep < 1500; ++sweep) {
      const std::vector<double> last = x;
      for (std::uint32_t s = 0; s < mdp_.states(); ++s)
        for (std::uint32_t q = 0; q < dfa_.states(); ++q) x[at(s, q)] = step(s, q, last, best);
      if (x == last) break;
    }
    return x[start()];
  }

  // Greatest E γ^(T−1), T the choices until the task is done; 1 where it is at the start.
  double discounted(double discount) const {
    std::vector<double> x(mdp_.states() * dfa_.states(), 0);
    for (int sweep = 0; sweep < 1500; ++sweep) {
      const std::vector<double> last = x;
      for (std::uint32_t s = 0; s < mdp_.states(); ++s)
        for (std::uint32_t q = 0; q < dfa_.states(); ++q)
          if (!dfa_.is_accepting(automata::StateId{q})) x[at(s, q)] = discounted_step(s, q, last, discount);
      if (x == last) break;
    }
    const bool done = dfa_.is_accepting(automata::StateId{static_cast<std::uint32_t>(start() % dfa_.states())});
    return done ? 1 : x[start()];
  }

  // ∞ unless the greatest probability is 1; sweeps keep to choices after which it still is.
  double cost() const {
    std::vector<bool> sure(mdp_.states() * dfa_.states());
    for (std::uint32_t s = 0; s < mdp_.states(); ++s)
      for (std::uint32_t q = 0; q < dfa_.states(); ++q)
        sure[at(s, q)] = Plainly(mdp_, dfa_, s, q).probability(Best::Greatest) > 1 - 1e-9;
    if (!sure[start()]) return INFINITY;
    std::vector<double> x(sure.size(), 0);
    for (int sweep = 0; sweep < 1500; ++sweep) {
      const std::vector<double> last = x;
      for (std::uint32_t s = 0; s < mdp_.states(); ++s)
        for (std::uint32_t q = 0; q < dfa_.states(); ++q) {
          if (!sure[at(s, q)] || dfa_.is_accepting(automata::StateId{q})) continue;
          double best = INFINITY;
          for (std::uint32_t k = 0; k < mdp_.choices(s); ++k) {
            double sum = mdp_.cost(s, k);
            mdp_.for_each_outcome(s, k, [&](std::uint32_t t, LetterId letter, double p) {
              const std::size_t to = at(t, next(q, letter));
              sum = sure[to] ? sum + p * x[to] : INFINITY;
            });
            best = std::min(best, sum);
          }
          x[at(s, q)] = best;
        }
      if (x == last) break;
    }
    return x[start()];
  }

 private:
  Plainly(const Mdp& mdp, const automata::Dfa& dfa, std::uint32_t s, std::uint32_t q)
      : mdp_(mdp), dfa_(dfa), from_(at(s, q)) {}
  std::size_t at(std::uint32_t s, std::uint32_t q) const { return s * dfa_.states() + q; }
  std::uint32_t next(std::uint32_t q, LetterId letter) const {
    if (dfa_.is_accepting(automata::StateId{q})) return q;  // the task is done
    ltl::Letter theirs;
    for (ltl::Proposition p : dfa_.reads())
      if (mdp_.letters()[letter].contains(mdp_.letters().vocabulary().find(dfa_.vocabulary().name(p)).value()))
        theirs.insert(p);
    return dfa_.next(automata::StateId{q}, theirs).index;
  }
  std::size_t start() const {
    return from_ != SIZE_MAX ? from_ : at(mdp_.initial(), next(dfa_.initial().index, mdp_.initial_letter()));
  }
  double step(std::uint32_t s, std::uint32_t q, const std::vector<double>& x, Best best) const {
    if (dfa_.is_accepting(automata::StateId{q})) return 1;
    double out = best == Best::Greatest ? 0 : 1;
    for (std::uint32_t k = 0; k < mdp_.choices(s); ++k) {
      double sum = 0;
      mdp_.for_each_outcome(s, k,
                            [&](std::uint32_t t, LetterId letter, double p) { sum += p * x[at(t, next(q, letter))]; });
      out = best == Best::Greatest ? std::max(out, sum) : std::min(out, sum);
    }
    return out;
  }

  double discounted_step(std::uint32_t s, std::uint32_t q, const std::vector<double>& x, double discount) const {
    double best = 0;
    for (std::uint32_t k = 0; k < mdp_.choices(s); ++k) {
      double sum = 0;
      mdp_.for_each_outcome(s, k, [&](std::uint32_t t, LetterId letter, double p) {
        const std::uint32_t to = next(q, letter);
        sum += p * (dfa_.is_accepting(automata::StateId{to}) ? 1 : discount * x[at(t, to)]);
      });
      best = std::max(best, sum);
    }
    return best;
  }

  const Mdp& mdp_;
  const automata::Dfa& dfa_;
  std::size_t from_ = SIZE_MAX;
};

}  // namespace waymark::plan::testing

#include "libautomata/omega/random_automaton.hpp"

#include <stdexcept>

namespace waymark::automata {
namespace {

Condition random_condition(ltl::Random& random, std::uint32_t sets, std::size_t depth) {
  if (depth == 0 || random.below(3) == 0) {
    const auto mark = static_cast<std::uint32_t>(random.below(sets));
    return random.below(2) == 0 ? Condition::inf(mark) : Condition::fin(mark);
  }
  std::vector<Condition> operands{random_condition(random, sets, depth - 1), random_condition(random, sets, depth - 1)};
  return random.below(2) == 0 ? Condition::all_of(std::move(operands)) : Condition::any_of(std::move(operands));
}

class Maker {
 public:
  Maker(ltl::Random& random, const RandomAutomaton& options) : random_(random), options_(options) {}

  TransitionRelation make() {
    const std::uint32_t sets = options_.sets;
    out_.acceptance = options_.generic && sets > 0 ? Acceptance{sets, random_condition(random_, sets, 2)}
                                                   : Acceptance::generalized_buchi(sets);
    for (std::uint32_t q = 0; q < options_.states; ++q) out_.roots.push_back(diagram(0));
    return std::move(out_);
  }

 private:
  // Two decisions of three are made, the others left out.
  Mtbdd::Node diagram(Mtbdd::Variable v) {
    if (v == options_.atoms) return Mtbdd::terminal(choice());
    const Mtbdd::Node low = diagram(v + 1);
    if (random_.below(3) == 0) return low;
    const Mtbdd::Node high = diagram(v + 1);
    return out_.diagram.make(v, low, high);
  }

  std::uint32_t choice() {
    std::vector<Branch> branches;
    if (random_.chance(options_.empty)) return Choices::none;
    for (std::size_t n = 1 + random_.below(options_.branches); n > 0; --n) {
      Branch branch{static_cast<std::uint32_t>(random_.below(options_.states)), {}};
      for (std::uint32_t mark = 0; mark < options_.sets; ++mark)
        if (random_.chance(options_.marked)) branch.marks = branch.marks | Marks::of(mark);
      branches.push_back(branch);
    }
    return out_.choices.intern(std::move(branches));
  }

  ltl::Random& random_;
  const RandomAutomaton& options_;
  TransitionRelation out_;
};

}  // namespace

Automaton random_automaton(ltl::Random& random, const ltl::Vocabulary& vocabulary, const RandomAutomaton& options) {
  if (options.states == 0 || options.branches == 0 || options.atoms > vocabulary.size() || options.sets > Marks::most)
    throw std::invalid_argument("random_automaton: no such automaton");
  std::vector<ltl::Proposition> reads;
  for (std::uint32_t p = 0; p < options.atoms; ++p) reads.push_back({p});
  return as_automaton(Maker(random, options).make(), vocabulary, reads);
}

}  // namespace waymark::automata

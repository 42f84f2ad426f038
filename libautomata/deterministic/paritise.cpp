#include "libautomata/deterministic/paritise.hpp"

#include <array>
#include <optional>
#include <utility>
#include <vector>

#include "libautomata/deterministic/alternating_cycles.hpp"
#include "libautomata/deterministic/colours.hpp"
#include "libautomata/graph/numbering.hpp"

namespace waymark::automata {
namespace {

using Node = Mtbdd::Node;

class Copies {
 public:
  Copies(const TransitionRelation& automaton, Budget& budget)
      : from_(automaton), budget_(budget), cycles_(automaton, budget), sets_(cycles_.colours() + 1) {}

  TransitionRelation run() {
    const std::vector<Node> roots = out_.diagram.import(
        from_.diagram, from_.roots, [](std::uint32_t c) { return Mtbdd::terminal(c); },
        [](Mtbdd::Variable v) { return v; });
    out_.acceptance = Acceptance::parity(Acceptance::Extreme::Min, Acceptance::Parity::Even, sets_);
    copy(from_.initial, cycles_.entry(from_.initial));
    for (std::size_t i = 0; i < copies_.size(); ++i) {  // the copies double as the queue
      const Copy at = copies_[i];
      const auto decide = [&](const std::array<Node, 1>& n) -> std::optional<Node> {
        budget_.step();
        if (!Mtbdd::is_terminal(n[0])) return std::nullopt;
        return Mtbdd::terminal(choice(at, from_.choices[Mtbdd::payload(n[0])]));
      };
      out_.roots.push_back(out_.diagram.apply(out_.diagram.operation(), std::array{roots[at.first]}, decide));
    }
    return std::move(out_);
  }

 private:
  using Copy = std::pair<std::uint32_t, AlternatingCycles::Node>;

  std::uint32_t choice(const Copy& at, std::span<const Branch> branches) {
    if (branches.empty()) return Choices::none;
    const Branch& b = branches.front();
    const AlternatingCycles::Transition step = cycles_.step(at.first, at.second, b);
    const Marks marks = step.colour == AlternatingCycles::no_colour ? Marks() : mark_of(step.colour, sets_);
    return out_.choices.intern({{copy(b.target, step.node), marks}});
  }
  std::uint32_t copy(std::uint32_t q, AlternatingCycles::Node node) { return copies_.of({q, node}, budget_); }

  const TransitionRelation& from_;
  Budget& budget_;
  AlternatingCycles cycles_;
  std::uint32_t sets_;
  TransitionRelation out_;
  Numbering<Copy> copies_;
};

}  // namespace

TransitionRelation paritise(const TransitionRelation& automaton, Budget& budget) {
  return Copies(automaton, budget).run();
}

}  // namespace waymark::automata

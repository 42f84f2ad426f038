#include "libautomata/deterministic/paritise.hpp"

#include <array>
#include <optional>
#include <utility>
#include <vector>

#include "libautomata/deterministic/alternating_cycles.hpp"
#include "libautomata/deterministic/colours.hpp"
#include "libautomata/numbering.hpp"

namespace waymark::automata {
namespace {

using Node = Mtbdd::Node;

class Copies {
 public:
  Copies(const Branching& automaton, Effort& effort)
      : from_(automaton), effort_(effort), cycles_(automaton, effort), sets_(cycles_.colours() + 1) {}

  Branching run() {
    const std::vector<Node> roots = out_.diagram.import(
        from_.diagram, from_.roots, [](std::uint32_t c) { return Mtbdd::terminal(c); },
        [](Mtbdd::Variable v) { return v; });
    out_.acceptance = Acceptance::parity(Acceptance::Extreme::Min, Acceptance::Parity::Even, sets_);
    copy(from_.initial, cycles_.entry(from_.initial));
    for (std::size_t i = 0; i < copies_.size(); ++i) {  // the copies double as the queue
      const Copy at = copies_[i];
      const auto decide = [&](const std::array<Node, 1>& n) -> std::optional<Node> {
        effort_.step();
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
    const AlternatingCycles::Step step = cycles_.step(at.first, at.second, b);
    const Marks marks = step.colour == AlternatingCycles::no_colour ? Marks() : mark_of(step.colour, sets_);
    return out_.choices.intern({{copy(b.target, step.node), marks}});
  }
  std::uint32_t copy(std::uint32_t q, AlternatingCycles::Node node) { return copies_.of({q, node}, effort_); }

  const Branching& from_;
  Effort& effort_;
  AlternatingCycles cycles_;
  std::uint32_t sets_;
  Branching out_;
  Numbering<Copy> copies_;
};

}  // namespace

Branching paritise(const Branching& automaton, Effort& effort) { return Copies(automaton, effort).run(); }

}  // namespace waymark::automata

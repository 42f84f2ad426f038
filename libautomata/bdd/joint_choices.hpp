// The successors of several states on one letter: decision diagrams whose terminals are tuples of choices.
#pragma once
#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "libautomata/bdd/mtbdd.hpp"
#include "libautomata/budget.hpp"

namespace waymark::automata {

// Tuples are interned as (all but the last, the last); the empty one is 0.
class JointChoices {
 public:
  using Node = Mtbdd::Node;
  JointChoices(Mtbdd& diagram, Budget& budget) : diagram_(diagram), budget_(budget), extend_(diagram.operation()) {}

  static Node empty() { return Mtbdd::terminal(0); }
  // The tuples of `before`, the choices of `root` after them. Both over the manager given.
  Node extended(Node before, Node root) {
    const auto decide = [&](const std::array<Node, 2>& n) -> std::optional<Node> {
      budget_.step();
      if (!Mtbdd::is_terminal(n[0]) || !Mtbdd::is_terminal(n[1])) return std::nullopt;
      return Mtbdd::terminal(intern(Mtbdd::payload(n[0]), Mtbdd::payload(n[1])));
    };
    return diagram_.apply(extend_, std::array{before, root}, decide);
  }
  void read(std::uint32_t tuple, std::span<std::uint32_t> choices) const {
    for (std::size_t i = choices.size(); i-- > 0; tuple = tuples_[tuple].first) choices[i] = tuples_[tuple].second;
  }
  // A diagram of tuples with each one replaced by the payload that `settle` gives for it.
  template <class Settle>
  Node settled(Node tuples, const Settle& settle) {
    const auto decide = [&](const std::array<Node, 1>& n) -> std::optional<Node> {
      budget_.step();
      if (!Mtbdd::is_terminal(n[0])) return std::nullopt;
      return Mtbdd::terminal(settle(Mtbdd::payload(n[0])));
    };
    return diagram_.apply(diagram_.operation(), std::array{tuples}, decide);
  }

 private:
  std::uint32_t intern(std::uint32_t before, std::uint32_t choice) {
    const auto [at, fresh] = number_.try_emplace({before, choice}, static_cast<std::uint32_t>(tuples_.size()));
    if (fresh) tuples_.emplace_back(before, choice);
    return at->second;
  }

  Mtbdd& diagram_;
  Budget& budget_;
  Mtbdd::Operation extend_;
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> number_;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> tuples_{{0, 0}};
};

}  // namespace waymark::automata

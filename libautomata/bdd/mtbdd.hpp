// Multi-terminal binary decision diagrams: functions from assignments of Boolean variables to 31-bit payloads.
//
// A manager owns its nodes. Managers share nothing, so each thread may use its own. Nodes are reduced and unique: equal
// functions over one manager are equal Nodes. A terminal is its payload with the top bit set and takes no storage.
// There is no reference count. collect() marks what the caller's roots reach and sweeps the rest in place; live nodes
// keep their ids, and other ids are reused. Tables are allocated at their first use; a copy under an injective map of
// terminals needs none. A Boolean function is a diagram with payloads 0 and 1. Source: [Bry86, Sec. 4], tables as in
// [BRB90], terminals as in [FMY97, Sec. 2].
#pragma once
#include <algorithm>
#include <array>
#include <cassert>
#include <compare>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "libautomata/bdd/computed_table.hpp"

namespace waymark::automata {

class Mtbdd {
 public:
  using Variable = std::uint32_t;                      // smaller variables stand nearer to the root
  static constexpr Variable no_variable = UINT32_MAX;  // of a terminal
  static constexpr Variable max_variables = 16'384;    // recursion is as deep as a path is long

  struct Node {                       // a handle of this manager
    std::uint32_t id = terminal_bit;  // its number, or a terminal's payload with the highest bit set
    friend auto operator<=>(const Node&, const Node&) = default;
  };
  // Names a function of N payloads for the cache: results under one tag are remembered from call to call.
  struct Operation {
    std::uint32_t tag = 0;  // keys of the cache
  };

  static Node terminal(std::uint32_t payload) {  // the constant function
    assert(payload < terminal_bit);
    return Node{payload | terminal_bit};
  }
  static bool is_terminal(Node n) { return (n.id & terminal_bit) != 0; }  // no decision
  static std::uint32_t payload(Node n) { return n.id & ~terminal_bit; }   // of a terminal
  // That a node decides, or no_variable.
  Variable variable(Node n) const { return is_terminal(n) ? no_variable : nodes_[n.id].variable; }
  Node low(Node n) const { return nodes_[n.id].low; }          // of a decision node: the variable is false
  Node high(Node n) const { return nodes_[n.id].high; }        // … true
  std::size_t size() const { return nodes_.size(); }           // ids are smaller
  std::size_t live() const { return nodes_.size() - swept_; }  // decision nodes, reachable or not

  // if variable then high else low; `low` itself when both are one. The variable stands above those of both. O(1).
  Node make(Variable variable, Node low, Node high);
  // … where the caller knows that there is no such node yet and that low ≠ high: the images of different nodes under a
  // map that is one to one on their terminals are different. O(1), without a look at the unique table.
  Node append(Variable variable, Node low, Node high);
  void reserve(std::size_t nodes) { nodes_.reserve(nodes); }

  Operation operation() { return Operation{++operations_}; }  // a key that no other operation has

  // The function that decide() computes point by point. decide(args) is asked on the way down and answers as soon as
  // the arguments determine the result (always, when all are terminals). O(∏ |args|) calls, fewer by the cache.
  template <std::size_t N, class Decide>
  Node apply(Operation op, const std::array<Node, N>& args, Decide& decide);

  // The terminal reached under an assignment, a functor Variable → bool. O(variables).
  template <class Assignment>
  Node evaluate(Node n, const Assignment& assignment) const {
    while (!is_terminal(n)) n = assignment(nodes_[n.id].variable) ? nodes_[n.id].high : nodes_[n.id].low;
    return n;
  }

  // Decision nodes that the roots reach, children before parents. O(size()).
  std::vector<Node> reachable(std::span<const Node> roots) const;

  // Gives up all nodes that the roots do not reach. O(size()). Whoever remembers things by id forgets those of others.
  void collect(std::span<const Node> roots);

  // Copies the diagrams of another manager here: leaf maps a payload to a Node whose variables lie below all renamed
  // ones (a terminal, usually), rename maps variables and keeps their order. O(from.size()). StayApart: both are one to
  // one and nothing is here yet.
  enum class Images : std::uint8_t { MayMeet, StayApart };
  template <class Leaf, class Rename>
  std::vector<Node> import(const Mtbdd& from, std::span<const Node> roots, const Leaf& leaf, const Rename& rename,
                           Images images = Images::MayMeet);

 private:
  static constexpr std::uint32_t terminal_bit = 0x8000'0000;
  struct Decision {
    Variable variable;
    Node low, high;
  };
  std::vector<Node> reachable_by_id(std::span<const Node> roots) const;
  bool is_swept(std::uint32_t id) const { return nodes_[id].variable == no_variable; }
  void index();  // all nodes, with room for as many again

  static constexpr std::uint32_t none = UINT32_MAX;

  std::vector<Decision> nodes_;
  std::uint32_t free_ = none;  // a swept slot; the next one is its low. Smaller ids first
  std::size_t swept_ = 0;
  bool refilled_ = false;             // some swept slot was used again: children may have larger ids than parents
  std::vector<std::uint32_t> table_;  // open-addressed over node ids + 1, 0 is free; a power of two, or empty
  std::size_t indexed_ = 0;           // nodes in the table: all, unless some were appended or it was dropped
  ComputedTable results_;
  std::uint32_t operations_ = 0;
};

template <std::size_t N, class Decide>
Mtbdd::Node Mtbdd::apply(Operation op, const std::array<Node, N>& args, Decide& decide) {
  static_assert(N >= 1 && N <= 3);
  if (const std::optional<Node> known = decide(args)) return *known;
  ComputedTable::Arguments key{};
  for (std::size_t i = 0; i < N; ++i) key[i] = args[i].id;
  if (const std::uint32_t* result = results_.find(op.tag, key)) return Node{*result};

  Variable top = no_variable;
  for (Node n : args) top = std::min(top, variable(n));
  assert(top != no_variable);  // decide() must answer for terminals
  std::array<Node, N> lows = args, highs = args;
  for (std::size_t i = 0; i < N; ++i) {
    if (variable(args[i]) != top) continue;
    lows[i] = low(args[i]);
    highs[i] = high(args[i]);
  }
  const Node on_low = apply(op, lows, decide);
  const Node on_high = apply(op, highs, decide);
  const Node result = make(top, on_low, on_high);
  results_.store(op.tag, key, result.id, live());
  return result;
}

template <class Leaf, class Rename>
std::vector<Mtbdd::Node> Mtbdd::import(const Mtbdd& from, std::span<const Node> roots, const Leaf& leaf,
                                       const Rename& rename, Images images) {
  assert(images == Images::MayMeet || size() == 0);
  std::vector<Node> copy(from.size());
  const auto image = [&](Node n) { return is_terminal(n) ? leaf(payload(n)) : copy[n.id]; };
  for (Node n : from.reachable(roots)) {
    const Variable variable = rename(from.variable(n));
    const Node low = image(from.low(n)), high = image(from.high(n));
    copy[n.id] = images == Images::StayApart ? append(variable, low, high) : make(variable, low, high);
  }
  std::vector<Node> out;
  out.reserve(roots.size());
  for (Node root : roots) out.push_back(image(root));
  return out;
}

}  // namespace waymark::automata

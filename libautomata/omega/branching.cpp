#include "libautomata/omega/branching.hpp"

#include <algorithm>
#include <tuple>
#include <unordered_set>

namespace waymark::automata {
namespace {

using Node = Mtbdd::Node;
constexpr std::uint32_t unseen = UINT32_MAX;

std::uint64_t hash_of(std::span<const Branch> branches) {
  std::uint64_t hash = branches.size();
  for (const Branch& b : branches) {
    hash = (hash ^ b.target) * 0x9E37'79B9'7F4A'7C15ULL;
    hash = (hash ^ (hash >> 32U) ^ b.marks.bits()) * 0xBF58'476D'1CE4'E5B9ULL;
    hash ^= hash >> 29U;
  }
  return hash;
}

// The terminals below a root in order of first appearance.
template <class Visit>
void for_each_choice(const Mtbdd& diagram, Node root, const Visit& visit) {
  std::unordered_set<std::uint32_t> seen;  // ids of nodes and terminals
  std::vector<Node> stack{root};
  while (!stack.empty()) {
    const Node n = stack.back();
    stack.pop_back();
    if (!seen.insert(n.id).second) continue;
    if (Mtbdd::is_terminal(n)) {
      visit(Mtbdd::payload(n));
    } else {
      stack.push_back(diagram.high(n));
      stack.push_back(diagram.low(n));
    }
  }
}

// Copies one root into another manager, the low side first; `leaf` maps ids of choices.
template <class Leaf>
class Copier {
 public:
  Copier(const Mtbdd& from, Mtbdd& to, const Leaf& leaf) : from_(from), to_(to), leaf_(leaf) {}
  Node copy(Node n) {
    if (const auto known = image_.find(n.id); known != image_.end()) return known->second;
    Node image;
    if (Mtbdd::is_terminal(n)) {
      image = Mtbdd::terminal(leaf_(Mtbdd::payload(n)));
    } else {
      const Node low = copy(from_.low(n)), high = copy(from_.high(n));
      image = to_.make(from_.variable(n), low, high);
    }
    image_.emplace(n.id, image);
    return image;
  }

 private:
  const Mtbdd& from_;
  Mtbdd& to_;
  const Leaf& leaf_;
  std::unordered_map<std::uint32_t, Node> image_;
};

}  // namespace

Choices::Choices() : begin_{0} { intern({}); }

std::uint32_t Choices::intern(std::vector<Branch> branches) {
  std::sort(branches.begin(), branches.end());
  branches.erase(std::unique(branches.begin(), branches.end()), branches.end());
  const std::uint64_t hash = hash_of(branches);
  const auto [first, last] = by_hash_.equal_range(hash);
  for (auto it = first; it != last; ++it) {
    const std::span<const Branch> known = (*this)[it->second];
    if (std::equal(known.begin(), known.end(), branches.begin(), branches.end())) return it->second;
  }
  const auto id = static_cast<std::uint32_t>(size());
  branches_.insert(branches_.end(), branches.begin(), branches.end());
  begin_.push_back(branches_.size());
  by_hash_.emplace(hash, id);
  return id;
}

std::vector<std::uint32_t> choices_of(const Branching& automaton, std::uint32_t q) {
  std::vector<std::uint32_t> out;
  for_each_choice(automaton.diagram, automaton.roots[q], [&](std::uint32_t c) { out.push_back(c); });
  return out;
}

std::vector<Branch> branches_of(const Branching& automaton, std::uint32_t q) {
  std::vector<Branch> out;
  for_each_choice(automaton.diagram, automaton.roots[q], [&](std::uint32_t c) {
    const auto choice = automaton.choices[c];
    out.insert(out.end(), choice.begin(), choice.end());
  });
  std::sort(out.begin(), out.end());
  out.erase(std::unique(out.begin(), out.end()), out.end());
  return out;
}

std::size_t count_edges(const Branching& automaton) {
  std::size_t sum = 0;
  for (std::uint32_t q = 0; q < automaton.states(); ++q) sum += branches_of(automaton, q).size();
  return sum;
}

bool is_deterministic(const Branching& automaton) {
  for (std::uint32_t q = 0; q < automaton.states(); ++q)
    for (std::uint32_t c : choices_of(automaton, q))
      if (automaton.choices[c].size() > 1) return false;
  return true;
}

bool is_complete(const Branching& automaton) {
  for (std::uint32_t q = 0; q < automaton.states(); ++q)
    for (std::uint32_t c : choices_of(automaton, q))
      if (c == Choices::none) return false;
  return true;
}

Branching rebuild(const Branching& automaton, std::span<const std::uint32_t> kept,
                  const ChangeChoice& change) {
  Branching out;
  out.initial = automaton.initial;
  out.acceptance = automaton.acceptance;
  for (std::uint32_t q : kept) {
    const auto leaf = [&](std::uint32_t c) { return out.choices.intern(change(q, automaton.choices[c])); };
    out.roots.push_back(Copier(automaton.diagram, out.diagram, leaf).copy(automaton.roots[q]));
  }
  return out;
}

Branching canonical(const Branching& automaton) {
  std::vector<std::uint32_t> order{automaton.initial}, number(automaton.states(), unseen);
  number[automaton.initial] = 0;
  for (std::size_t i = 0; i < order.size(); ++i) {  // the order doubles as the queue
    for_each_choice(automaton.diagram, automaton.roots[order[i]], [&](std::uint32_t c) {
      const auto choice = automaton.choices[c];
      std::vector<Branch> fresh;
      for (const Branch& b : choice)
        if (number[b.target] == unseen) fresh.push_back(b);
      std::sort(fresh.begin(), fresh.end(), [](const Branch& a, const Branch& b) {
        return std::tie(a.marks, a.target) < std::tie(b.marks, b.target);
      });
      for (const Branch& b : fresh) {
        if (number[b.target] != unseen) continue;
        number[b.target] = static_cast<std::uint32_t>(order.size());
        order.push_back(b.target);
      }
    });
  }
  Branching out = rebuild(automaton, order, [&](std::uint32_t, std::span<const Branch> choice) {
    std::vector<Branch> branches(choice.begin(), choice.end());
    for (Branch& b : branches) b.target = number[b.target];
    return branches;
  });
  out.initial = 0;
  return out;
}

}  // namespace waymark::automata

#include "libautomata/omega/transition_relation.hpp"

#include <algorithm>
#include <tuple>
#include <utility>

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

}  // namespace

Choices::Choices() : begin_{0, 0}, hashes_{0}, table_(16, 0) {}

std::uint32_t Choices::intern(std::vector<Branch> branches) {
  if (branches.size() > 1) {
    std::sort(branches.begin(), branches.end());
    branches.erase(std::unique(branches.begin(), branches.end()), branches.end());
  }
  return intern_sorted(branches);
}

std::uint32_t Choices::intern_sorted(std::span<const Branch> branches) {
  if (branches.empty()) return none;  // which the table does not have
  const std::uint64_t hash = hash_of(branches);
  if (2 * (size() + 1) > table_.size()) grow();
  std::size_t at = hash & (table_.size() - 1);
  for (; table_[at] != 0; at = (at + 1) & (table_.size() - 1)) {
    const std::uint32_t id = table_[at] - 1;
    if (hashes_[id] != hash) continue;
    const std::span<const Branch> known = (*this)[id];
    if (std::equal(known.begin(), known.end(), branches.begin(), branches.end())) return id;
  }
  const auto id = static_cast<std::uint32_t>(size());
  branches_.insert(branches_.end(), branches.begin(), branches.end());
  begin_.push_back(branches_.size());
  hashes_.push_back(hash);
  table_[at] = id + 1;
  return id;
}

void Choices::grow() {
  std::vector<std::uint32_t> larger(2 * table_.size(), 0);
  for (std::uint32_t id = none + 1; id < size(); ++id) {
    std::size_t at = hashes_[id] & (larger.size() - 1);
    while (larger[at] != 0) at = (at + 1) & (larger.size() - 1);
    larger[at] = id + 1;
  }
  table_ = std::move(larger);
}

ChoiceLists::ChoiceLists(const TransitionRelation& automaton)
    : automaton_(automaton), node_seen_(automaton.diagram.size(), 0), choice_seen_(automaton.choices.size(), 0) {}

std::span<const std::uint32_t> ChoiceLists::of(std::uint32_t q) {
  ++round_;
  found_.clear();
  stack_.assign(1, automaton_.roots[q]);
  while (!stack_.empty()) {
    const Node n = stack_.back();
    stack_.pop_back();
    std::uint32_t& seen = Mtbdd::is_terminal(n) ? choice_seen_[Mtbdd::payload(n)] : node_seen_[n.id];
    if (seen == round_) continue;
    seen = round_;
    if (Mtbdd::is_terminal(n)) {
      found_.push_back(Mtbdd::payload(n));
    } else {
      stack_.push_back(automaton_.diagram.high(n));
      stack_.push_back(automaton_.diagram.low(n));
    }
  }
  return found_;
}

std::vector<Branch> ChoiceLists::branches(std::uint32_t q) {
  std::vector<Branch> out;
  for (std::uint32_t c : of(q)) {
    const auto choice = automaton_.choices[c];
    out.insert(out.end(), choice.begin(), choice.end());
  }
  std::sort(out.begin(), out.end());
  out.erase(std::unique(out.begin(), out.end()), out.end());
  return out;
}

std::vector<std::uint32_t> choices_of(const TransitionRelation& automaton, std::uint32_t q) {
  ChoiceLists lists(automaton);
  const auto found = lists.of(q);
  return {found.begin(), found.end()};
}

std::vector<Branch> branches_of(const TransitionRelation& automaton, std::uint32_t q) {
  return ChoiceLists(automaton).branches(q);
}

std::size_t count_edges(const TransitionRelation& automaton) {
  ChoiceLists lists(automaton);
  std::size_t sum = 0;
  for (std::uint32_t q = 0; q < automaton.states(); ++q) sum += lists.branches(q).size();
  return sum;
}

bool is_deterministic(const TransitionRelation& automaton) {
  ChoiceLists lists(automaton);
  for (std::uint32_t q = 0; q < automaton.states(); ++q)
    for (std::uint32_t c : lists.of(q))
      if (automaton.choices[c].size() > 1) return false;
  return true;
}

bool is_complete(const TransitionRelation& automaton) {
  ChoiceLists lists(automaton);
  for (std::uint32_t q = 0; q < automaton.states(); ++q)
    for (std::uint32_t c : lists.of(q))
      if (c == Choices::none) return false;
  return true;
}

TransitionRelation rebuild(const TransitionRelation& automaton, std::span<const std::uint32_t> kept,
                           const ChangeChoice& change) {
  TransitionRelation out;
  out.initial = automaton.initial;
  out.acceptance = automaton.acceptance;
  RootCopier copier(automaton, out);
  for (std::uint32_t q : kept) {
    const auto leaf = [&](std::uint32_t c) { return out.choices.intern(change(q, automaton.choices[c])); };
    out.roots.push_back(copier.copy(automaton.roots[q], leaf));
  }
  return out;
}

Mtbdd::Node unite(TransitionRelation& automaton, Mtbdd::Operation operation, Node f, Node g, Budget& budget) {
  const Node none = Mtbdd::terminal(Choices::none);
  const auto decide = [&](const std::array<Node, 2>& n) -> std::optional<Node> {
    budget.step();
    if (n[0] == none || n[0] == n[1]) return n[1];
    if (n[1] == none) return n[0];
    if (!Mtbdd::is_terminal(n[0]) || !Mtbdd::is_terminal(n[1])) return std::nullopt;
    const auto x = automaton.choices[Mtbdd::payload(n[0])], y = automaton.choices[Mtbdd::payload(n[1])];
    std::vector<Branch> both(x.begin(), x.end());
    both.insert(both.end(), y.begin(), y.end());
    return Mtbdd::terminal(automaton.choices.intern(std::move(both)));
  };
  return automaton.diagram.apply(operation, std::array{f, g}, decide);
}

// Nodes were made in the same order, so equal functions have equal ids.
bool identical(const TransitionRelation& a, const TransitionRelation& b) {
  if (a.states() != b.states() || a.initial != b.initial || a.acceptance != b.acceptance || a.roots != b.roots ||
      a.choices.size() != b.choices.size() || a.diagram.size() != b.diagram.size())
    return false;
  for (std::uint32_t c = 0; c < a.choices.size(); ++c)
    if (!std::equal(a.choices[c].begin(), a.choices[c].end(), b.choices[c].begin(), b.choices[c].end())) return false;
  for (std::uint32_t id = 0; id < a.diagram.size(); ++id) {
    const Node n{id};
    if (a.diagram.variable(n) != b.diagram.variable(n) || a.diagram.low(n) != b.diagram.low(n) ||
        a.diagram.high(n) != b.diagram.high(n))
      return false;
  }
  return true;
}

TransitionRelation canonical(const TransitionRelation& automaton) {
  std::vector<std::uint32_t> order{automaton.initial}, number(automaton.states(), unseen);
  number[automaton.initial] = 0;
  ChoiceLists lists(automaton);
  for (std::size_t i = 0; i < order.size(); ++i) {  // the order doubles as the queue
    for (std::uint32_t c : lists.of(order[i])) {
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
    }
  }
  TransitionRelation out = rebuild(automaton, order, [&](std::uint32_t, std::span<const Branch> choice) {
    std::vector<Branch> branches(choice.begin(), choice.end());
    for (Branch& b : branches) b.target = number[b.target];
    return branches;
  });
  out.initial = 0;
  return out;
}

}  // namespace waymark::automata

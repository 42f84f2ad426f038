#include "libautomata/omega/greatest_simulation.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <unordered_map>

#include "libautomata/omega/alphabet_classes.hpp"
#include "libltl/rewriting/pair_memo.hpp"
#include "libltl/structure/random.hpp"

namespace waymark::automata {
namespace {

using Node = Mtbdd::Node;

constexpr std::size_t few_kinds = 512;

// Each branch of the one has a better one among the others, as far as is known.
bool is_covered(std::span<const Branch> branches, std::span<const Branch> better, const StatePairs& below) {
  return std::all_of(branches.begin(), branches.end(), [&](const Branch& b) {
    return std::any_of(better.begin(), better.end(),
                       [&](const Branch& a) { return a.marks.includes(b.marks) && below(b.target, a.target); });
  });
}

class OnKinds {
 public:
  OnKinds(const AlphabetClasses& table, StatePairs& below, Budget& budget)
      : table_(table),
        below_(below),
        budget_(budget),
        choices_(table.choices.size()),
        known_(choices_ <= most_remembered ? choices_ * choices_ : 0, Coverage::Unknown) {}

  void run() {
    // States are numbered breadth first: with successors looked at before, one round goes along a whole chain. Of a
    // reversed automaton, the next round does.
    for (bool descending = true; round(descending); descending = !descending)
      for (Coverage& answer : known_)  // a "no" stays true
        if (answer == Coverage::Yes) answer = Coverage::Unknown;
  }

 private:
  enum class Coverage : std::uint8_t { Unknown, Yes, No };
  static constexpr std::size_t most_remembered = 512;  // choices: a quarter of a MiB

  bool round(bool descending) {
    bool changed = false;
    const auto states = static_cast<std::uint32_t>(table_.states);
    const auto state = [&](std::uint32_t i) { return descending ? states - 1 - i : i; };
    for (std::uint32_t i = 0; i < states; ++i) {
      budget_.step(table_.states / 4 + 1);
      const std::uint32_t q = state(i);
      for (std::uint32_t j = 0; j < states; ++j) {
        const std::uint32_t r = state(j);
        if (q == r || !below_(q, r) || is_below(table_.row(q), table_.row(r))) continue;
        below_.remove(q, r);
        changed = true;
      }
    }
    return changed;
  }
  bool is_below(std::span<const std::uint32_t> q, std::span<const std::uint32_t> r) {
    const auto fails_on = [&](std::size_t kind) { return q[kind] != r[kind] && !covered(q[kind], r[kind]); };
    if (fails_on(telling_)) return false;
    for (std::size_t kind = 0; kind < q.size(); ++kind)
      if (fails_on(kind)) {
        telling_ = kind;
        return false;
      }
    return true;
  }
  bool covered(std::uint32_t c, std::uint32_t d) {
    if (known_.empty()) return is_covered(table_.choices[c], table_.choices[d], below_);
    Coverage& known = known_[c * choices_ + d];
    if (known == Coverage::Unknown)
      known = is_covered(table_.choices[c], table_.choices[d], below_) ? Coverage::Yes : Coverage::No;
    return known == Coverage::Yes;
  }

  const AlphabetClasses& table_;
  StatePairs& below_;
  Budget& budget_;
  std::size_t choices_;
  std::size_t telling_ = 0;      // a kind that has just told two states apart is looked at first
  std::vector<Coverage> known_;  // [c · choices + d]: is c covered by d?
};

class OnDiagrams {
 public:
  OnDiagrams(const TransitionRelation& automaton, StatePairs& below, Budget& budget)
      : automaton_(automaton), below_(below), budget_(budget) {}

  void run() {
    if (automaton_.states() >= many_states) look_at_some_letters();
    while (round()) ++rounds_;
  }

 private:
  struct Coverage {
    std::uint32_t round = 0;  // when it was given; a "no" stays true, a "yes" only in its round
    bool yes = false;
  };

  static constexpr std::size_t many_states = 40;  // from here on most pairs are told apart by single letters
  static constexpr std::size_t letters = 32;

  // The greatest simulation on a few letters lies above the one on all of them: what it refutes need not be compared.
  void look_at_some_letters() {
    ltl::Random random(1);  // fixed; any letters will do
    std::vector<std::array<std::uint32_t, letters>> choice(automaton_.states());
    for (std::size_t i = 0; i < letters; ++i) {
      const std::uint64_t seed = random.below(UINT64_MAX);
      const auto letter = [&](Mtbdd::Variable v) {
        return (((seed ^ (v + 1) * 0x9E37'79B9'7F4A'7C15ULL) * 0xBF58'476D'1CE4'E5B9ULL) >> 63U) != 0;
      };
      for (std::uint32_t q = 0; q < choice.size(); ++q)
        choice[q][i] = Mtbdd::payload(automaton_.diagram.evaluate(automaton_.roots[q], letter));
    }
    for (bool changed = true; changed;) {
      changed = false;
      for (std::uint32_t q = 0; q < choice.size(); ++q) {
        budget_.step(choice.size());
        for (std::uint32_t r = 0; r < choice.size(); ++r)
          for (std::size_t i = 0; i < letters && q != r && below_(q, r); ++i)
            if (choice[q][i] != choice[r][i] && !covered(choice[q][i], choice[r][i])) {
              below_.remove(q, r);
              changed = true;
            }
      }
    }
  }

  bool round() {
    bool changed = false;
    for (std::uint32_t q = 0; q < automaton_.states(); ++q) {
      budget_.step(automaton_.states() / 16);
      for (std::uint32_t r = 0; r < automaton_.states(); ++r) {
        if (q == r || !below_(q, r) || compare(automaton_.roots[q], automaton_.roots[r])) continue;
        below_.remove(q, r);
        changed = true;
      }
    }
    return changed;
  }
  bool compare(Node x, Node y) {
    if (x == y) return true;
    if (const Coverage* known = known_.find(x.id, y.id))
      if (!known->yes || known->round == rounds_) return known->yes;
    budget_.step();
    const bool yes = look(x, y);
    known_.store(x.id, y.id, {rounds_, yes});
    return yes;
  }
  bool look(Node x, Node y) {
    if (Mtbdd::is_terminal(x) && Mtbdd::is_terminal(y)) return covered(Mtbdd::payload(x), Mtbdd::payload(y));
    const Mtbdd& diagram = automaton_.diagram;
    const Mtbdd::Variable top = std::min(diagram.variable(x), diagram.variable(y));
    const auto side = [&](Node n, bool high) {
      return diagram.variable(n) != top ? n : high ? diagram.high(n) : diagram.low(n);
    };
    return compare(side(x, false), side(y, false)) && compare(side(x, true), side(y, true));
  }
  bool covered(std::uint32_t c, std::uint32_t d) const {
    return is_covered(automaton_.choices[c], automaton_.choices[d], below_);
  }

  const TransitionRelation& automaton_;
  StatePairs& below_;
  Budget& budget_;
  ltl::PairMemo<Coverage> known_;
  std::uint32_t rounds_ = 0;
};

// δ⁻¹: the branches of q are (marks, p) for the branches (marks, q) of p.
class Reversal {
 public:
  Reversal(const TransitionRelation& automaton, Budget& budget) : from_(automaton), budget_(budget) {
    out_.roots.assign(automaton.states(), Mtbdd::terminal(Choices::none));
    out_.initial = automaton.initial;
    out_.acceptance = automaton.acceptance;
    union_ = out_.diagram.operation();
    for (std::uint32_t p = 0; p < automaton.states(); ++p) {
      known_.clear();
      for (const auto& [q, root] : into(p, automaton.roots[p]))
        out_.roots[q] = unite(out_, union_, out_.roots[q], root, budget_);
    }
  }
  TransitionRelation result() && { return std::move(out_); }

 private:
  using ByTarget = std::map<std::uint32_t, Node>;

  const ByTarget& into(std::uint32_t p, Node n) {
    if (const auto at = known_.find(n.id); at != known_.end()) return at->second;
    budget_.step();
    ByTarget out;
    if (Mtbdd::is_terminal(n)) {
      std::map<std::uint32_t, std::vector<Branch>> branches;
      for (const Branch& b : from_.choices[Mtbdd::payload(n)]) branches[b.target].push_back({p, b.marks});
      for (auto& [q, choice] : branches) out[q] = Mtbdd::terminal(out_.choices.intern(std::move(choice)));
    } else {
      const ByTarget low = into(p, from_.diagram.low(n)), high = into(p, from_.diagram.high(n));
      const auto side = [](const ByTarget& map, std::uint32_t q) {
        const auto at = map.find(q);
        return at == map.end() ? Mtbdd::terminal(Choices::none) : at->second;
      };
      const Mtbdd::Variable v = from_.diagram.variable(n);
      for (const auto& [q, root] : low) out[q] = out_.diagram.make(v, root, side(high, q));
      for (const auto& [q, root] : high)
        if (!low.contains(q)) out[q] = out_.diagram.make(v, Mtbdd::terminal(Choices::none), root);
    }
    return known_.emplace(n.id, std::move(out)).first->second;
  }
  const TransitionRelation& from_;
  Budget& budget_;
  TransitionRelation out_;
  Mtbdd::Operation union_;
  std::unordered_map<std::uint32_t, ByTarget> known_;
};

}  // namespace

StatePairs greatest_simulation(const TransitionRelation& automaton, Budget& budget, Comparison how) {
  StatePairs below(automaton.states(), true);
  if (const auto table = how == Comparison::Cheapest ? alphabet_classes(automaton, few_kinds, budget) : std::nullopt)
    OnKinds(*table, below, budget).run();
  else
    OnDiagrams(automaton, below, budget).run();
  return below;
}

StatePairs greatest_reverse_simulation(const TransitionRelation& automaton, Budget& budget, Comparison how) {
  StatePairs below(automaton.states(), true);
  for (std::uint32_t r = 0; r < automaton.states(); ++r)
    if (r != automaton.initial) below.remove(automaton.initial, r);
  if (const auto table = how == Comparison::Cheapest ? alphabet_classes(automaton, few_kinds, budget) : std::nullopt) {
    OnKinds(reversed(*table, budget), below, budget).run();
  } else {
    const TransitionRelation reverse = Reversal(automaton, budget).result();
    OnDiagrams(reverse, below, budget).run();
  }
  return below;
}

}  // namespace waymark::automata

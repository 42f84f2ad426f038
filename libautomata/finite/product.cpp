#include "libautomata/finite/product.hpp"

#include <algorithm>
#include <array>
#include <stdexcept>
#include <utility>

#include "libautomata/bdd/joined_alphabet.hpp"
#include "libautomata/finite/minimize.hpp"
#include "libautomata/finite/run.hpp"

namespace waymark::automata {
namespace {

using Node = Mtbdd::Node;

// What became of pairs of nodes: open-addressed, linear probing, twelve bytes an entry, nothing forgotten.
class PairTable {
 public:
  PairTable() : entries_(64) {}
  struct Place {
    std::size_t slot, slots;  // of so many
    Node result;              // `unknown`: the pair is new, and set() is to follow, after any other calls
  };
  Place find(Node p, Node q) {
    if (4 * used_ > 3 * entries_.size()) grow();
    const std::size_t at = slot(p, q);
    if (entries_[at].first != p || entries_[at].second != q) {
      entries_[at] = {p, q, unknown};
      ++used_;
    }
    return {at, entries_.size(), entries_[at].result};
  }
  void set(const Place& place, Node p, Node q, Node result) {
    entries_[place.slots == entries_.size() ? place.slot : slot(p, q)].result = result;
  }
  // The pair will be looked for soon.
  void expect(Node p, Node q) const { __builtin_prefetch(&entries_[first_slot(p, q)], 1); }
  // Terminals of payloads that no state has.
  static constexpr Node unknown{UINT32_MAX}, any{UINT32_MAX - 1};

 private:
  struct Entry {
    Node first = unknown, second = unknown, result = unknown;
  };
  std::size_t first_slot(Node p, Node q) const {
    std::uint64_t hash = (std::uint64_t{p.id} << 32U | q.id) * 0x9E37'79B9'7F4A'7C15ULL;
    hash = (hash ^ hash >> 32U) * 0xBF58'476D'1CE4'E5B9ULL;
    return (hash >> 24U) & (entries_.size() - 1);
  }
  std::size_t slot(Node p, Node q) const {  // of the pair, or free
    std::size_t at = first_slot(p, q);
    const auto other = [&](const Entry& e) { return e.first != unknown && (e.first != p || e.second != q); };
    while (other(entries_[at])) at = (at + 1) & (entries_.size() - 1);
    return at;
  }
  void grow() {
    std::vector<Entry> old(2 * entries_.size());
    old.swap(entries_);
    for (const Entry& e : old)
      if (e.first != unknown) entries_[slot(e.first, e.second)] = e;
  }

  std::vector<Entry> entries_;  // a power of two
  std::size_t used_ = 0;
};

// Different pairs of nodes are different functions into pairs of states, but pairs of states are merged: those of which
// one half settles the verdict for good, and those of the same diagrams and verdict. Over disjoint alphabets where no
// two states have the same diagram the pairs of nodes still differ: where two nodes of the first automaton do, some
// letter of the second does not settle the verdict. Then the results need no unique table.
class PairProduct {
 public:
  PairProduct(const Transitions& a, const Transitions& b, Verdict verdict, Budget& budget, Alphabets alphabets)
      : first_(a),
        second_(b),
        verdict_(verdict),
        budget_(budget),
        settles_first_(settling_state(a, verdict, true)),
        settles_second_(settling_state(b, verdict, false)),
        merges_(alphabets == Alphabets::Any) {}

  Transitions run() && {
    out_.initial = Mtbdd::payload(pair(Mtbdd::terminal(first_.initial), Mtbdd::terminal(second_.initial)));
    for (std::size_t i = 0; i < pairs_.size(); ++i) {
      const auto [p, q] = pairs_[i];
      const Node root = i == settled_ ? Mtbdd::terminal(*settled_) : pair(first_.roots[p], second_.roots[q]);
      out_.roots.push_back(root);
      out_.accepting.push_back(verdict_(first_.accepting[p], second_.accepting[q]));
    }
    return std::move(out_);
  }

 private:
  static bool is(Node n, std::optional<std::uint32_t> q) { return q && n == Mtbdd::terminal(*q); }

  Node pair(Node p, Node q) {
    budget_.step();
    if (is(p, settles_first_) || is(q, settles_second_)) return settled(p, q);
    const PairTable::Place place = made_.find(p, q);
    if (place.result != PairTable::unknown) return place.result;
    const Node made =
        Mtbdd::is_terminal(p) && Mtbdd::is_terminal(q) ? merged(Mtbdd::payload(p), Mtbdd::payload(q)) : decision(p, q);
    made_.set(place, p, q, made);
    return made;
  }

  Node decision(Node p, Node q) {
    const Mtbdd &a = first_.diagram, &b = second_.diagram;
    const Mtbdd::Variable of_p = a.variable(p), of_q = b.variable(q), top = std::min(of_p, of_q);
    const Node high_p = of_p == top ? a.high(p) : p, high_q = of_q == top ? b.high(q) : q;
    made_.expect(high_p, high_q);
    const Node low = pair(of_p == top ? a.low(p) : p, of_q == top ? b.low(q) : q);
    const Node high = pair(high_p, high_q);
    return merges_ ? out_.diagram.make(top, low, high) : out_.diagram.append(top, low, high);
  }

  Node merged(std::uint32_t p, std::uint32_t q) {
    if (!merges_) return state(p, q);
    const bool accepts = verdict_(first_.accepting[p], second_.accepting[q]);
    Node left = first_.roots[p], right = second_.roots[q];
    if (is(left, settles_first_) || is(right, settles_second_)) {  // settled from the next letter on
      if (accepts == verdict_when_settled()) return settled(left, right);
      left = right = PairTable::any;
    }
    PairTable& known = by_roots_[accepts ? 1 : 0];
    const PairTable::Place place = known.find(left, right);
    if (place.result != PairTable::unknown) return place.result;
    const Node made = state(p, q);
    known.set(place, left, right, made);
    return made;
  }

  Node state(std::uint32_t p, std::uint32_t q) {
    budget_.state();
    pairs_.emplace_back(p, q);
    return Mtbdd::terminal(static_cast<std::uint32_t>(pairs_.size() - 1));
  }

  Node settled(Node p, Node q) {
    if (!settled_) {  // the other half does not matter
      const std::uint32_t first = is(p, settles_first_) ? Mtbdd::payload(p) : first_.initial;
      const std::uint32_t second = is(q, settles_second_) ? Mtbdd::payload(q) : second_.initial;
      settled_ = Mtbdd::payload(state(first, second));
    }
    return Mtbdd::terminal(*settled_);
  }
  bool verdict_when_settled() const {
    return settles_first_ ? verdict_(first_.accepting[*settles_first_], false)
                          : verdict_(false, second_.accepting[*settles_second_]);
  }

  const Transitions& first_;
  const Transitions& second_;
  Verdict verdict_;
  Budget& budget_;
  std::optional<std::uint32_t> settles_first_, settles_second_;
  std::optional<std::uint32_t> settled_;  // the state of all pairs in which one half settles the verdict
  bool merges_;                           // two pairs of nodes may be one function
  PairTable made_;
  std::array<PairTable, 2> by_roots_;  // pairs of states by their diagrams, rejecting and accepting ones
  std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs_;
  Transitions out_;
};

Transitions over(const Dfa& dfa, const std::vector<Mtbdd::Variable>& name) {
  Transitions out;
  std::vector<Node> roots;
  for (std::uint32_t q = 0; q < dfa.states(); ++q) {
    roots.push_back(dfa.root(StateId{q}));
    out.accepting.push_back(dfa.is_accepting(StateId{q}));
  }
  out.roots = renamed(dfa.diagram(), roots, name, out.diagram);
  out.initial = dfa.initial().index;
  return out;
}

}  // namespace

std::optional<std::uint32_t> settling_state(const Transitions& automaton, Verdict verdict, bool first) {
  for (std::uint32_t q = 0; q < automaton.roots.size(); ++q) {
    const bool accepts = automaton.accepting[q];
    const bool settles =
        first ? verdict(accepts, false) == verdict(accepts, true) : verdict(false, accepts) == verdict(true, accepts);
    if (automaton.roots[q] == Mtbdd::terminal(q) && settles) return q;
  }
  return std::nullopt;
}

Transitions product(const Transitions& a, const Transitions& b, Verdict verdict, Budget& budget, Alphabets alphabets) {
  return PairProduct(a, b, verdict, budget, alphabets).run();
}

Dfa product(const Dfa& a, const Dfa& b, Verdict verdict, Budget& budget) {
  if (verdict(false, false)) throw std::invalid_argument("a product of DFAs may not accept the empty word");
  const JoinedAlphabet both = joined({a.vocabulary(), a.reads()}, {b.vocabulary(), b.reads()});
  const Transitions pairs = product(over(a, both.of_first), over(b, both.of_second), verdict, budget);
  return as_dfa(canonical(pairs, budget), both.vocabulary, both.reads);
}

std::optional<Difference> difference(const Dfa& a, const Dfa& b, Budget& budget) {
  const Dfa either = product(
      a, b, [](bool p, bool q) { return p != q; }, budget);
  std::optional<ltl::Trace> word = shortest_word(either);
  if (!word) return std::nullopt;
  const Dfa only_first = product(
      a, b, [](bool p, bool q) { return p && !q; }, budget);
  const bool first_accepts = accepts(only_first, *word);
  return Difference{either.vocabulary(), *std::move(word), first_accepts};
}

}  // namespace waymark::automata

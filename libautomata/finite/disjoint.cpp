#include "libautomata/finite/disjoint.hpp"

#include <algorithm>
#include <optional>
#include <span>
#include <unordered_map>
#include <unordered_set>

namespace waymark::automata {
namespace {

using Node = Mtbdd::Node;

constexpr int most_lengths = 48;
constexpr std::size_t most_states = UINT32_MAX / 2;
constexpr std::uint32_t none = 0,
                        all = 1;  // the classes of states that accept no word of the length, or every one

bool comes_back(const Transitions& automaton) {
  const auto is_initial = [&](Node n) { return n == Mtbdd::terminal(automaton.initial); };
  for (const Node root : automaton.roots)
    if (is_initial(root)) return true;
  for (const Node n : automaton.diagram.reachable(automaton.roots))
    if (is_initial(automaton.diagram.low(n)) || is_initial(automaton.diagram.high(n))) return true;
  return false;
}

// The diagrams of the states over classes of states.
std::vector<Node> over_classes(const Transitions& automaton, const std::vector<std::uint32_t>& class_of,
                               Mtbdd& images) {
  return images.import(
      automaton.diagram, automaton.roots, [&](std::uint32_t q) { return Mtbdd::terminal(class_of[q]); },
      [](Mtbdd::Variable v) { return v; });
}

// The classes of the states one letter later: which states accept the same words of one length more.
std::vector<std::uint32_t> longer(const Transitions& automaton, const std::vector<std::uint32_t>& class_of) {
  Mtbdd images;
  std::unordered_map<std::uint32_t, std::uint32_t> names{{Mtbdd::terminal(none).id, none},
                                                         {Mtbdd::terminal(all).id, all}};
  std::vector<std::uint32_t> out;
  for (const Node root : over_classes(automaton, class_of, images))
    out.push_back(names.try_emplace(root.id, static_cast<std::uint32_t>(names.size())).first->second);
  return out;
}

// From the first letter on, whatever it is.
bool accepts_every(const Transitions& automaton, std::uint32_t q, bool word) {
  const Node root = automaton.roots[q];
  return Mtbdd::is_terminal(root) && automaton.roots[Mtbdd::payload(root)] == root &&
         automaton.accepting[Mtbdd::payload(root)] == word;
}

// The states that some word comes to, the empty one aside.
std::vector<std::uint32_t> later_states(const Transitions& automaton, bool initial_too) {
  std::vector<std::uint32_t> out;
  for (std::uint32_t q = 0; q < automaton.roots.size(); ++q)
    if (initial_too || q != automaton.initial) out.push_back(q);
  return out;
}

// One state for each diagram that occurs.
std::vector<std::uint32_t> one_by_root(const Transitions& automaton, const std::vector<std::uint32_t>& states) {
  std::unordered_set<std::uint32_t> roots;
  std::vector<std::uint32_t> out;
  for (const std::uint32_t q : states)
    if (roots.insert(automaton.roots[q].id).second) out.push_back(q);
  return out;
}

// Are the diagrams still different when states are known by their diagrams alone? Then states told apart by words of
// one length are told apart by longer ones.
bool stay_apart(const Transitions& automaton, const std::vector<std::uint32_t>& states) {
  std::unordered_map<std::uint32_t, std::uint32_t> names;
  std::vector<std::uint32_t> class_of;
  for (const Node root : automaton.roots)
    class_of.push_back(names.try_emplace(root.id, static_cast<std::uint32_t>(names.size())).first->second);
  Mtbdd images;
  const std::vector<Node> image = over_classes(automaton, class_of, images);
  std::unordered_set<std::uint32_t> seen;
  return std::all_of(states.begin(), states.end(), [&](std::uint32_t q) { return seen.insert(image[q].id).second; });
}

bool told_apart(const Transitions& automaton, const std::vector<std::uint32_t>& states, Budget& budget) {
  if (!stay_apart(automaton, states)) return false;
  std::vector<std::uint32_t> class_of;
  for (const bool accepting : automaton.accepting) class_of.push_back(accepting ? all : none);
  for (int n = 1; n <= most_lengths; ++n) {
    budget.step(automaton.diagram.size());
    class_of = longer(automaton, class_of);
    std::unordered_set<std::uint32_t> seen;
    const auto alone = [&](std::uint32_t q) {
      if (class_of[q] == none && !accepts_every(automaton, q, false)) return false;
      if (class_of[q] == all && !accepts_every(automaton, q, true)) return false;
      return seen.insert(class_of[q]).second;
    };
    if (std::all_of(states.begin(), states.end(), alone)) return true;
  }
  return false;
}

// The states one letter after some of `from`.
std::vector<bool> after(const Transitions& automaton, const std::vector<bool>& from) {
  std::vector<Node> roots;
  for (std::uint32_t q = 0; q < from.size(); ++q)
    if (from[q]) roots.push_back(automaton.roots[q]);
  std::vector<bool> out(from.size(), false);
  const auto mark = [&](Node n) {
    if (Mtbdd::is_terminal(n)) out[Mtbdd::payload(n)] = true;
  };
  for (const Node root : roots) mark(root);
  for (const Node n : automaton.diagram.reachable(roots)) {
    mark(automaton.diagram.low(n));
    mark(automaton.diagram.high(n));
  }
  return out;
}

bool all_reached(const Transitions& automaton, const std::vector<std::uint32_t>& states, Budget& budget) {
  std::vector<bool> wanted(automaton.roots.size(), false), here = wanted;
  for (const std::uint32_t q : states) wanted[q] = true;
  if (after(automaton, wanted) != wanted) return false;  // then what is reached once is reached from there on
  here[automaton.initial] = true;
  for (int n = 0; n < most_lengths; ++n) {
    budget.step(automaton.diagram.size());
    here = after(automaton, here);
    if (here == wanted) return true;
  }
  return false;
}

// The pairs as states: one for each two that do not settle the verdict, one for all others, and the initial one where
// no word comes back to it.
class AllPairs {
 public:
  AllPairs(const Transitions& first, const Transitions& second, Verdict verdict, Budget& budget)
      : first_(first),
        second_(second),
        verdict_(verdict),
        budget_(budget),
        settles_first_(settling_state(first, verdict, true)),
        settles_second_(settling_state(second, verdict, false)),
        back_first_(comes_back(first)),
        back_second_(comes_back(second)),
        later_first_(later_states(first, back_first_)),
        later_second_(later_states(second, back_second_)) {}

  Transitions run() && {
    number_states();
    copy_second();
    copy_first();
    return std::move(out_);
  }

 private:
  std::uint32_t& number(std::uint32_t p, std::uint32_t q) { return number_[p * second_.roots.size() + q]; }
  bool settles(std::uint32_t p, std::uint32_t q) const { return p == settles_first_ || q == settles_second_; }

  void number_states() {
    const std::size_t pairs = later_first_.size() * later_second_.size() + 1;
    if (pairs >= most_states) throw Budget::Exceeded{Budget::Exceeded::Reason::States};
    for (std::size_t i = 0; i < pairs; ++i) budget_.state();
    budget_.step(pairs);
    number_.resize(first_.roots.size() * second_.roots.size());
    for (const std::uint32_t p : later_first_)
      for (const std::uint32_t q : later_second_) number(p, q) = settles(p, q) && settled_ ? *settled_ : add(p, q);
    if (!back_first_ || !back_second_) number(first_.initial, second_.initial) = add(first_.initial, second_.initial);
    out_.initial = number(first_.initial, second_.initial);
    out_.roots.resize(out_.accepting.size());
    if (settled_) out_.roots[*settled_] = Mtbdd::terminal(*settled_);
  }
  std::uint32_t add(std::uint32_t p, std::uint32_t q) {
    const auto state = static_cast<std::uint32_t>(out_.accepting.size());
    out_.accepting.push_back(verdict_(first_.accepting[p], second_.accepting[q]));
    if (settles(p, q) && !settled_) settled_ = state;
    return state;
  }

  // The second automaton's diagrams with leaves (p, ·), for each p.
  void copy_second() {
    const Mtbdd& diagram = second_.diagram;
    const std::vector<Node> nodes = diagram.reachable(second_.roots);
    std::unordered_map<std::uint32_t, std::uint32_t> known;
    for (const Node root : second_.roots) {
      root_of_.push_back(known.try_emplace(root.id, static_cast<std::uint32_t>(roots_.size())).first->second);
      if (root_of_.back() == roots_.size()) roots_.push_back(root);
    }
    below_.resize(first_.roots.size() * roots_.size());
    std::vector<Node> image(diagram.size());
    for (const std::uint32_t p : later_first_) {
      const auto of = [&](Node n) {
        return Mtbdd::is_terminal(n) ? Mtbdd::terminal(number(p, Mtbdd::payload(n))) : image[n.id];
      };
      if (p != settles_first_) copy(diagram, nodes, of, image);
      for (std::size_t r = 0; r < roots_.size(); ++r)
        below_[p * roots_.size() + r] = p == settles_first_ ? Mtbdd::terminal(*settled_) : of(roots_[r]);
    }
  }

  // The first automaton's diagrams with these copies as leaves, for each root of the second.
  void copy_first() {
    std::vector<Node> roots;
    for (const std::uint32_t p : later_first_) roots.push_back(first_.roots[p]);
    const std::vector<Node> later = first_.diagram.reachable(roots);
    roots.push_back(first_.roots[first_.initial]);
    const std::vector<Node> from_initial = first_.diagram.reachable(std::span(roots).last(1)),
                            any = first_.diagram.reachable(roots);
    std::vector<std::vector<std::uint32_t>> states(roots_.size());  // of the second, by root
    for (const std::uint32_t q : later_second_) states[root_of_[q]].push_back(q);
    for (std::size_t r = 0; r < roots_.size(); ++r) {
      const bool initial = root_of_[second_.initial] == r;
      copy_first_above(r, !initial ? later : states[r].empty() ? from_initial : any, states[r], initial);
    }
  }
  void copy_first_above(std::size_t r, const std::vector<Node>& nodes, const std::vector<std::uint32_t>& states,
                        bool initial) {
    std::vector<Node> image(first_.diagram.size());
    const bool settled = settles_second_ && roots_[r] == Mtbdd::terminal(*settles_second_);  // all leaves are one
    const auto of = [&](Node n) {
      if (settled) return Mtbdd::terminal(*settled_);
      return Mtbdd::is_terminal(n) ? below_[Mtbdd::payload(n) * roots_.size() + r] : image[n.id];
    };
    if (!settled) copy(first_.diagram, nodes, of, image);
    for (const std::uint32_t q : states)
      for (const std::uint32_t p : later_first_)
        if (!settles(p, q)) out_.roots[number(p, q)] = of(first_.roots[p]);
    if (initial) out_.roots[out_.initial] = of(first_.roots[first_.initial]);
  }

  template <class Of>
  void copy(const Mtbdd& from, const std::vector<Node>& nodes, const Of& of, std::vector<Node>& image) {
    budget_.step(nodes.size());
    for (const Node n : nodes) {
      const Node low = of(from.low(n)), high = of(from.high(n));
      image[n.id] = out_.diagram.append(from.variable(n), low, high);
    }
  }

  const Transitions& first_;
  const Transitions& second_;
  Verdict verdict_;
  Budget& budget_;
  std::optional<std::uint32_t> settles_first_, settles_second_, settled_;  // the last: a pair
  bool back_first_, back_second_;
  std::vector<std::uint32_t> later_first_, later_second_;
  std::vector<std::uint32_t> number_;   // by p, q: the pair as a state
  std::vector<Node> roots_;             // of the second, each once
  std::vector<std::uint32_t> root_of_;  // by state of the second: its place in roots_
  std::vector<Node> below_;             // by p and place: that root with leaves (p, ·)
  Transitions out_;
};

}  // namespace

AtEachLength at_each_length(const Transitions& minimal, Budget& budget) {
  const std::vector<std::uint32_t> later = later_states(minimal, comes_back(minimal));
  const std::vector<std::uint32_t> roots = one_by_root(minimal, later);
  return {told_apart(minimal, roots, budget), all_reached(minimal, later, budget), roots.size() == later.size()};
}

Transitions disjoint_product(const Transitions& first, const Transitions& second, Verdict verdict, Budget& budget) {
  return AllPairs(first, second, verdict, budget).run();
}

void merge_initial(Transitions& product, Budget& budget) {
  const std::uint32_t initial = product.initial;
  if (comes_back(product)) return;
  for (std::uint32_t q = 0; q < product.roots.size(); ++q) {
    if (q == initial || product.roots[q] != product.roots[initial] ||
        product.accepting[q] != product.accepting[initial])
      continue;
    product.initial = q;
    product = canonical(product, budget);
    return;
  }
}

}  // namespace waymark::automata

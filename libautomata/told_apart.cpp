#include "libautomata/told_apart.hpp"

#include <algorithm>
#include <unordered_map>
#include <unordered_set>

namespace waymark::automata {
namespace {

constexpr int most_lengths = 48;
constexpr std::uint32_t none = 0,
                        all = 1;  // the classes of states that accept no word of the length, or every one

bool comes_back(const Transitions& automaton) {
  const auto is_initial = [&](Mtbdd::Node n) { return n == Mtbdd::terminal(automaton.initial); };
  for (const Mtbdd::Node root : automaton.roots)
    if (is_initial(root)) return true;
  for (const Mtbdd::Node n : automaton.diagram.reachable(automaton.roots))
    if (is_initial(automaton.diagram.low(n)) || is_initial(automaton.diagram.high(n))) return true;
  return false;
}

// The classes of the states at one length after the other.
class Lengths {
 public:
  explicit Lengths(const Transitions& automaton)
      : automaton_(automaton), nodes_(automaton.diagram.reachable(automaton.roots)) {
    for (const bool accepting : automaton.accepting) class_of_.push_back(accepting ? all : none);
  }

  const std::vector<std::uint32_t>& classes() const { return class_of_; }

  void longer() {
    Mtbdd images;
    std::vector<Mtbdd::Node> image(automaton_.diagram.size());
    const auto of = [&](Mtbdd::Node n) {
      return Mtbdd::is_terminal(n) ? Mtbdd::terminal(class_of_[Mtbdd::payload(n)]) : image[n.id];
    };
    for (const Mtbdd::Node n : nodes_) {
      const Mtbdd::Node low = of(automaton_.diagram.low(n)), high = of(automaton_.diagram.high(n));
      image[n.id] = images.make(automaton_.diagram.variable(n), low, high);
    }
    std::unordered_map<std::uint32_t, std::uint32_t> names{{Mtbdd::terminal(none).id, none},
                                                           {Mtbdd::terminal(all).id, all}};
    std::vector<std::uint32_t> next;
    for (const Mtbdd::Node root : automaton_.roots)
      next.push_back(names.try_emplace(of(root).id, static_cast<std::uint32_t>(names.size())).first->second);
    class_of_ = std::move(next);
  }

 private:
  const Transitions& automaton_;
  std::vector<Mtbdd::Node> nodes_;
  std::vector<std::uint32_t> class_of_;
};

bool accepts_every(const Transitions& automaton, std::uint32_t q, bool word) {
  return automaton.roots[q] == Mtbdd::terminal(q) && automaton.accepting[q] == word;
}

}  // namespace

bool told_apart_at_each_length(const Transitions& minimal) {
  std::vector<std::uint32_t> states;
  const bool back = comes_back(minimal);
  for (std::uint32_t q = 0; q < minimal.roots.size(); ++q)
    if (back || q != minimal.initial) states.push_back(q);
  std::unordered_set<std::uint32_t>
      roots;  // with different ones, classes of one state stay that from length to length
  for (const std::uint32_t q : states)
    if (!roots.insert(minimal.roots[q].id).second) return false;

  Lengths lengths(minimal);
  for (int n = 0; n < most_lengths; ++n, lengths.longer()) {
    std::unordered_set<std::uint32_t> seen;
    const auto alone = [&](std::uint32_t q) {
      const std::uint32_t c = lengths.classes()[q];
      if (c == none && !accepts_every(minimal, q, false)) return false;
      if (c == all && !accepts_every(minimal, q, true)) return false;
      return seen.insert(c).second;
    };
    if (std::all_of(states.begin(), states.end(), alone)) return true;
  }
  return false;
}

std::uint32_t initial_class(const Transitions& product) {
  const std::uint32_t initial = product.initial;
  if (comes_back(product)) return initial;
  for (std::uint32_t q = 0; q < product.roots.size(); ++q)
    if (q != initial && product.roots[q] == product.roots[initial] &&
        product.accepting[q] == product.accepting[initial])
      return q;
  return initial;
}

}  // namespace waymark::automata

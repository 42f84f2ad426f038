#include "libautomata/limit_deterministic/master_theorem.hpp"

#include <utility>

#include "libautomata/bdd/pair_walk.hpp"
#include "libautomata/limit_deterministic/advice.hpp"
#include "libautomata/omega/emptiness.hpp"
#include "libautomata/omega/product.hpp"
#include "libautomata/omega/scc_filter.hpp"
#include "libautomata/omega/weak.hpp"
#include "libltl/rewriting/nnf.hpp"
#include "libltl/rewriting/simplify.hpp"

namespace waymark::automata {
namespace {

using ltl::Formula;
using Node = Mtbdd::Node;

constexpr std::size_t most_advices = 64;   // of one formula
constexpr std::size_t most_entries = 256;  // of all
constexpr std::size_t large = 100;         // states of an accepting part: nothing more is made than is owed

// For each state of a complete deterministic automaton of φ, a state of the progression that some word reaches
// together with it: the language left is the same.
class Companions {
 public:
  Companions(const TransitionRelation& parity, const Transitions& structure, Budget& budget)
      : companion_(parity.states()) {
    PairWalk pairs(parity.diagram, structure.diagram, budget);
    meet(parity.initial, structure.initial);
    for (std::size_t i = 0; i < queue_.size(); ++i) {
      const std::uint32_t q = queue_[i];
      pairs.from(parity.roots[q], structure.roots[*companion_[q]], [&](std::uint32_t choice, std::uint32_t companion) {
        meet(parity.choices[choice].front().target, companion);
      });
    }
  }
  const std::optional<std::uint32_t>& of(std::uint32_t q) const { return companion_[q]; }

 private:
  void meet(std::uint32_t q, std::uint32_t companion) {
    if (companion_[q]) return;
    companion_[q] = companion;
    queue_.push_back(q);
  }
  std::vector<std::optional<std::uint32_t>> companion_;
  std::vector<std::uint32_t> queue_;
};

bool accepts_all(const TransitionRelation& automaton, std::uint32_t q) {
  const Node root = automaton.roots[q];
  if (!Mtbdd::is_terminal(root)) return false;
  const auto choice = automaton.choices[Mtbdd::payload(root)];
  return choice.size() == 1 && choice[0] == Branch{q, Marks::first(automaton.acceptance.sets)};
}

class Entries {
 public:
  Entries(const std::vector<ltl::Proposition>& reads, Budget& budget) : reads_(reads), budget_(budget) {}

  // nullopt: accepts nothing.
  std::optional<TransitionRelation> automaton(Formula safe, const std::vector<Formula>& often) {
    safe = ltl::simplify(safe, ltl::Over::Infinite);
    const TransitionRelation safety = as_buchi(weak_deterministic(safe, reads_, budget_), {});
    if (is_empty(safety)) return std::nullopt;
    std::vector<TransitionRelation> waits;
    for (Formula e : often) {
      const Formula f = ltl::simplify(ltl::eventually(e), ltl::Over::Infinite);
      const TransitionRelation wait = as_buchi(weak_deterministic(f, reads_, budget_), {});
      if (is_empty(wait)) return std::nullopt;
      if (!accepts_all(wait, wait.initial)) waits.push_back(wait);
    }
    if (waits.empty()) return always_marked(safety);
    TransitionRelation entry = trim(marked_once(intersection(safety, round(waits), budget_)));
    return is_empty(entry) ? std::nullopt : std::optional(std::move(entry));
  }

 private:
  // Each is waited for until a good prefix is read, then the next one; a mark for every round.
  static TransitionRelation round(const std::vector<TransitionRelation>& waits) {
    AcceptingPart all;
    std::vector<std::uint32_t> first;
    for (const TransitionRelation& wait : waits) first.push_back(all.add(wait));
    std::vector<std::uint32_t> kept(all.automaton.states()), part(kept.size());
    for (std::uint32_t q = 0, i = 0; q < kept.size(); ++q) {
      kept[q] = q;
      if (i + 1 < first.size() && q == first[i + 1]) ++i;
      part[q] = i;
    }
    const auto start = [&](std::size_t i) { return first[i] + waits[i].initial; };
    TransitionRelation out = rebuild(all.automaton, kept, [&](std::uint32_t q, std::span<const Branch> choice) {
      std::vector<Branch> branches;
      for (const Branch& b : choice) {
        const std::uint32_t i = part[q];
        if (!accepts_all(waits[i], b.target - first[i])) {
          branches.push_back({b.target, {}});
        } else {
          const bool last = i + 1 == waits.size();
          branches.push_back({start(last ? 0 : i + 1), last ? Marks::of(0) : Marks()});
        }
      }
      return branches;
    });
    out.initial = start(0);
    out.acceptance = Acceptance::buchi();
    return out;
  }
  static TransitionRelation always_marked(const TransitionRelation& safety) {
    return remarked(safety, [](Marks) { return true; });
  }
  // The safety part has no marks, or is empty: the round's mark is the last one.
  static TransitionRelation marked_once(const TransitionRelation& product) {
    const Marks full = Marks::first(product.acceptance.sets);
    return remarked(product, [&](Marks marks) { return marks == full; });
  }
  template <class Marked>
  static TransitionRelation remarked(const TransitionRelation& automaton, const Marked& marked) {
    std::vector<std::uint32_t> all(automaton.states());
    for (std::uint32_t q = 0; q < all.size(); ++q) all[q] = q;
    TransitionRelation out = rebuild(automaton, all, [&](std::uint32_t, std::span<const Branch> choice) {
      std::vector<Branch> branches(choice.begin(), choice.end());
      for (Branch& b : branches) b.marks = marked(b.marks) ? Marks::of(0) : Marks();
      return branches;
    });
    out.acceptance = Acceptance::buchi();
    return out;
  }

  const std::vector<ltl::Proposition>& reads_;
  Budget& budget_;
};

}  // namespace

std::optional<std::vector<Jump>> jump_by_master_theorem(Formula f, const TransitionRelation& parity,
                                                        const std::vector<ltl::Proposition>& reads,
                                                        AcceptingPart& accepting_part, Budget& budget) {
  const Progression progression = progression_with_meaning(f, reads, budget);
  const Companions companions(parity, progression.structure, budget);
  Entries entries(reads, budget);
  std::vector<std::optional<std::vector<std::uint32_t>>> known(progression.meaning.size());
  std::size_t made = 0;
  std::vector<Jump> out;
  for (std::uint32_t q = 0; q < parity.states(); ++q) {
    if (!companions.of(q)) continue;
    std::optional<std::vector<std::uint32_t>>& targets = known[*companions.of(q)];
    if (!targets) {
      targets.emplace();
      const Formula meaning = ltl::simplify(ltl::nnf(progression.meaning[*companions.of(q)]), ltl::Over::Infinite);
      const auto choices = advices(ltl::nnf(meaning), most_advices);
      if (!choices) return std::nullopt;
      for (const Advice& advice : *choices) {
        const std::optional<TransitionRelation> entry = entries.automaton(advice.safe, advice.often);
        if (!entry) continue;
        if (++made > most_entries) return std::nullopt;
        targets->push_back(accepting_part.add(*entry) + entry->initial);
        if (advice.narrow == advice.safe || accepting_part.automaton.states() > large) continue;
        if (const auto beside = entries.automaton(advice.narrow, advice.often)) accepting_part.add(*beside);
      }
    }
    for (std::uint32_t target : *targets) out.push_back({q, target});
  }
  return out;
}

}  // namespace waymark::automata

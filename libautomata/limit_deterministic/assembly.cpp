#include "libautomata/limit_deterministic/assembly.hpp"

#include <algorithm>
#include <map>
#include <utility>

#include "libautomata/deterministic/colours.hpp"
#include "libautomata/deterministic/inclusion.hpp"
#include "libautomata/omega/emptiness.hpp"

namespace waymark::automata {
namespace {

// What is known of the languages of the states of an automaton and of an accepting part. Nothing compared: each state
// is the only one of its kind, and only what a jump says is known.
class Languages {
 public:
  Languages(const TransitionRelation& parity, const AcceptingPart& accepting_part, bool compare, Budget& budget)
      : compared_(compare) {
    if (!compare) return;
    const TransitionRelation entries = completed_parity(accepting_part.automaton);
    states_ = inclusions(parity, parity, budget);
    into_pool_ = inclusions(parity, entries, budget);
    from_pool_ = inclusions(entries, parity, budget);
    accepting_part_ = inclusions(entries, entries, budget);
  }
  bool compared() const { return compared_; }
  bool same(std::uint32_t p, std::uint32_t q) const { return compared_ ? states_[p][q] && states_[q][p] : p == q; }
  bool inside(std::uint32_t entry, std::uint32_t q) const { return from_pool_[entry][q]; }  // L(entry) ⊆ L(q)
  bool equal(std::uint32_t entry, std::uint32_t q) const { return from_pool_[entry][q] && into_pool_[q][entry]; }
  bool covers(std::uint32_t more, std::uint32_t less) const {
    return compared_ ? accepting_part_[less][more] : less == more;
  }

 private:
  bool compared_;
  std::vector<std::vector<bool>> states_, into_pool_, from_pool_, accepting_part_;
};

class Assembly {
 public:
  Assembly(const TransitionRelation& parity, const AcceptingPart& accepting_part, const Languages& languages,
           const std::vector<Jump>& jumps)
      : parity_(parity),
        graph_(parity),
        accepting_part_(accepting_part),
        languages_(languages),
        live_(live_components(graph_, parity.acceptance.condition).live) {
    representative_.resize(graph_.size());
    for (std::uint32_t q = 0; q < graph_.size(); ++q) {
      std::uint32_t p = 0;
      while (!languages_.same(p, q)) ++p;
      representative_[q] = p;
      of_class_[p].push_back(q);
    }
    for (const Jump& g : jumps) by_state_[g.from].push_back(g);
  }

  LimitDeterministic run() {
    if (live_[parity_.initial]) explore();
    const std::vector<std::uint32_t> chosen = Choosing(accepting_part_).choose(requests_);
    for (auto& [q, entry] : replaced_) entry = chosen[entry];
    for (auto& [q, targets] : jumps_) {
      for (std::uint32_t& target : targets) target = chosen[target];
      keep_the_widest(targets);
    }
    return assembled();
  }

 private:
  // The classes that the initial part needs, and what is asked of the accepting part: replaced_ and jumps_ hold the
  // numbers of requests, until run() puts the chosen states in their place.
  void explore() {
    std::vector<std::uint32_t> queue;
    const auto meet = [&](std::uint32_t q) {
      const std::uint32_t name = representative_[q];
      if (!live_[q] || waiting_.contains(name) || replaced_.contains(name)) return;
      if (std::vector<std::uint32_t> options = exact(name); !options.empty()) {
        replaced_[name] = request(std::move(options));
      } else {
        waiting_[name] = static_cast<std::uint32_t>(queue.size());
        queue.push_back(name);
      }
    };
    meet(parity_.initial);
    for (std::size_t i = 0; i < queue.size(); ++i) {
      for (std::uint32_t member : of_class_.at(queue[i]))
        for (const Jump& g : by_state_[member]) jumps_[queue[i]].push_back(request(instead_of(g.to, queue[i])));
      for (std::uint32_t target : graph_.successors(queue[i])) meet(target);
    }
  }
  std::uint32_t request(std::vector<std::uint32_t> options) {
    requests_.push_back(std::move(options));
    return static_cast<std::uint32_t>(requests_.size() - 1);
  }
  std::vector<std::uint32_t> exact(std::uint32_t q) {
    std::vector<std::uint32_t> out;
    if (!languages_.compared()) {
      for (const Jump& g : by_state_[q])
        if (g.exact) out.push_back(g.to);
      return out;
    }
    for (std::uint32_t entry = 0; entry < accepting_part_.automaton.states(); ++entry)
      if (languages_.equal(entry, q)) out.push_back(entry);
    return out;
  }
  std::vector<std::uint32_t> instead_of(std::uint32_t guessed, std::uint32_t q) const {
    std::vector<std::uint32_t> out{guessed};
    if (!languages_.compared()) return out;
    for (std::uint32_t entry = 0; entry < accepting_part_.automaton.states(); ++entry)
      if (entry != guessed && languages_.covers(entry, guessed) && languages_.inside(entry, q)) out.push_back(entry);
    return out;
  }
  void keep_the_widest(std::vector<std::uint32_t>& targets) const {
    std::sort(targets.begin(), targets.end());
    targets.erase(std::unique(targets.begin(), targets.end()), targets.end());
    for (std::size_t i = 0; i < targets.size();) {
      const std::uint32_t t = targets[i];
      if (std::any_of(targets.begin(), targets.end(),
                      [&](std::uint32_t u) { return u != t && languages_.covers(u, t); }))
        targets.erase(targets.begin() + static_cast<std::ptrdiff_t>(i));
      else
        ++i;
    }
  }

  LimitDeterministic assembled() const {
    std::vector<std::uint32_t> kept(waiting_.size());
    for (const auto& [q, number] : waiting_) kept[number] = q;
    const auto first = static_cast<std::uint32_t>(kept.size());
    const auto place = [&](std::uint32_t q) {
      const std::uint32_t name = representative_[q];
      const auto at = waiting_.find(name);
      return at != waiting_.end() ? at->second : first + replaced_.at(name);
    };
    AcceptingPart both;
    both.add(rebuild(parity_, kept, [&](std::uint32_t, std::span<const Branch> choice) {
      std::vector<Branch> branches;
      for (const Branch& b : choice)
        if (live_[b.target]) branches.push_back({place(b.target), {}});
      return branches;
    }));
    both.add(accepting_part_.automaton);
    LimitDeterministic out{std::move(both.automaton), {}, {}};
    out.jumps.resize(out.automaton.states());
    for (const auto& [q, targets] : jumps_)
      for (std::uint32_t target : targets) out.jumps[waiting_.at(q)].push_back(first + target);
    for (std::uint32_t q = 0; q < out.automaton.states(); ++q) out.accepting_part.push_back(q >= first);
    if (!live_[parity_.initial]) return {nothing(), {{}}, {false}};
    out.automaton.initial = place(parity_.initial);
    return canonical(out);
  }
  static TransitionRelation nothing() {
    TransitionRelation out;
    out.roots.push_back(Mtbdd::terminal(Choices::none));
    out.acceptance = Acceptance::buchi();
    return out;
  }

  const TransitionRelation& parity_;
  BranchGraph graph_;
  const AcceptingPart& accepting_part_;
  const Languages& languages_;
  std::vector<bool> live_;
  std::vector<std::uint32_t> representative_;                     // of a state's class
  std::map<std::uint32_t, std::vector<std::uint32_t>> of_class_;  // its members
  std::map<std::uint32_t, std::vector<Jump>> by_state_;
  std::map<std::uint32_t, std::uint32_t> waiting_, replaced_;  // classes: number, entry of the accepting part
  std::map<std::uint32_t, std::vector<std::uint32_t>> jumps_;  // of a waiting class
  std::vector<std::vector<std::uint32_t>> requests_;
};

}  // namespace

std::vector<LimitDeterministic> assembled(const TransitionRelation& parity, const AcceptingPart& accepting_part,
                                          std::vector<std::vector<Jump>> jumps, bool compare, Budget& budget) {
  const MergedAcceptingPart entries = merged(accepting_part, budget);
  const Languages languages(parity, entries.accepting_part, compare, budget);
  std::vector<LimitDeterministic> out;
  for (std::vector<Jump>& list : jumps) {
    for (Jump& g : list) g.to = entries.number[g.to];
    out.push_back(Assembly(parity, entries.accepting_part, languages, list).run());
  }
  return out;
}

}  // namespace waymark::automata

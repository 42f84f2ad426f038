#include "libplan/solve/explain.hpp"

#include <algorithm>
#include <queue>
#include <string>
#include <vector>

#include "libautomata/finite/ltlf_to_dfa.hpp"
#include "libltl/limits.hpp"
#include "libltl/text/print.hpp"
#include "libplan/solve/route_planner.hpp"

namespace waymark::plan {
namespace {

struct Stopped {};

class Explainer {
 public:
  Explainer(const Map& map, std::span<const PoseId> starts, std::stop_token stop)
      : map_(map), starts_(starts), stop_(std::move(stop)) {}

  std::string reason(ltl::Formula f) const {
    if (!has_word(f)) return "no finite word satisfies the formula: it contradicts itself";
    const std::vector<ltl::Formula> culprits = minimal_part(f);
    std::string out = "no route from " + show_starts() + " satisfies ";
    if (culprits.size() == 1 && culprits[0] == f) {
      out += "the formula";
    } else {
      for (std::size_t i = 0; i < culprits.size(); ++i)
        out += (i == 0 ? "" : i + 1 == culprits.size() ? " and " : ", ") + ltl::print(culprits[i]);
      if (culprits.size() > 1) out += " together";
    }
    const std::vector<std::string> missing = out_of_reach(culprits);
    for (std::size_t i = 0; i < missing.size(); ++i) out += (i == 0 ? "; never seen from there: " : ", ") + missing[i];
    return out;
  }

 private:
  automata::Dfa translate(ltl::Formula f) const {
    auto result = automata::ltlf_to_dfa(f, ltl::Limits{.stop = stop_});
    if (stop_.stop_requested() || std::holds_alternative<automata::Exhausted>(result)) throw Stopped{};
    return std::get<automata::Dfa>(std::move(result));
  }

  bool has_word(ltl::Formula f) const {
    const automata::Dfa dfa = translate(f);
    return !dfa.is_trap(dfa.initial());
  }

  bool has_route(ltl::Formula f) const {
    const automata::Dfa dfa = translate(f);
    const auto answer = RoutePlanner(map_, dfa).plan(starts_, stop_);
    if (std::holds_alternative<Exhausted>(answer)) throw Stopped{};
    return std::holds_alternative<Route>(answer);
  }

  // Conjuncts that have no route each for themselves, or else a set that has none together and no smaller one inside:
  // a conjunct that can be left out is.
  std::vector<ltl::Formula> minimal_part(ltl::Formula f) const {
    if (f.op() != ltl::Op::And) return {f};
    std::vector<ltl::Formula> part(f.operands().begin(), f.operands().end()), alone;
    for (ltl::Formula g : part)
      if (!has_route(g)) alone.push_back(g);
    if (!alone.empty()) return alone;
    for (std::size_t i = 0; i < part.size();) {
      std::vector<ltl::Formula> without = part;
      without.erase(without.begin() + static_cast<std::ptrdiff_t>(i));
      if (has_route(ltl::conjunction(f.arena(), without))) {
        ++i;
      } else {
        part = std::move(without);
      }
    }
    return part;
  }

  // Propositions of the formulas that are in no letter of any word from here.
  std::vector<std::string> out_of_reach(const std::vector<ltl::Formula>& formulas) const {
    const ltl::Letter seen = letters_within_reach();
    std::vector<std::string> names;
    for (ltl::Formula f : formulas) {
      for (ltl::Proposition p : ltl::propositions(f)) {
        const std::string& name = f.arena().vocabulary().name(p);
        if (!seen.contains(*map_.vocabulary().find(name))) names.push_back(name);
      }
    }
    std::sort(names.begin(), names.end());
    names.erase(std::unique(names.begin(), names.end()), names.end());
    return names;
  }

  ltl::Letter letters_within_reach() const {
    ltl::Letter seen;
    std::vector<bool> reached(map_.poses(), false);
    std::queue<PoseId> queue;
    const auto reach = [&](PoseId p) {
      if (!reached[p.index]) queue.push(p);
      reached[p.index] = true;
    };
    for (PoseId p : starts_) {
      seen.insert_all(map_.label(p));
      reach(p);
    }
    for (; !queue.empty(); queue.pop()) {
      for (Action action : all_actions) {
        const auto next = map_.successor(queue.front(), action);
        if (!next) continue;
        seen.insert_all(map_.letter(*next, action));
        reach(*next);
      }
    }
    return seen;
  }

  std::string show_starts() const {
    std::string out;
    for (std::size_t i = 0; i < starts_.size(); ++i) out += (i == 0 ? "" : " or ") + show(map_.pose(starts_[i]));
    return out;
  }

  const Map& map_;
  std::span<const PoseId> starts_;
  std::stop_token stop_;
};

}  // namespace

Infeasible explain_infeasible(const Map& map, ltl::Formula f, std::span<const PoseId> starts, std::stop_token stop) {
  try {
    return {Explainer(map, starts, std::move(stop)).reason(f)};
  } catch (const Stopped&) {
    return {"no route satisfies the formula"};
  }
}

}  // namespace waymark::plan

#include "tools/distributed/shared_task.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>
#include <variant>

#include "libltl/rewriting/simplify.hpp"
#include "libltl/text/parse.hpp"
#include "libltl/text/print.hpp"
#include "libplan/solve/drop_conjuncts.hpp"

namespace waymark::tools {
namespace {

using plan::CaseAnswer;
using Query = plan::CaseTask::Query;
using Logic = plan::CaseTask::Logic;
using Status = CaseAnswer::Status;

struct Spent {  // thrown on every rank: a limit was met
  std::string what;
};

class SharedTask {
 public:
  SharedTask(const Ranks& ranks, const GridBand& band, const plan::CaseTask& task, const SharedOptions& options,
             const KeptBands* kept, SharedStatistics& statistics)
      : ranks_(ranks),
        band_(band),
        task_(task),
        options_(options),
        kept_(kept),
        statistics_(statistics),
        arena_(band.letters().vocabulary()) {}

  CaseAnswer answer() {
    try {
      solve();
    } catch (const Spent& spent) {
      answer_.status = Status::Exhausted;
      answer_.reason = spent.what;
    }
    return std::move(answer_);
  }

 private:
  bool is_finite(ltl::Formula f) const { return plan::is_finite_task(f, task_.logic); }
  bool is_cost() const { return task_.query == Query::MinCost; }

  // Least probabilities are greatest ones of the opposite.
  bool is_least() const { return task_.query == Query::MinProbability; }
  SharedMeasure measure() const {
    switch (task_.query) {
      case Query::MaxProbability:
      case Query::MinProbability: return SharedMeasure::MaxProbability;
      case Query::MinCost: return SharedMeasure::MinCost;
      case Query::Discounted: return SharedMeasure::Discounted;
      default:
        throw std::invalid_argument("query " + std::string(plan::name(task_.query)) +
                                    " is not shared among ranks; waymark without mpirun answers it");
    }
  }

  // Ranks translate alone and agree afterwards: a stop may reach some of them only.
  plan::TaskTable table_of(ltl::Formula f, bool opposite = false) {
    constexpr std::size_t most_states = 1'000'001;
    const auto found =
        plan::task_automaton(f, task_.logic, task_.query, {.states = most_states, .stop = options_.stop});
    if (ranks_.any(!found)) throw Spent{"no automaton within the limits"};
    answer_.automaton_states = std::visit([](const auto& a) { return a.states(); }, *found);
    if (opposite) return plan::TaskTable::never(std::get<automata::Dfa>(*found), band_.letters());
    return std::visit([&](const auto& a) { return plan::TaskTable(a, band_.letters()); }, *found);
  }

  double lap() {
    const auto now = std::chrono::steady_clock::now();
    return std::chrono::duration<double>(now - std::exchange(last_, now)).count();
  }

  void solve() {
    if (!task_.fault.empty()) throw std::invalid_argument(task_.fault);
    measure();  // throws
    const ltl::Formula asked = ltl::parse(task_.formula, arena_);
    const ltl::Formula f = task_.logic == Logic::Ltl ? ltl::simplify(asked, ltl::Semantics::Infinite) : asked;
    const bool finite = is_finite(f), negated = is_least() && !finite;
    const plan::TaskTable table =
        table_of(negated ? ltl::simplify(ltl::negate(f), ltl::Semantics::Infinite) : f, is_least() && finite);
    answer_.seconds.automaton = lap();
    const BandProduct product(band_, table);
    const Halo halo(ranks_, band_, table.states());
    BandSets sets(ranks_, product, halo);
    sets.reach();
    answer_.seconds.product = lap();
    answer_.product_states = sets.pairs();
    answer_.product_edges = sets.edges();
    answer_.method = plan::CaseMethod::ValueIteration;
    sets.solve(measure());
    find_value(product, sets);
    if (is_cost() && answer_.value.lower == INFINITY) infeasible(asked, INFINITY);
    if ((task_.query == Query::MaxProbability || task_.query == Query::Discounted) && answer_.value.upper == 0)
      infeasible(asked, 0);
    answer_.seconds.solve = lap();
  }

  void find_value(const BandProduct& product, const BandSets& sets) {
    BandValues values(ranks_, product, sets, measure(), options_, kept_);
    const bool is_free = is_cost() && band_.cost(0) == 0;  // of a case, all moves cost the same
    const bool solved = is_free || values.solve();
    const plan::Bounds found = values.value();
    answer_.value = is_least() ? plan::Bounds{1 - found.upper, 1 - found.lower} : found;
    if (is_free && !std::isinf(found.lower)) answer_.value = {0, 0};
    statistics_ = values.statistics();
    if (!solved) throw Spent{values.stopped() ? "stopped" : "the bounds did not meet within the limits"};
    answer_.status = Status::Solved;
    if (values.tolerance() > options_.tolerance) answer_.reason = "proved no nearer: here doubles end";
  }

  void infeasible(ltl::Formula asked, double value) {
    answer_.status = Status::Infeasible;
    answer_.value = {value, value};
    const std::size_t states = answer_.automaton_states;
    const plan::Violation violation = plan::fewest_dropped(asked, [&](ltl::Formula part) { return is_possible(part); });
    answer_.automaton_states = states;
    answer_.reason = plan::in_words(violation, is_cost());
    for (ltl::Formula part : violation.dropped) answer_.dropped.push_back(ltl::print(part));
  }

  bool is_possible(ltl::Formula part) {
    const plan::TaskTable table = table_of(part);
    const BandProduct product(band_, table);
    const Halo halo(ranks_, band_, table.states());
    BandSets sets(ranks_, product, halo);
    sets.reach();
    sets.solve(is_cost() ? SharedMeasure::MinCost : SharedMeasure::MaxProbability);
    return ranks_.any(std::any_of(sets.starts().begin(), sets.starts().end(),
                                  [&](std::uint32_t pair) { return sets.is_target(pair) || sets.is_unknown(pair); }));
  }

  const Ranks& ranks_;
  const GridBand& band_;
  const plan::CaseTask& task_;
  const SharedOptions& options_;
  const KeptBands* kept_;
  SharedStatistics& statistics_;
  ltl::Arena arena_;
  CaseAnswer answer_;
  std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

}  // namespace

plan::CaseAnswer answer(const Ranks& ranks, const GridBand& band, const plan::CaseTask& task,
                        const SharedOptions& options, const KeptBands* kept, SharedStatistics& statistics) {
  return SharedTask(ranks, band, task, options, kept, statistics).answer();
}

}  // namespace waymark::tools

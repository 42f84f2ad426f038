#include "tools/lab/feedback_cost.hpp"

#include <algorithm>
#include <chrono>
#include <memory>
#include <stdexcept>

#include "libautomata/finite/ltlf_to_dfa.hpp"
#include "libltl/meaning/progress.hpp"
#include "libltl/meaning/trace_check.hpp"
#include "libltl/structure/random.hpp"
#include "libparser/programs/execute.hpp"
#include "libplan/plan_of.hpp"
#include "libplan/world/generate_hallways.hpp"
#include "libplan/world/read_map.hpp"
#include "libplan/world/trajectory.hpp"
#include "tools/shell/exit_code.hpp"

namespace waymark::tools {
namespace {

using parser::Program;

constexpr std::array furniture{"chair", "sofa", "easel", "lamp", "hatrack", "barstool"};

// Microseconds of one call, the mean of as many as take ten milliseconds, at least one.
template <class Work>
double microseconds(const Work& work) {
  using Clock = std::chrono::steady_clock;
  const auto begin = Clock::now();
  std::size_t calls = 0;
  double elapsed = 0;
  do {
    work();
    ++calls;
    elapsed = std::chrono::duration<double, std::micro>(Clock::now() - begin).count();
  } while (elapsed < 10'000);
  return elapsed / static_cast<double>(calls);
}

plan::Map map_of(std::uint32_t width, std::uint32_t height, std::uint64_t seed) {
  return plan::parse_map(plan::generate_hallways({width, height, static_cast<std::uint32_t>(furniture.size()), seed}));
}

Program random_program(const plan::Map& map, std::size_t steps, ltl::Random& random) {
  Program program;
  while (program.size() < steps) {
    const auto object = map.vocabulary().find(furniture[random.below(furniture.size())]);
    parser::Step step{parser::StepKind::Reach, 0, 1, {static_cast<std::uint16_t>(object->index)}};
    if (program.empty() || program.back() != step) program.push_back(step);
  }
  return program;
}

plan::Trajectory random_walk(const plan::Map& map, plan::PoseId start, std::size_t letters, ltl::Random& random) {
  plan::Trajectory walk{{start}, {}};
  while (walk.poses.size() < letters) {
    const auto action = static_cast<plan::Action>(random.below(3));
    const auto next = map.successor(walk.poses.back(), action);
    if (!next) continue;
    walk.poses.push_back(*next);
    walk.actions.push_back(action);
  }
  return walk;
}

// One sentence: candidate programs, the trajectory they are judged by, and what engines keep for all of them.
class Sentence {
 public:
  Sentence(const parser::Executor& executor, const plan::Trajectory& trajectory, const std::vector<Program>& programs)
      : executor_(executor),
        arena_(executor.map().vocabulary()),
        programs_(programs),
        start_(trajectory.poses.front()),
        end_(trajectory.poses.back()),
        word_(plan::word_of(trajectory, executor.map())) {
    for (const Program& program : programs_) formulas_.push_back(parser::formula_of(program, arena_));
  }

  // Microseconds for all candidates, by engine. Engines that say the same are made to agree: std::logic_error.
  std::array<double, feedback_engines.size()> measure() const {
    std::vector<automata::Dfa> dfas;
    for (const ltl::Formula& f : formulas_) dfas.push_back(automata::ltlf_to_dfa(f));
    std::array<std::size_t, feedback_engines.size()> rewarded{};
    const auto timed = [&](std::size_t engine, const auto& is_rewarded) {
      return microseconds([&] {
        rewarded[engine] = 0;
        for (std::size_t i = 0; i < formulas_.size(); ++i) rewarded[engine] += is_rewarded(i) ? 1 : 0;
      });
    };
    std::array<double, feedback_engines.size()> out{};
    out[0] = timed(0, [&](std::size_t i) { return progressed(formulas_[i]); });
    out[1] = microseconds([&] { rewarded[1] = checked(); });
    out[2] = timed(2, [&](std::size_t i) { return automata::accepts(dfas[i], word_); });
    out[3] = timed(3, [&](std::size_t i) { return automata::accepts(automata::ltlf_to_dfa(formulas_[i]), word_); });
    out[4] = timed(4, [&](std::size_t i) {
      const auto plan = executor_.run(programs_[i], start_);
      return plan && plan->end == end_;
    });
    out[5] = timed(5, [&](std::size_t i) {
      const auto planned = plan::plan_of(executor_.map(), formulas_[i], start_, {.explain = false});
      const auto* route = std::get_if<plan::CertifiedRoute>(&planned);
      return route != nullptr && route->route().poses.back() == end_;
    });
    if (rewarded[1] != rewarded[0] || rewarded[2] != rewarded[0] || rewarded[3] != rewarded[0] ||
        rewarded[5] != rewarded[4])
      throw std::logic_error("two engines disagree about a trajectory");
    return out;
  }

 private:
  bool progressed(ltl::Formula rest) const {
    for (const ltl::Letter& letter : word_) rest = ltl::progress(rest, letter);
    return ltl::accepts_empty(rest);
  }

  // All candidates at once, columns and compilation included.
  std::size_t checked() const {
    const ltl::Columns columns(word_, arena_.vocabulary().size());
    ltl::TraceCheck check(formulas_);
    const std::unique_ptr<bool[]> verdicts(new bool[formulas_.size()]);
    check.check(columns, {verdicts.get(), formulas_.size()});
    return static_cast<std::size_t>(std::count(verdicts.get(), verdicts.get() + formulas_.size(), true));
  }

  const parser::Executor& executor_;
  ltl::Arena arena_;
  const std::vector<Program>& programs_;
  plan::PoseId start_, end_;
  ltl::Trace word_;
  std::vector<ltl::Formula> formulas_;
};

// letters 0: the trajectory is the plan of the first candidate; otherwise a random walk of so many letters.
FeedbackCost row(const plan::Map& map, std::size_t steps, std::size_t letters, const FeedbackCostOptions& options) {
  ltl::Random random(options.seed);
  const parser::Executor executor(map);
  FeedbackCost cost{map.nodes().size(), steps, 0, {}};
  const auto all = static_cast<double>(options.sentences);
  for (std::size_t s = 0; s < options.sentences; ++s) {
    if (options.stop.stop_requested()) throw Interrupted();
    std::vector<Program> programs;
    while (programs.size() < options.candidates) programs.push_back(random_program(map, steps, random));
    const plan::PoseId start{static_cast<std::uint32_t>(random.below(map.poses()))};
    const plan::Trajectory trajectory = letters > 0
                                            ? random_walk(map, start, letters, random)
                                            : *plan::follow(map, start, executor.run(programs.front(), start)->actions);
    cost.length += static_cast<double>(trajectory.poses.size()) / all;
    const auto measured = Sentence(executor, trajectory, programs).measure();
    for (std::size_t e = 0; e < measured.size(); ++e)
      cost.microseconds[e] += measured[e] / all / static_cast<double>(options.candidates);
  }
  return cost;
}

}  // namespace

FeedbackCosts measure_feedback(const FeedbackCostOptions& options) {
  FeedbackCosts costs;
  costs.candidates = options.candidates;
  for (const std::uint32_t side : {4U, 8U, 16U, 32U})
    costs.by_places.push_back(row(map_of(side, side, options.seed), 2, 0, options));
  const plan::Map map = map_of(8, 8, options.seed);
  for (const std::size_t letters : {4U, 16U, 64U, 256U, 1024U})
    costs.by_length.push_back(row(map, 2, letters, options));
  for (const std::size_t steps : {1U, 2U, 3U}) costs.by_steps.push_back(row(map, steps, 0, options));
  return costs;
}

}  // namespace waymark::tools

#include "libparser/experiment/learned/learned_follower.hpp"

#include "libautomata/finite/ltlf_to_dfa.hpp"
#include "libplan/learn/dqn.hpp"
#include "libplan/learn/observations.hpp"

namespace waymark::parser {
namespace {

using plan::TabularProduct;

// Maps have no noise: a choice has one outcome.
std::vector<plan::Action> walk(const TabularProduct& product, const plan::ActionTable& policy, std::size_t horizon) {
  std::vector<plan::Action> actions;
  std::uint32_t state = product.starts.front().state;
  while (product.ending(state) == plan::Ending::Open && actions.size() < horizon) {
    const std::uint8_t action = policy[state];
    const TabularProduct::Outcome& outcome = product.outcomes_of(product.position_of(state), action).front();
    state = product.state(outcome.position, product.task.after(product.task_of(state), outcome.letter));
    actions.push_back(static_cast<plan::Action>(action));
  }
  return actions;
}

}  // namespace

Response LearnedFollower::follow(const Executor& executor, const SentenceInput& input, plan::PoseId start) const {
  Response answer = reader_->follow(executor, input, start);
  if (answer.program.empty()) return answer;
  const Task task{executor.map().name(), start.index, answer.program};
  std::unique_lock lock(mutex_);
  auto known = known_.find(task);
  if (known == known_.end()) {
    lock.unlock();  // learning takes long
    std::vector<plan::Action> actions = learned(executor.map(), start, answer.program);
    lock.lock();
    known = known_.emplace(task, std::move(actions)).first;
  }
  answer.actions = known->second;
  answer.end = start;
  for (const plan::Action action : answer.actions) answer.end = *executor.map().successor(answer.end, action);
  return answer;
}

std::vector<plan::Action> LearnedFollower::learned(const plan::Map& map, plan::PoseId start,
                                                   const Program& program) const {
  ltl::Arena arena(map.vocabulary());
  const automata::Dfa dfa = automata::ltlf_to_dfa(formula_of(program, arena));
  const TabularProduct product = plan::tabulate(map, dfa, start);
  if (product.is_over()) return {};
  const plan::Observations seen = plan::observe(map, plan::Sight::Landmarks);
  plan::Training training;
  training.steps = how_.steps;
  training.interval = how_.steps;  // only the policy in the end is asked for
  training.horizon = how_.horizon;
  training.explore = 1;
  training.explore_steps = how_.steps / 2;
  training.seed = how_.seed;
  return walk(product, plan::learn(product, {&seen.by_position, nullptr}, {}, training).policy, how_.horizon);
}

}  // namespace waymark::parser

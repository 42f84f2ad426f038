// Formulas carried out as the paper does it: not by search but by a policy that deep Q-learning finds for each of them.
//
// What another follower reads is taken as the task; a network learns it from where the sentence begins, by the
// distances to objects, floors and paintings and the one-hot state of the task's automaton (libplan/learn/dqn.hpp), and
// its greedy policy is followed until the task is done, cannot be done any more, or `horizon` steps are taken.
#pragma once
#include <map>
#include <memory>
#include <mutex>
#include <tuple>

#include "libparser/experiment/follower.hpp"

namespace waymark::parser {

struct LearnedExecution {     // how a task is learned
  std::size_t steps = 5'000;  // in the environment, for each task; ε falls from 1 to 0.1 over the first half
  std::size_t horizon = 60;   // of an episode, and of the walk in the end
  std::uint64_t seed = 1;     // of the learner
};

class LearnedFollower : public Follower {
 public:
  LearnedFollower(std::shared_ptr<const Follower> reader, const LearnedExecution& how)
      : reader_(std::move(reader)), how_(how) {}
  Response follow(const Executor& executor, const SentenceInput& input, plan::PoseId start) const override;

 private:
  using Task = std::tuple<std::string, std::uint32_t, Program>;  // on which map, from where
  std::vector<plan::Action> learned(const plan::Map& map, plan::PoseId start, const Program& program) const;

  std::shared_ptr<const Follower> reader_;
  LearnedExecution how_;
  mutable std::mutex mutex_;  // of what is known: the same task is not learned twice
  mutable std::map<Task, std::vector<plan::Action>> known_;
};

}  // namespace waymark::parser

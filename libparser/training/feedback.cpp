#include "libparser/training/feedback.hpp"

#include <algorithm>

#include "libltl/structure/random.hpp"

namespace waymark::parser {
namespace {

constexpr std::size_t other_trajectories = 8;

ltl::Columns columns_of(const plan::Trajectory& trajectory, const plan::Map& map) {
  return {word_of(trajectory, map), map.vocabulary().size()};
}

// The fewest turns from one pose of a place to another.
std::vector<plan::Action> turns_between(const plan::Map& map, plan::PoseId from, plan::PoseId to) {
  const int clockwise = ((map.pose(to).heading - map.pose(from).heading) / 90 + 4) % 4;
  if (clockwise == 3) return {plan::Action::Left};
  return std::vector<plan::Action>(static_cast<std::size_t>(clockwise), plan::Action::Right);
}

plan::Trajectory random_walk(const plan::Map& map, plan::PoseId start, std::size_t length, ltl::Random& random) {
  plan::Trajectory walk{{start}, {}};
  while (walk.actions.size() < length) {
    const auto action = static_cast<plan::Action>(random.below(3));
    const auto next = map.successor(walk.poses.back(), action);
    if (!next) continue;
    walk.poses.push_back(*next);
    walk.actions.push_back(action);
  }
  return walk;
}

}  // namespace

std::vector<plan::Trajectory> trajectories_of(const GoldRoute& gold, const plan::Map& map) {
  const auto first_move = std::find(gold.actions.begin(), gold.actions.end(), plan::Action::Forward);
  plan::PoseId known = gold.start;
  for (auto it = gold.actions.begin(); it != first_move; ++it) known = *map.successor(known, *it);
  std::vector<plan::Trajectory> out;
  const plan::PoseId place{4 * map.node_of(gold.start)};
  for (std::uint32_t h = 0; h < 4; ++h) {
    const plan::PoseId start{place.index + h};
    std::vector<plan::Action> actions = turns_between(map, start, known);
    actions.insert(actions.end(), first_move, gold.actions.end());
    out.push_back(*follow(map, start, actions));
  }
  return out;
}

const Feedback::Words& Feedback::words_of(const Example& example) {
  const auto [it, is_new] = words_.try_emplace(&example);
  if (!is_new) return it->second;
  Words& words = it->second;
  const plan::Map& map = executors_[example.map].map();
  const plan::Trajectory gold = *follow(map, example.gold.start, example.gold.actions);
  if (example.gold.heading_unknown)
    for (const plan::Trajectory& trajectory : trajectories_of(example.gold, map))
      words.gold.push_back(columns_of(trajectory, map));
  else
    words.gold.push_back(columns_of(gold, map));
  if (kind_ != FeedbackKind::Discriminating) return words;
  plan::Trajectory prefix = gold;
  while (!prefix.actions.empty()) {
    prefix.actions.pop_back();
    prefix.poses.pop_back();
    words.prefixes.push_back(columns_of(prefix, map));
  }
  ltl::Random random(seed_ ^ (std::uint64_t{example.gold.start.index} << 32U | example.gold.actions.size()));
  for (std::size_t i = 0; i < other_trajectories && !gold.actions.empty(); ++i) {
    const plan::Trajectory walk = random_walk(map, example.gold.start, gold.actions.size(), random);
    if (!(walk.poses.back() == gold.poses.back())) words.others.push_back(columns_of(walk, map));
  }
  return words;
}

double Feedback::of(const Program& program, const Example& example) {
  const Executor& executor = executors_[example.map];
  if (kind_ == FeedbackKind::Plan) {
    const auto plan = executor.run(program, example.gold.start, then_);
    return plan && plan->end == example.gold.end ? 1 : 0;
  }
  ltl::Arena arena(executor.map().vocabulary());
  ltl::TraceCheck satisfied(formula_of(program, arena));
  const Words& words = words_of(example);
  double sum = 0;
  for (const ltl::Columns& word : words.gold) sum += satisfied(word) ? 1 : 0;
  const double mean = sum / static_cast<double>(words.gold.size());
  if (mean == 0 || kind_ == FeedbackKind::Progression) return mean;
  const auto is_satisfied = [&](const ltl::Columns& word) { return satisfied(word); };
  if (std::any_of(words.prefixes.begin(), words.prefixes.end(), is_satisfied)) return 0;
  if (std::any_of(words.others.begin(), words.others.end(), is_satisfied)) return 0;
  return mean;
}

}  // namespace waymark::parser

#include "libparser/supervision/search.hpp"

#include <algorithm>
#include <bit>

namespace waymark::parser {
namespace {

using Bits = std::vector<std::uint64_t>;

// Where a one-step program can end, in the order of its least word; by literal, which of these places satisfy it.
class Horizon {
 public:
  Horizon(const Executor& executor, StepKind kind, bool oriented, plan::PoseId start)
      : reached_(executor.horizon(kind, start, oriented)), literals_(executor.propositions()) {
    const std::size_t blocks = reached_.size() / 64 + 1;
    for (std::uint16_t p = 0; p < literals_.size(); ++p) {
      literals_[p].assign(blocks, 0);
      for (std::size_t r = 0; r < reached_.size(); ++r)
        if (reached_[r].goal && executor.holds(p, reached_[r].arrival)) set(literals_[p], r);
    }
  }

  std::int32_t first(std::uint16_t p) const { return first(literals_[p], literals_[p]); }
  std::int32_t first(std::uint16_t p, std::uint16_t q) const { return first(literals_[p], literals_[q]); }
  plan::PoseId end(std::int32_t at) const { return reached_[static_cast<std::size_t>(at)].arrival.pose(); }

  std::vector<plan::Action> actions(std::int32_t at) const {
    std::vector<plan::Action> out;
    for (; at >= 0; at = reached_[static_cast<std::size_t>(at)].from)
      if (const Arrival by = reached_[static_cast<std::size_t>(at)].arrival; !by.is_start()) out.push_back(by.action());
    std::reverse(out.begin(), out.end());
    return out;
  }

 private:
  static void set(Bits& bits, std::size_t i) { bits[i / 64] |= std::uint64_t{1} << (i % 64); }

  std::int32_t first(const Bits& a, const Bits& b) const {
    for (std::size_t i = 0; i < a.size(); ++i)
      if (const std::uint64_t both = a[i] & b[i]; both != 0)
        return static_cast<std::int32_t>(64 * i) + std::countr_zero(both);
    return -1;
  }

  std::vector<Executor::Reached> reached_;
  std::vector<Bits> literals_;
};

Step with_goal(StepKind kind, std::initializer_list<std::uint16_t> literals) {
  Step step{kind, 0, static_cast<std::uint8_t>(literals.size()), {}};
  std::copy(literals.begin(), literals.end(), step.goal.begin());
  return step;
}

class Search {
 public:
  Search(const Executor& executor, const PostfixGrammar& grammar, const GoldRoute& gold)
      : executor_(executor), grammar_(grammar), gold_(gold) {}

  std::vector<Consistent> run() {
    if (gold_.actions.empty()) keep({Step{}});
    one_step(StepKind::Reach, false);
    one_step(StepKind::Next, false);
    one_step(StepKind::Advance, false);
    one_step(StepKind::Face, false);
    for (int k = 1; k <= PostfixGrammar::max_forward; ++k) keep({forward(k)});
    if (gold_.heading_unknown) {
      one_step(StepKind::Advance, true);
      for (int k = 1; k <= PostfixGrammar::max_forward; ++k) keep({Step{StepKind::Orient, 0, 0, {}}, forward(k)});
    }
    more_steps();
    return std::move(found_);
  }

 private:
  static Step forward(int k) { return {StepKind::Forward, static_cast<std::uint8_t>(k), 0, {}}; }

  // Keeps the program if its plan ends right.
  void keep(const Program& program) {
    const auto plan = executor_.run(program, gold_.start);
    if (plan && plan->end == gold_.end) found_.push_back({program, plan->actions == gold_.actions});
  }

  void one_step(StepKind kind, bool oriented) {
    const Horizon horizon(executor_, kind, oriented, gold_.start);
    const auto keep_if = [&](std::int32_t at, const Step& step) {
      if (at < 0 || horizon.end(at) != gold_.end) return;
      Program program;
      if (oriented) program.push_back({StepKind::Orient, 0, 0, {}});
      program.push_back(step);
      found_.push_back({program, horizon.actions(at) == gold_.actions});
    };
    const auto propositions = static_cast<std::uint16_t>(executor_.propositions());
    std::vector<std::uint16_t> others;  // goals that hold somewhere, but do not do the job alone
    for (std::uint16_t p = 0; p < propositions; ++p) {
      const std::int32_t at = horizon.first(p);
      if (!grammar_.usable(p, kind) || at < 0) continue;
      keep_if(at, with_goal(kind, {p}));
      if (horizon.end(at) != gold_.end) others.push_back(p);
    }
    for (std::size_t a = 0; a < others.size(); ++a)
      for (std::size_t b = a + 1; b < others.size(); ++b)
        keep_if(horizon.first(others[a], others[b]), with_goal(kind, {others[a], others[b]}));
  }

  // Short steps that do exactly the gold actions from position `begin` to `end`, from the pose there.
  std::vector<Step> parts(std::size_t begin, std::size_t end, bool few) const {
    const auto from = pose_at(begin);
    const std::vector<plan::Action> want(gold_.actions.begin() + static_cast<std::ptrdiff_t>(begin),
                                         gold_.actions.begin() + static_cast<std::ptrdiff_t>(end));
    const bool moves = want.front() == plan::Action::Forward;
    std::vector<Step> steps;
    if (moves && want.size() <= PostfixGrammar::max_forward) steps.push_back(forward(static_cast<int>(want.size())));
    std::vector<StepKind> kinds{moves ? StepKind::Advance : StepKind::Face};
    if (!few) kinds.insert(kinds.end(), {StepKind::Next, StepKind::Reach});
    if (few && !moves) kinds.push_back(StepKind::Next);
    for (StepKind kind : kinds) {
      const Horizon horizon(executor_, kind, false, from);
      for (std::uint16_t p = 0; p < executor_.propositions(); ++p) {
        if (!grammar_.usable(p, kind) || (few && kind == StepKind::Next && !grammar_.is_turn(p))) continue;
        const std::int32_t at = horizon.first(p);
        if (at >= 0 && horizon.actions(at) == want) steps.push_back(with_goal(kind, {p}));
      }
    }
    return steps;
  }

  void more_steps() {
    std::vector<std::size_t> cuts{0};
    for (std::size_t i = 1; i < gold_.actions.size(); ++i)
      if (gold_.actions[i] != gold_.actions[i - 1]) cuts.push_back(i);
    cuts.push_back(gold_.actions.size());
    const std::size_t legs = cuts.size() - 1;
    const bool orient = gold_.heading_unknown && gold_.actions.size() > 1 && gold_.actions[0] != plan::Action::Forward;
    if (gold_.actions.empty() || legs < 2 || legs > 4) return;
    std::vector<std::vector<Step>> steps;
    for (std::size_t i = 0; i < legs; ++i) steps.push_back(parts(cuts[i], cuts[i + 1], legs >= 3));
    if (legs <= 3) combine(steps, 0, {});
    if (orient && legs >= 3) combine(steps, 1, {Step{StepKind::Orient, 0, 0, {}}});
  }

  void combine(const std::vector<std::vector<Step>>& steps, std::size_t leg, const Program& program) {
    if (leg == steps.size()) {
      const auto plan = executor_.run(program, gold_.start);
      if (plan && plan->actions == gold_.actions) found_.push_back({program, true});
      return;
    }
    for (const Step& step : steps[leg]) {
      Program longer = program;
      longer.push_back(step);
      combine(steps, leg + 1, longer);
    }
  }

  plan::PoseId pose_at(std::size_t action) const {
    plan::PoseId pose = gold_.start;
    for (std::size_t i = 0; i < action; ++i) pose = *executor_.map().successor(pose, gold_.actions[i]);
    return pose;
  }

  const Executor& executor_;
  const PostfixGrammar& grammar_;
  const GoldRoute& gold_;
  std::vector<Consistent> found_;
};

}  // namespace

std::vector<Consistent> consistent_programs(const Executor& executor, const PostfixGrammar& grammar,
                                            const GoldRoute& gold) {
  return Search(executor, grammar, gold).run();
}

}  // namespace waymark::parser

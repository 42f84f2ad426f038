#include "libplan/motion/explore.hpp"

#include <algorithm>
#include <chrono>
#include <map>
#include <stdexcept>
#include <utility>

namespace waymark::plan {
namespace {

// Most trees that lead to a solution do so in less than a second, others never: so the first tries are short.
constexpr double first_try = 1, longer = 1.3;  // seconds; every further try so much longer

// Symbols, which are regions too: pose p is p, the hallway e with heading 90 h is 4 · (nodes + e) + h.
class Symbols {
 public:
  explicit Symbols(const Workspace& workspace) : workspace_(workspace), map_(workspace.map()) {}

  std::uint32_t of(Cell cell, int quarter) const {
    const auto base = static_cast<std::uint32_t>(cell.kind == Cell::Kind::Node ? 0 : map_.nodes().size());
    return 4 * (base + cell.index) + static_cast<std::uint32_t>(quarter);
  }
  std::optional<std::uint32_t> of(const Configuration& c) const {
    const auto cell = workspace_.cell_at(position(c));
    if (!cell) return std::nullopt;
    return of(*cell, quarter_of(c.heading));
  }
  // The hallways that meet the cell of a pose, with its heading.
  std::vector<std::uint32_t> around(PoseId pose) const {
    std::vector<std::uint32_t> out;
    for (const int heading : {0, 90, 180, 270})
      if (const Edge* edge = map_.hallway(map_.node_of(pose), heading))
        out.push_back(of(Cell{Cell::Kind::Edge, static_cast<std::uint32_t>(edge - map_.edges().data())},
                         static_cast<int>(pose.index % 4)));
    return out;
  }

  std::vector<Region> regions() const {
    std::vector<Region> out(4 * (map_.nodes().size() + map_.edges().size()));
    const double width = workspace_.width();
    for (std::uint32_t symbol = 0; symbol < out.size(); ++symbol) {
      out[symbol].symbol = symbol;
      out[symbol].volume = symbol < map_.poses() ? width * width : width * (1 - width);
    }
    const auto join = [&](std::uint32_t a, std::uint32_t b) {
      out[a].neighbours.push_back(static_cast<int>(b));
      out[b].neighbours.push_back(static_cast<int>(a));
    };
    for (std::uint32_t pose = 0; pose < map_.poses(); ++pose) {
      join(pose, map_.successor(PoseId{pose}, Action::Right).value().index);
      for (const std::uint32_t hallway : around(PoseId{pose})) join(pose, hallway);
    }
    return out;
  }

 private:
  const Workspace& workspace_;
  const Map& map_;
};

// 𝒜_φ with the pose last entered, as far as it can be reached and acceptance from it.
class TaskMaker {
 public:
  TaskMaker(const automata::Dfa& dfa, const Map& map, const Symbols& symbols)
      : dfa_(dfa), map_(map), symbols_(symbols) {}

  SymbolAutomaton make(PoseId start, automata::StateId q) {
    state_of(start, q);
    for (std::size_t i = 0; i < pairs_.size(); ++i) {
      const auto [pose, state] = pairs_[i];
      const auto here = static_cast<std::uint32_t>(i);
      add(here, pose.index, here);
      for (const std::uint32_t hallway : symbols_.around(pose)) add(here, hallway, here);
      for (const Action action : all_actions) {
        const auto next = map_.successor(pose, action);
        if (!next) continue;
        const automata::StateId target = dfa_.next(state, map_.letter(*next, action));
        if (!dfa_.is_trap(target)) add(here, next->index, state_of(*next, target));
      }
    }
    return std::move(out_);
  }

 private:
  std::uint32_t state_of(PoseId pose, automata::StateId q) {
    const auto [found, is_new] = states_.try_emplace({pose, q}, static_cast<std::uint32_t>(pairs_.size()));
    if (is_new) {
      pairs_.emplace_back(pose, q);
      out_.transitions.emplace_back();
      out_.accepting.push_back(dfa_.is_accepting(q));
    }
    return found->second;
  }
  void add(std::uint32_t from, std::uint32_t symbol, std::uint32_t to) {
    out_.transitions[from].push_back({symbol, to});
  }

  const automata::Dfa& dfa_;
  const Map& map_;
  const Symbols& symbols_;
  std::map<std::pair<PoseId, automata::StateId>, std::uint32_t> states_;
  std::vector<std::pair<PoseId, automata::StateId>> pairs_;
  SymbolAutomaton out_;
};

Configuration first_configuration(const Workspace& workspace, PoseId start, const Robot& robot) {
  const Map& map = workspace.map();
  const double heading = map.pose(start).heading;
  for (const Point p : workspace.stands(map.node_of(start), 0))
    if (const Configuration c{p.x, p.y, heading}; admits(workspace, c, robot)) return c;
  throw std::invalid_argument("the robot does not fit where it starts");
}

bool is_accepted(const Motion& motion, const Workspace& workspace, const automata::Dfa& dfa) {
  const auto read = route_of(motion, workspace);
  const auto* route = std::get_if<Trajectory>(&read);
  return route != nullptr && automata::accepts(dfa, word_of(*route, workspace.map()));
}

}  // namespace

SymbolAutomaton task_over_symbols(const automata::Dfa& dfa, const Workspace& workspace, PoseId start) {
  const Symbols symbols(workspace);
  const Map& map = workspace.map();
  return TaskMaker(dfa, map, symbols).make(start, dfa.next(dfa.initial(), map.label(start)));
}

Explored try_exploring(const ExplorationProblem& problem, const Exploration& how,
                       const std::function<bool(const Motion&)>& is_done) {
  if (!has_run(problem)) return NoRun{};
  using Clock = std::chrono::steady_clock;
  const auto begin = Clock::now();
  double share = first_try;
  for (std::uint32_t attempt = 0;; ++attempt, share *= longer) {
    const double left = how.seconds - std::chrono::duration<double>(Clock::now() - begin).count();
    if (left <= 0) return OutOfTime{how.seconds};
    const auto seed = static_cast<std::uint32_t>(how.seed) + attempt;
    Motion motion{explore(problem, std::min(left, share), seed), how.robot};
    if (!motion.configurations.empty() && is_done(motion)) return motion;
  }
}

Explored explore(const automata::Dfa& dfa, const Workspace& workspace, PoseId start, const Exploration& how) {
  if (!is_possible(how.robot)) throw std::invalid_argument("a robot has no such size");
  const Map& map = workspace.map();
  const Configuration first = first_configuration(workspace, start, how.robot);
  const automata::StateId q = dfa.next(dfa.initial(), map.label(start));
  if (dfa.is_accepting(q)) return Motion{{first}, how.robot};
  if (dfa.is_trap(q)) return NoRun{};
  const Symbols symbols(workspace);
  ExplorationProblem problem{task_over_symbols(dfa, workspace, start),
                             symbols.regions(),
                             [&](const Configuration& c) { return symbols.of(c); },
                             [&](const Configuration& from, const Configuration& to) {
                               const auto piece = piece_between(from, to, how.robot);
                               return piece && admits(workspace, *piece, how.robot);
                             },
                             {},
                             {},
                             0.04,
                             how.robot,
                             first};
  problem.low = problem.high = workspace.centre(0);
  for (std::uint32_t node = 0; node < map.nodes().size(); ++node) {
    const Point c = workspace.centre(node);
    problem.low = {std::min(problem.low.x, c.x - 1), std::min(problem.low.y, c.y - 1)};
    problem.high = {std::max(problem.high.x, c.x + 1), std::max(problem.high.y, c.y + 1)};
  }
  return try_exploring(problem, how, [&](const Motion& motion) { return is_accepted(motion, workspace, dfa); });
}

}  // namespace waymark::plan

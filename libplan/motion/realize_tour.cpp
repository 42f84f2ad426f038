#include "libplan/motion/realize_tour.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>

#include "libplan/motion/steer_disc.hpp"

namespace waymark::plan {
namespace {

constexpr double margin = 1e-6;            // more room than is certified, so that rounding decides nothing
constexpr std::size_t most_goals = 10;     // that a car's leg is sampled towards
constexpr double steps_across = 200;       // of propagation, from corner to corner of the terrain
constexpr std::size_t most_attempts = 25;  // runs through the cells that are tried

void check_start(const Terrain& terrain, const TerrainCells& cells, const Configuration& start, const Robot& robot) {
  if (!is_possible(robot)) throw std::invalid_argument("a robot has no such size");
  if (!cells.at(position(start)) || !admits(terrain, start, robot))
    throw std::invalid_argument("the robot does not fit where it starts");
}

// Passages too narrow for the body, as far as a few points of each show: runs through them are not worth a try.
std::vector<PassageId> narrow_passages(const Terrain& terrain, const TerrainCells& cells, const Robot& robot) {
  constexpr int points = 16;
  const auto* car = std::get_if<Car>(&robot);
  const double radius = car != nullptr ? car->width / 2 : std::get<Disc>(robot).radius;
  std::vector<PassageId> narrow;
  for (std::uint32_t from = 0; from < cells.cells().size(); ++from)
    for (const Passage& passage : cells.cells()[from].passages) {
      bool is_wide = false;
      for (int k = 0; k <= points && !is_wide; ++k) {
        const double t = 1.0 * k / points;
        const Point p{passage.a.x + t * (passage.b.x - passage.a.x), passage.a.y + t * (passage.b.y - passage.a.y)};
        is_wide = terrain.admits(p, p, radius);
      }
      if (!is_wide) narrow.push_back({from, passage.to});
    }
  return narrow;
}

struct Leg {
  ltl::Letter now, next;
  const Passage* by;   // to the next letter
  std::uint32_t into;  // the cell behind it
};

std::vector<Leg> legs_of(const std::vector<CellStep>& run, const TerrainCells& cells) {
  std::vector<Leg> legs;
  for (std::size_t i = 1; i < run.size(); ++i) {
    const ltl::Letter &before = cells.letter_of(run[i - 1].cell), &after = cells.letter_of(run[i].cell);
    if (!(before == after)) legs.push_back({before, after, run[i].by, run[i].cell});
  }
  return legs;
}

class TourMaker {
 public:
  TourMaker(const Terrain& terrain, const TerrainCells& cells, const Sampling& sampling)
      : terrain_(terrain), cells_(cells), sampling_(sampling), car_(std::get_if<Car>(&sampling.robot)) {}

  // Appends the leg to the line; false when no way was found.
  bool go(const Leg& leg, std::size_t index, Line& line) const {
    const std::vector<Point> ends = ends_of(leg);
    if (ends.empty()) return false;
    const SamplingBudget budget = sampling_budget(sampling_, index);
    Line way = car_ == nullptr ? disc_line(leg, line.back(), ends, budget) : car_line(leg, line.back(), ends, budget);
    if (way.size() < 2 || !reads(way, {leg.now, leg.next})) return false;
    line.insert(line.end(), way.begin() + 1, way.end());
    return true;
  }

 private:
  // Behind the passage, from its middle to its ends, from near it to the centre of the cell.
  std::vector<Point> ends_of(const Leg& leg) const {
    const Point a = leg.by->a, b = leg.by->b, c = cells_.cells()[leg.into].centre;
    std::vector<Point> ends;
    for (const double along : {0.5, 0.25, 0.75, 0.1, 0.9})
      for (const double inwards : {0.2, 0.5, 1.0}) {
        const Point p{a.x + along * (b.x - a.x), a.y + along * (b.y - a.y)};
        const Point end{p.x + inwards * (c.x - p.x), p.y + inwards * (c.y - p.y)};
        const double radius = car_ == nullptr ? room() : car_->width / 2;
        if (terrain_.label(end) == leg.next && terrain_.admits(end, end, radius)) ends.push_back(end);
      }
    return ends;
  }

  double room() const { return std::get<Disc>(sampling_.robot).radius + margin; }

  // Whether the letters of the line are those, or the beginning or the end of them; backwards too where `both_ways`.
  bool reads(const Line& line, const std::vector<ltl::Letter>& letters, bool any_part = false) const {
    const auto read = word_of(Motion{line, sampling_.robot}, terrain_);
    const auto* word = std::get_if<TimedWord>(&read);
    if (word == nullptr) return false;
    if (!any_part) return word->letters == letters;
    const auto is_one = [&](const ltl::Letter& a) { return a == letters[0] || a == letters[1]; };
    return word->letters.size() <= 2 && std::all_of(word->letters.begin(), word->letters.end(), is_one);
  }

  Line disc_line(const Leg& leg, const Configuration& from, const std::vector<Point>& ends,
                 const SamplingBudget& budget) const {
    const auto line_of = [&](const std::vector<Point>& points) {
      Line line;
      for (const Point& p : points) line.push_back({p.x, p.y, from.heading});
      return line;
    };
    const auto is_free = [&](Point a, Point b) {
      return terrain_.admits(a, b, room()) &&
             reads(line_of(a == b ? std::vector{a} : std::vector{a, b}), {leg.now, leg.next}, true);
    };
    for (const Point& end : ends)
      if (is_free(position(from), end)) return line_of({position(from), end});
    const PathProblem problem{terrain_.low(), terrain_.high(), is_free, position(from), ends};
    return line_of(rounded(tightened(sample_path(problem, budget), is_free), is_free));
  }

  Line car_line(const Leg& leg, const Configuration& from, const std::vector<Point>& ends,
                const SamplingBudget& budget) const {
    const auto is_free = [&](const Line& line) { return reads(line, {leg.now, leg.next}, true); };
    std::vector<Configuration> goals;
    const Point c = cells_.cells()[leg.into].centre,
                middle{(leg.by->a.x + leg.by->b.x) / 2, (leg.by->a.y + leg.by->b.y) / 2};
    const double across = std::atan2(c.x - middle.x, middle.y - c.y) / radians(1);  // into the cell
    for (const Point& end : ends)
      for (const double aside : {0.0, 30.0, -30.0, 60.0, -60.0, 180.0}) {
        const Configuration goal{end.x, end.y, normalized(across + aside)};
        if (admits(terrain_, goal, sampling_.robot)) goals.push_back(goal);
      }
    if (goals.empty()) return {};
    std::vector<std::pair<double, Line>> drives;
    for (const Configuration& goal : goals) {
      Line line = shortest_drive(from, goal, car_->turning_radius);
      drives.emplace_back(length(Motion{line, sampling_.robot}), std::move(line));
    }
    std::stable_sort(drives.begin(), drives.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    for (const auto& [unused, line] : drives)
      if (reads(line, {leg.now, leg.next})) return line;
    std::vector<Configuration> spread;  // every goal costs the sampler a drive for every state it considers
    for (std::size_t i = 0; i < most_goals; ++i) spread.push_back(goals[i * goals.size() / most_goals]);
    return sample_drive({terrain_.low(), terrain_.high(), 0, 180, car_->turning_radius, is_free, from, spread}, budget);
  }

  const Terrain& terrain_;
  const TerrainCells& cells_;
  const Sampling& sampling_;
  const Car* car_;
};

// 𝒜_φ with the letter last read.
class LetterTask {
 public:
  LetterTask(const automata::Dfa& dfa, const TerrainCells& cells) : dfa_(dfa), cells_(cells) {}

  SymbolAutomaton make(std::uint32_t letter, automata::StateId q) {
    state_of(letter, q);
    for (std::size_t i = 0; i < pairs_.size(); ++i) {
      const auto [here, state] = pairs_[i];
      for (std::uint32_t next = 0; next < cells_.letters().size(); ++next) {
        const auto target = next == here ? state : dfa_.next(state, cells_.letters()[next]);
        if (dfa_.is_trap(target)) continue;
        const std::uint32_t to = state_of(next, target);
        out_.transitions[i].push_back({next, to});
      }
    }
    return std::move(out_);
  }

 private:
  std::uint32_t state_of(std::uint32_t letter, automata::StateId q) {
    const auto [found, is_new] = states_.try_emplace({letter, q}, static_cast<std::uint32_t>(pairs_.size()));
    if (is_new) {
      pairs_.emplace_back(letter, q);
      out_.transitions.emplace_back();
      out_.accepting.push_back(dfa_.is_accepting(q));
    }
    return found->second;
  }

  const automata::Dfa& dfa_;
  const TerrainCells& cells_;
  std::map<std::pair<std::uint32_t, automata::StateId>, std::uint32_t> states_;
  std::vector<std::pair<std::uint32_t, automata::StateId>> pairs_;
  SymbolAutomaton out_;
};

bool is_accepted(const Motion& motion, const Terrain& terrain, const automata::Dfa& dfa) {
  const auto read = word_of(motion, terrain);
  const auto* word = std::get_if<TimedWord>(&read);
  return word != nullptr && automata::accepts(dfa, ltl::Trace(word->letters));
}

}  // namespace

TourOutcome realize(const automata::Dfa& dfa, const Terrain& terrain, const Configuration& start,
                    const Sampling& sampling) {
  const TerrainCells cells(terrain);
  check_start(terrain, cells, start, sampling.robot);
  const TourMaker maker(terrain, cells, sampling);
  const std::uint32_t first = cells.at(position(start)).value();
  if (!plan_tour(dfa, cells, first)) return NoRun{};
  std::vector<PassageId> blocked = narrow_passages(terrain, cells, sampling.robot);
  for (std::size_t attempt = 0; attempt < most_attempts; ++attempt) {
    const auto run = plan_tour(dfa, cells, first, blocked);
    if (!run) return NotFound{attempt};
    Line line{start};
    std::size_t done = 0;
    const std::vector<Leg> legs = legs_of(*run, cells);
    while (done < legs.size() && maker.go(legs[done], done, line)) ++done;
    if (done == legs.size()) return Motion{line, sampling.robot};
    for (std::size_t i = 1; i < run->size(); ++i)
      if ((*run)[i].by == legs[done].by) blocked.push_back({(*run)[i - 1].cell, (*run)[i].cell});
  }
  return NotFound{most_attempts};
}

Explored explore(const automata::Dfa& dfa, const Terrain& terrain, const Configuration& start, const Exploration& how) {
  const TerrainCells cells(terrain);
  check_start(terrain, cells, start, how.robot);
  const std::uint32_t first = cells.at(position(start)).value();
  const automata::StateId q = dfa.next(dfa.initial(), cells.letter_of(first));
  if (dfa.is_accepting(q)) return Motion{{start}, how.robot};
  if (dfa.is_trap(q)) return NoRun{};
  ExplorationProblem problem{LetterTask(dfa, cells).make(cells.cells()[first].letter, q),
                             {},
                             [&](const Configuration& c) { return cells.at(position(c)); },
                             [&](const Configuration& from, const Configuration& to) {
                               const auto piece = piece_between(from, to, how.robot);
                               return piece && admits(terrain, *piece, how.robot);
                             },
                             terrain.low(),
                             terrain.high(),
                             distance(terrain.low(), terrain.high()) / steps_across,
                             how.robot,
                             start};
  for (const TerrainCell& cell : cells.cells()) {
    problem.regions.push_back({cell.letter, cell.area, {}});
    for (const Passage& passage : cell.passages)
      problem.regions.back().neighbours.push_back(static_cast<int>(passage.to));
  }
  if (!has_run(problem)) return NoRun{};
  for (const PassageId& passage : narrow_passages(terrain, cells, how.robot)) {
    auto& neighbours = problem.regions[passage.from].neighbours;
    neighbours.erase(std::remove(neighbours.begin(), neighbours.end(), static_cast<int>(passage.to)), neighbours.end());
  }
  if (!has_run(problem)) return OutOfTime{0};
  return try_exploring(problem, how, [&](const Motion& motion) { return is_accepted(motion, terrain, dfa); });
}

}  // namespace waymark::plan

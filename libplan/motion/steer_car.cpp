#include "libplan/motion/steer_car.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <stdexcept>

namespace waymark::plan {
namespace {

constexpr std::size_t attempts = 3;  // configurations that a leg is sampled from
// Of half the width of a cell, forwards and sideways.
constexpr std::array coarse{0.0, -0.5, 0.5, -0.95, 0.95};
constexpr std::array fine{0.0, -0.25, 0.25, -0.5, 0.5, -0.68, 0.68, -0.82, 0.82, -0.95, 0.95};

struct Leg {  // of the route, from one pose to another
  std::size_t begin, end;
};

struct Stop {  // a configuration at the end of a leg, reached
  Configuration at;
  double cost = 0;         // of the way there
  std::size_t before = 0;  // in the layer before
  Line line;               // from that one to here
};
using Layer = std::vector<Stop>;

// The length, and a turning radius more for every change of direction.
double cost_of(const Line& line, const Car& car) {
  double sum = 0, last = 0;
  for (std::size_t i = 1; i < line.size(); ++i) {
    const double way = Piece::driving(line[i - 1], line[i]).value().way();
    sum += std::abs(way) + (way * last < 0 ? car.turning_radius : 0);
    last = way;
  }
  return sum;
}

class Driver {
 public:
  Driver(const Trajectory& route, const Workspace& workspace, const Sampling& sampling)
      : route_(route), workspace_(workspace), sampling_(sampling), car_(std::get<Car>(sampling.robot)) {}

  Realization run() {
    start();
    for (const Leg& leg : legs()) {
      Layer next = joined(leg);
      if (next.empty()) next = sampled(leg);
      if (next.empty()) return Unreached{route_.poses[leg.begin], route_.poses[leg.end], sampling_.iterations};
      layers_.push_back(std::move(next));
    }
    return motion();
  }

 private:
  std::uint32_t node(std::size_t pose) const { return workspace_.map().node_of(route_.poses[pose]); }
  double heading(std::size_t pose) const { return workspace_.map().pose(route_.poses[pose]).heading; }

  bool is_furnished(std::size_t pose) const {
    return workspace_.furniture() > 0 && workspace_.map().nodes()[node(pose)].object.has_value();
  }

  std::vector<Leg> legs() const {
    std::vector<Leg> out;
    for (std::size_t i = 0; i < route_.actions.size(); ++i) {
      const bool goes_on = i > 0 && route_.actions[i] == Action::Forward && route_.actions[i - 1] == Action::Forward;
      if (goes_on && !is_furnished(i))
        out.back().end = i + 1;
      else
        out.push_back({i, i + 1});
    }
    return out;
  }

  // Where the car may be at that pose: a lattice, finer where furniture leaves little room. At both ends of the route
  // the middle of the cell, if it fits there.
  std::vector<Configuration> stops(std::size_t pose) const {
    const Point c = workspace_.centre(node(pose)), ahead = ahead_of(heading(pose)), right{-ahead.y, ahead.x};
    const bool is_end = pose == 0 || pose + 1 == route_.poses.size();
    const Cell here{Cell::Kind::Node, node(pose)};
    const std::span<const double> lattice =
        is_furnished(pose) ? std::span<const double>(fine) : std::span<const double>(coarse);
    std::vector<Configuration> out;
    for (const double along : lattice)
      for (const double across : lattice) {
        const double forward = along * workspace_.width() / 2, sideways = across * workspace_.width() / 2;
        const Configuration stop{c.x + forward * ahead.x + sideways * right.x,
                                 c.y + forward * ahead.y + sideways * right.y, heading(pose)};
        if (workspace_.cell_at(position(stop)) != here || !admits(workspace_, stop, sampling_.robot)) continue;
        out.push_back(stop);
        if (is_end && along == 0 && across == 0) return out;
      }
    return out;
  }

  void start() {
    if (!is_possible(sampling_.robot)) throw std::invalid_argument("the sizes of a car are positive");
    if (!(car_.width < workspace_.width()))
      throw std::invalid_argument("a car of that width is wider than the hallways");
    Layer layer;
    for (const Configuration& stop : stops(0)) layer.push_back({stop, 0, 0, {stop}});
    if (layer.empty()) throw std::invalid_argument("the car does not fit where the route starts");
    layers_.push_back(std::move(layer));
  }

  bool reads_as(const Line& line, const Leg& leg) const {
    const auto read = route_of({line, sampling_.robot}, workspace_);
    const auto* route = std::get_if<Trajectory>(&read);
    const auto first = route_.actions.begin() + static_cast<std::ptrdiff_t>(leg.begin);
    const auto last = route_.actions.begin() + static_cast<std::ptrdiff_t>(leg.end);
    return route != nullptr && route->poses.back() == route_.poses[leg.end] &&
           std::equal(route->actions.begin(), route->actions.end(), first, last);
  }

  // Every stop of the leg's end that one drive leads to, by the cheapest way through the last layer.
  Layer joined(const Leg& leg) const {
    struct Choice {
      double cost;
      std::size_t from;
      Line line;
    };
    Layer out;
    const Layer& last = layers_.back();
    for (const Configuration& goal : stops(leg.end)) {
      std::vector<Choice> choices;
      for (std::size_t i = 0; i < last.size(); ++i) {
        Line line = shortest_drive(last[i].at, goal, car_.turning_radius);
        choices.push_back({last[i].cost + cost_of(line, car_), i, std::move(line)});
      }
      std::stable_sort(choices.begin(), choices.end(),
                       [](const Choice& a, const Choice& b) { return a.cost < b.cost; });
      const auto found = std::find_if(choices.begin(), choices.end(),
                                      [&](const Choice& choice) { return reads_as(choice.line, leg); });
      if (found != choices.end()) out.push_back({goal, found->cost, found->from, std::move(found->line)});
    }
    return out;
  }

  Layer sampled(const Leg& leg) const {
    const Layer& last = layers_.back();
    std::vector<std::size_t> order(last.size());
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return last[a].cost < last[b].cost; });
    const std::vector<Configuration> goals = stops(leg.end);
    if (goals.empty()) return {};
    for (std::size_t i = 0; i < std::min(attempts, order.size()); ++i) {
      const Stop& from = last[order[i]];
      Line line = sample_drive(problem(leg, from.at, goals), sampling_budget(sampling_, leg.begin));
      if (line.empty() || !reads_as(line, leg)) continue;
      line = shortened(line, leg);
      return {{line.back(), from.cost + cost_of(line, car_), order[i], line}};
    }
    return {};
  }

  // Confined to the cells of the leg and, for a turn, to the hallways that meet its cell.
  DriveProblem problem(const Leg& leg, const Configuration& from, const std::vector<Configuration>& goals) const {
    const Point a = workspace_.centre(node(leg.begin)), b = workspace_.centre(node(leg.end));
    const double half = workspace_.width() / 2;
    const double room = node(leg.begin) == node(leg.end) ? 1 - half : half;
    const Point low{std::min(a.x, b.x) - room, std::min(a.y, b.y) - room};
    const Point high{std::max(a.x, b.x) + room, std::max(a.y, b.y) + room};
    const auto is_free = [this, leg](const Line& line) { return stays_in(line, leg); };
    const auto [middle, aside] = headings(leg);
    return {low, high, middle, aside, car_.turning_radius, is_free, from, goals};
  }

  // The headings of a leg: one quarter, or the two of a turn; the middle one, and how far from it they reach.
  std::pair<double, double> headings(const Leg& leg) const {
    const double turn = turn_between(heading(leg.begin), heading(leg.end));
    return {heading(leg.begin) + turn / 2, turn == 0 ? 45 : 90};
  }

  // Whether nothing is touched, no heading is taken that the leg has not, and a turn happens in its cell. What else
  // the word asks for is read off the whole line in the end.
  bool stays_in(const Line& line, const Leg& leg) const {
    const auto [middle, aside] = headings(leg);
    const bool turns = heading(leg.begin) != heading(leg.end);
    for (std::size_t i = 0; i < line.size(); ++i) {
      if (std::abs(turn_between(middle, line[i].heading)) >= aside) return false;
      if (line.size() == 1 && !admits(workspace_, line[i], sampling_.robot)) return false;
      if (i == 0) continue;
      const auto piece = piece_between(line[i - 1], line[i], sampling_.robot);
      if (!piece || !admits(workspace_, *piece, sampling_.robot)) return false;
      std::vector<double> passed;
      if (turns) piece->passes_heading(middle, 360, passed);
      for (const double t : passed)
        if (workspace_.cell_at(position(piece->at(t))) != Cell{Cell::Kind::Node, node(leg.begin)}) return false;
    }
    return true;
  }

  // From every configuration on to the farthest one that one drive leads to, where the leg still reads the same.
  Line shortened(Line line, const Leg& leg) const {
    for (std::size_t i = 0; i + 2 < line.size(); ++i)
      for (std::size_t j = line.size() - 1; j > i + 1; --j) {
        const Line part = shortest_drive(line[i], line[j], car_.turning_radius);
        if (cost_of(part, car_) >=
            cost_of({line.begin() + static_cast<std::ptrdiff_t>(i), line.begin() + static_cast<std::ptrdiff_t>(j) + 1},
                    car_) -
                1e-9)
          continue;
        Line other(line.begin(), line.begin() + static_cast<std::ptrdiff_t>(i));
        other.insert(other.end(), part.begin(), part.end());
        other.insert(other.end(), line.begin() + static_cast<std::ptrdiff_t>(j) + 1, line.end());
        if (!reads_as(other, leg)) continue;
        line = std::move(other);
        break;
      }
    return line;
  }

  Motion motion() const {
    const auto shorter = [](const Stop& a, const Stop& b) { return a.cost < b.cost; };
    const Layer& last = layers_.back();
    auto stop = static_cast<std::size_t>(std::min_element(last.begin(), last.end(), shorter) - last.begin());
    std::vector<const Line*> lines;
    for (std::size_t i = layers_.size(); i-- > 0; stop = layers_[i][stop].before)
      lines.push_back(&layers_[i][stop].line);
    Motion out{*lines.back(), sampling_.robot};
    for (std::size_t i = lines.size() - 1; i-- > 0;)
      out.configurations.insert(out.configurations.end(), lines[i]->begin() + 1, lines[i]->end());
    return out;
  }

  const Trajectory& route_;
  const Workspace& workspace_;
  const Sampling& sampling_;
  const Car& car_;
  std::vector<Layer> layers_;
};

}  // namespace

Realization steer_car(const Trajectory& route, const Workspace& workspace, const Sampling& sampling) {
  return Driver(route, workspace, sampling).run();
}

}  // namespace waymark::plan

#include "libplan/motion/motion.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>

namespace waymark::plan {
namespace {

constexpr double quarter_turn = 90, half_turn = 180, full_turn = 360;

int quarter(double heading) {  // the nearest one, 0 … 3
  return static_cast<int>(std::floor((heading + quarter_turn / 2) / quarter_turn)) & 3;
}

// The parameters in (0, 1) at which the line from u to v passes a value k · period + offset, k an integer.
void passings(double u, double v, double period, double offset, std::vector<double>& out) {
  if (u == v) return;
  const double low = std::ceil((std::min(u, v) - offset) / period);
  const double high = std::floor((std::max(u, v) - offset) / period);
  for (double k = low; k <= high; ++k) {
    const double t = (k * period + offset - u) / (v - u);
    if (t > 0 && t < 1) out.push_back(t);
  }
}

// Follows a motion from cell to cell and quarter to quarter.
class Reader {
 public:
  explicit Reader(const Workspace& workspace) : workspace_(workspace) {}

  // Each of these returns what is wrong, empty when nothing is.
  std::string start(const Configuration& c, double radius) {
    const auto cell = workspace_.cell_at(position(c));
    if (!cell || cell->kind != Cell::Kind::Node) return "the motion does not start at a place";
    if (!workspace_.admits(position(c), radius)) return "the robot does not fit where it starts";
    node_ = cell->index;
    quarter_ = quarter(c.heading);
    trajectory_.poses.push_back(here());
    return "";
  }

  std::string move(const Configuration& from, const Configuration& to, double radius) {
    const double turn = turn_between(from.heading, to.heading);
    if (turn == half_turn) return "half a turn at once: left or right?";
    if (!workspace_.admits(position(from), position(to), radius))
      return "the robot touches a wall or furniture";
    const auto at = [&](double u, double v, double t) { return u + (v - u) * t; };
    const std::vector<double> events = events_between(from, to, turn);
    for (std::size_t i = 0; i + 1 < events.size(); ++i) {
      const double t = (events[i] + events[i + 1]) / 2;
      std::string fault =
          step({at(from.x, to.x, t), at(from.y, to.y, t)}, quarter(from.heading + turn * t + full_turn));
      if (!fault.empty()) return fault;
    }
    return "";
  }

  std::string finish(const Configuration& c) {
    const Cell cell{Cell::Kind::Node, node_};
    return workspace_.cell_at(position(c)) == cell ? "" : "the motion does not end at a place";
  }

  const Trajectory& trajectory() const { return trajectory_; }

 private:
  PoseId here() const { return PoseId{4 * node_ + static_cast<std::uint32_t>(quarter_)}; }

  // 0, 1, and the parameters between them where the cell or the nearest quarter may change.
  std::vector<double> events_between(const Configuration& from, const Configuration& to, double turn) const {
    std::vector<double> events{0, 1};
    for (double border : {-workspace_.width() / 2, workspace_.width() / 2}) {
      passings(from.x, to.x, 1, border, events);
      passings(from.y, to.y, 1, border, events);
    }
    passings(from.heading, from.heading + turn, quarter_turn, quarter_turn / 2, events);
    std::sort(events.begin(), events.end());
    events.erase(std::unique(events.begin(), events.end()), events.end());
    return events;
  }

  std::string step(Point p, int towards) {
    const auto cell = workspace_.cell_at(p);
    if (!cell) return "the robot is in a wall";
    const bool at_place = cell->kind == Cell::Kind::Node;
    if (towards != quarter_) {
      if (!at_place || cell->index != node_) return "the robot turns between two places";
      const bool clockwise = towards == (quarter_ + 1) % 4;
      quarter_ = towards;
      append(clockwise ? Action::Right : Action::Left);
    }
    if (at_place && cell->index != node_) {
      if (workspace_.map().neighbour(node_, 90 * quarter_) != cell->index)
        return "the robot enters a place that is not ahead of it";
      node_ = cell->index;
      append(Action::Forward);
    }
    return "";
  }

  void append(Action action) {
    trajectory_.actions.push_back(action);
    trajectory_.poses.push_back(here());
  }

  const Workspace& workspace_;
  std::uint32_t node_ = 0;
  int quarter_ = 0;
  Trajectory trajectory_;
};

bool is_configuration(const Configuration& c) {
  return std::isfinite(c.x) && std::isfinite(c.y) && c.heading >= 0 && c.heading < full_turn;
}

}  // namespace

double turn_between(double from, double to) {
  const double turn = std::fmod(to - from + 2 * full_turn, full_turn);  // 0 … 360
  return turn > half_turn ? turn - full_turn : turn;
}

double length(const Motion& motion) {
  double sum = 0;
  for (std::size_t i = 1; i < motion.configurations.size(); ++i)
    sum += distance(position(motion.configurations[i - 1]), position(motion.configurations[i]));
  return sum;
}

std::variant<Trajectory, NoRoute> route_of(const Motion& motion, const Workspace& workspace) {
  const std::vector<Configuration>& line = motion.configurations;
  if (line.empty()) return NoRoute{0, "a motion needs at least one configuration"};
  Reader reader(workspace);
  for (std::size_t i = 0; i < line.size(); ++i) {
    std::string fault;
    if (!is_configuration(line[i]))
      fault = "not a configuration: headings run from 0 to below 360";
    else if (i == 0)
      fault = reader.start(line[0], motion.radius);
    else
      fault = reader.move(line[i - 1], line[i], motion.radius);
    if (fault.empty() && i + 1 == line.size()) fault = reader.finish(line[i]);
    if (!fault.empty()) return NoRoute{i, std::move(fault)};
  }
  return reader.trajectory();
}

CertifiedMotion certify(Motion motion, const Workspace& workspace, ltl::Formula f) {
  const auto read = route_of(motion, workspace);
  if (const auto* fault = std::get_if<NoRoute>(&read))
    throw std::logic_error("the motion is no route at configuration " + std::to_string(fault->step) + ": " +
                           fault->reason);
  const Map& map = workspace.map();
  CertifiedRoute route = certify(priced(std::get<Trajectory>(read), map), map, f);
  return CertifiedMotion(std::move(motion), std::move(route));
}

}  // namespace waymark::plan

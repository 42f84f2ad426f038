#include "libplan/motion/motion.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace waymark::plan {
namespace {

// Follows a motion from cell to cell and quarter to quarter.
class Reader {
 public:
  Reader(const Workspace& workspace, const Robot& robot) : workspace_(workspace), robot_(robot) {}

  // Each of these returns what is wrong, empty when nothing is.
  std::string start(const Configuration& c) {
    const auto cell = workspace_.cell_at(position(c));
    if (!cell || cell->kind != Cell::Kind::Node) return "the motion does not start at a place";
    if (!admits(workspace_, c, robot_)) return "the robot does not fit where it starts";
    node_ = cell->index;
    quarter_ = quarter_of(c.heading);
    read_.route.poses.push_back(here());
    return "";
  }

  std::string move(const Configuration& from, const Configuration& to, std::size_t index) {
    const auto piece = piece_between(from, to, robot_);
    if (!piece && turn_between(from.heading, to.heading) == 2 * quarter_turn)
      return "half a turn at once: left or right?";
    if (!piece) return "a car cannot drive there along one arc";
    if (!admits(workspace_, *piece, robot_)) return "the robot touches a wall or furniture";
    const std::vector<double> events = events_of(*piece);
    for (std::size_t i = 0; i + 1 < events.size(); ++i) {
      std::string fault = step(piece->at((events[i] + events[i + 1]) / 2));
      if (!fault.empty()) return fault;
      read_.times.resize(read_.route.actions.size(), static_cast<double>(index - 1) + events[i]);
    }
    return "";
  }

  std::string finish(const Configuration& c) {
    const Cell cell{Cell::Kind::Node, node_};
    return workspace_.cell_at(position(c)) == cell ? "" : "the motion does not end at a place";
  }

  TimedRoute& read() { return read_; }

 private:
  PoseId here() const { return PoseId{4 * node_ + static_cast<std::uint32_t>(quarter_)}; }

  // 0, 1, and the parameters between them where the cell or the nearest quarter may change.
  std::vector<double> events_of(const Piece& piece) const {
    std::vector<double> events{0, 1};
    const Configuration from = piece.at(0);
    const double half = workspace_.width() / 2, most = piece.length();
    const auto borders = [&](Point normal, double at) {  // every k ± half that may be passed
      for (double k = std::floor(at - most - half); k <= std::ceil(at + most + half); ++k)
        for (const double border : {k - half, k + half}) piece.passes_line(normal, border, events);
    };
    borders({1, 0}, from.x);
    borders({0, 1}, from.y);
    piece.passes_heading(quarter_turn / 2, quarter_turn, events);
    std::sort(events.begin(), events.end());
    events.erase(std::unique(events.begin(), events.end()), events.end());
    return events;
  }

  std::string step(const Configuration& c) {
    const auto cell = workspace_.cell_at(position(c));
    if (!cell) return "the robot is in a wall";
    const bool at_place = cell->kind == Cell::Kind::Node;
    const int towards = quarter_of(c.heading);
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
    read_.route.actions.push_back(action);
    read_.route.poses.push_back(here());
  }

  const Workspace& workspace_;
  const Robot& robot_;
  std::uint32_t node_ = 0;
  int quarter_ = 0;
  TimedRoute read_;
};

}  // namespace

int quarter_of(double heading) { return static_cast<int>(std::floor((heading + quarter_turn / 2) / quarter_turn)) & 3; }

bool is_configuration(const Configuration& c) {
  return std::isfinite(c.x) && std::isfinite(c.y) && c.heading >= 0 && c.heading < full_turn;
}

std::vector<Piece> pieces_of(const Motion& motion) {
  std::vector<Piece> pieces;
  for (std::size_t i = 1; i < motion.configurations.size(); ++i) {
    const auto piece = piece_between(motion.configurations[i - 1], motion.configurations[i], motion.robot);
    if (!piece) throw std::invalid_argument("no piece of motion leads to configuration " + std::to_string(i));
    pieces.push_back(*piece);
  }
  return pieces;
}

double length(const Motion& motion) {
  double sum = 0;
  for (const Piece& piece : pieces_of(motion)) sum += piece.length();
  return sum;
}

std::variant<TimedRoute, NoRoute> timed_route_of(const Motion& motion, const Workspace& workspace) {
  const std::vector<Configuration>& line = motion.configurations;
  if (line.empty()) return NoRoute{0, "a motion needs at least one configuration"};
  if (!is_possible(motion.robot)) return NoRoute{0, "a robot has no such size"};
  Reader reader(workspace, motion.robot);
  for (std::size_t i = 0; i < line.size(); ++i) {
    std::string fault;
    if (!is_configuration(line[i]))
      fault = "not a configuration: headings run from 0 to below 360";
    else if (i == 0)
      fault = reader.start(line[0]);
    else
      fault = reader.move(line[i - 1], line[i], i);
    if (fault.empty() && i + 1 == line.size()) fault = reader.finish(line[i]);
    if (!fault.empty()) return NoRoute{i, std::move(fault)};
  }
  return std::move(reader.read());
}

std::variant<Trajectory, NoRoute> route_of(const Motion& motion, const Workspace& workspace) {
  auto read = timed_route_of(motion, workspace);
  if (auto* fault = std::get_if<NoRoute>(&read)) return std::move(*fault);
  return std::move(std::get<TimedRoute>(read).route);
}

CertifiedMotion certify(Motion motion, const Workspace& workspace, ltl::Formula f) {
  auto read = timed_route_of(motion, workspace);
  if (const auto* fault = std::get_if<NoRoute>(&read))
    throw std::logic_error("the motion is no route at configuration " + std::to_string(fault->step) + ": " +
                           fault->reason);
  auto& timed = std::get<TimedRoute>(read);
  const Map& map = workspace.map();
  CertifiedRoute route = certify(priced(std::move(timed.route), map), map, f);
  return CertifiedMotion(std::move(motion), std::move(route), std::move(timed.times));
}

}  // namespace waymark::plan

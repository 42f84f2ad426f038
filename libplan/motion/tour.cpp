#include "libplan/motion/tour.hpp"

#include <algorithm>
#include <functional>
#include <limits>
#include <map>
#include <queue>
#include <stdexcept>

#include "libltl/meaning/semantics.hpp"

namespace waymark::plan {
namespace {

constexpr double corner = 1e-9;  // nearer than that the centre goes through it

class WordReader {
 public:
  WordReader(const Terrain& terrain, const Robot& robot) : terrain_(terrain), robot_(robot) {}

  std::string start(const Configuration& c) {
    return admits(terrain_, c, robot_) ? "" : "the robot does not fit where it starts";
  }

  std::string move(const Configuration& from, const Configuration& to, std::size_t index) {
    const auto piece = piece_between(from, to, robot_);
    if (!piece && turn_between(from.heading, to.heading) == 180) return "half a turn at once: left or right?";
    if (!piece) return "a car cannot drive there along one arc";
    if (!admits(terrain_, *piece, robot_)) return "the robot touches a wall";
    const std::vector<double> events = events_of(*piece);
    for (const double t : events)
      for (const Point& p : terrain_.region_corners())
        if (distance(p, position(piece->at(t))) < corner) return "the centre goes through a corner of regions";
    for (std::size_t i = 0; i + 1 < events.size(); ++i)
      read(terrain_.label(position(piece->at((events[i] + events[i + 1]) / 2))),
           static_cast<double>(index - 1) + events[i]);
    return "";
  }

  void read(ltl::Letter letter, double time) {
    if (!word_.letters.empty() && word_.letters.back() == letter) return;
    word_.times.push_back(word_.letters.empty() ? 0 : time);
    word_.letters.push_back(std::move(letter));
  }

  TimedWord& word() { return word_; }

 private:
  std::vector<double> events_of(const Piece& piece) const {
    std::vector<double> events{0, 1};
    for (const auto& [a, b] : terrain_.region_edges()) {
      const Point normal{a.y - b.y, b.x - a.x};
      piece.passes_line(normal, normal.x * a.x + normal.y * a.y, events);
    }
    std::sort(events.begin(), events.end());
    events.erase(std::unique(events.begin(), events.end()), events.end());
    return events;
  }

  const Terrain& terrain_;
  const Robot& robot_;
  TimedWord word_;
};

// Least-cost search in cells × 𝒜_φ, forwards from the start [Dij59].
class TourSearch {
 public:
  TourSearch(const automata::Dfa& dfa, const TerrainCells& cells, const std::vector<PassageId>& blocked)
      : dfa_(dfa), cells_(cells), blocked_(blocked) {}

  std::optional<std::vector<CellStep>> run(std::uint32_t start) {
    reach({start, dfa_.next(dfa_.initial(), cells_.letter_of(start))}, 0, nullptr, nullptr);
    while (!open_.empty()) {
      const auto [cost, node] = open_.top();
      open_.pop();
      if (cost > nodes_.at(node).cost) continue;
      if (dfa_.is_accepting(node.second)) return way_to(node);
      expand(node, cost);
    }
    return std::nullopt;
  }

 private:
  using Node = std::pair<std::uint32_t, automata::StateId>;
  struct Reached {
    double cost = std::numeric_limits<double>::infinity();
    const Node* from = nullptr;
    const Passage* by = nullptr;
  };

  void reach(const Node& node, double cost, const Node* from, const Passage* by) {
    if (dfa_.is_trap(node.second)) return;
    Reached& reached = nodes_[node];
    if (cost >= reached.cost) return;
    reached = {cost, from, by};
    open_.push({cost, node});
  }

  Point entry(const Node& node) const {
    const Passage* by = nodes_.at(node).by;
    return by == nullptr ? cells_.cells()[node.first].centre : Point{(by->a.x + by->b.x) / 2, (by->a.y + by->b.y) / 2};
  }

  void expand(const Node& node, double cost) {
    const Node& kept = nodes_.find(node)->first;
    const Point here = entry(node);
    for (const Passage& passage : cells_.cells()[node.first].passages) {
      const PassageId id{node.first, passage.to};
      if (std::find(blocked_.begin(), blocked_.end(), id) != blocked_.end()) continue;
      const bool same = cells_.cells()[node.first].letter == cells_.cells()[passage.to].letter;
      const auto q = same ? node.second : dfa_.next(node.second, cells_.letter_of(passage.to));
      const Point there{(passage.a.x + passage.b.x) / 2, (passage.a.y + passage.b.y) / 2};
      reach({passage.to, q}, cost + distance(here, there), &kept, &passage);
    }
  }

  std::vector<CellStep> way_to(const Node& goal) const {
    std::vector<CellStep> way;
    for (const Node* node = &goal; node != nullptr; node = nodes_.at(*node).from)
      way.push_back({node->first, nodes_.at(*node).by});
    std::reverse(way.begin(), way.end());
    return way;
  }

  struct Entry {
    double cost;
    Node node;
    bool operator>(const Entry& other) const { return cost > other.cost; }
  };
  const automata::Dfa& dfa_;
  const TerrainCells& cells_;
  const std::vector<PassageId>& blocked_;
  std::map<Node, Reached> nodes_;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open_;
};

}  // namespace

std::variant<TimedWord, NoTour> word_of(const Motion& motion, const Terrain& terrain) {
  const std::vector<Configuration>& line = motion.configurations;
  if (line.empty()) return NoTour{0, "a motion needs at least one configuration"};
  if (!is_possible(motion.robot)) return NoTour{0, "a robot has no such size"};
  WordReader reader(terrain, motion.robot);
  for (std::size_t i = 0; i < line.size(); ++i) {
    std::string fault;
    if (!is_configuration(line[i]))
      fault = "not a configuration: headings run from 0 to below 360";
    else
      fault = i == 0 ? reader.start(line[0]) : reader.move(line[i - 1], line[i], i);
    if (!fault.empty()) return NoTour{i, std::move(fault)};
  }
  if (line.size() == 1) reader.read(terrain.label(position(line[0])), 0);
  return std::move(reader.word());
}

CertifiedTour certify(Motion motion, const Terrain& terrain, ltl::Formula f) {
  if (!(f.arena().vocabulary() == terrain.vocabulary()))
    throw std::logic_error("certify: the formula is not over the regions of the terrain");
  auto read = word_of(motion, terrain);
  if (const auto* fault = std::get_if<NoTour>(&read))
    throw std::logic_error("the motion is no tour at configuration " + std::to_string(fault->step) + ": " +
                           fault->reason);
  auto& word = std::get<TimedWord>(read);
  if (!ltl::holds(ltl::Trace(word.letters), f))
    throw std::logic_error("certify: the word of the tour, " +
                           ltl::show(ltl::Trace(word.letters), terrain.vocabulary()) +
                           ", does not satisfy the formula");
  return CertifiedTour(std::move(motion), std::move(word));
}

std::optional<std::vector<CellStep>> plan_tour(const automata::Dfa& dfa, const TerrainCells& cells, std::uint32_t start,
                                               const std::vector<PassageId>& blocked) {
  return TourSearch(dfa, cells, blocked).run(start);
}

}  // namespace waymark::plan

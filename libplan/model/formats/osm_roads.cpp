#include "libplan/model/formats/osm_roads.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <istream>
#include <limits>
#include <ostream>
#include <set>
#include <unordered_map>

#include "libltl/diagnostic.hpp"
#include "libplan/model/formats/globe_points.hpp"
#include "libplan/model/formats/xml_stream.hpp"
#include "libplan/model/road_graph.hpp"
#include "libplan/world/street_map.hpp"

namespace waymark::plan {
namespace {

using OsmId = std::int64_t;
constexpr std::int32_t unknown = std::numeric_limits<std::int32_t>::min();  // a longitude

template <class T>
void sort_unique(std::vector<T>& values) {
  std::sort(values.begin(), values.end());
  values.erase(std::unique(values.begin(), values.end()), values.end());
}

struct Element {  // a node or a way
  OsmId id = 0;
  FixedPoint at;
  std::vector<OsmId> refs;
  std::vector<std::string> names;  // of the propositions that it would have
  bool road = false, forward = true, backward = true;
  bool is_ring() const { return refs.size() > 3 && refs.front() == refs.back(); }
};

// Tags → propositions, numbered as they are met.
class Landmarks {
 public:
  explicit Landmarks(const OsmChoice& choice) : choice_(choice), wanted_(choice.names.begin(), choice.names.end()) {}

  void read(std::string_view key, std::string_view value, std::vector<std::string>& out) const {
    const auto add = [&](std::string name) {
      if (name == "init" || name == "deadlock") name += '_';  // these mean something else in FILE.lab
      if (!name.empty()) out.push_back(std::move(name));
    };
    if (key == "name") {
      std::string name = landmark_name(value);
      if ((wanted_.empty() && choice_.tags.empty()) || wanted_.count(name) > 0) add(std::move(name));
    }
    for (const auto& [k, v] : choice_.tags)
      if (k == key && v == value) add(landmark_name(value));
  }
  std::uint32_t number(const std::string& name) {
    const auto [found, fresh] = numbers_.try_emplace(name, static_cast<std::uint32_t>(names_.size()));
    if (fresh) names_.push_back(name);
    return found->second;
  }
  const std::vector<std::string>& names() const { return names_; }  // by number

 private:
  const OsmChoice& choice_;
  std::set<std::string> wanted_;
  std::unordered_map<std::string, std::uint32_t> numbers_;
  std::vector<std::string> names_;
};

// Border included; in whole numbers, so exact. Of a ring that crosses itself, all that it winds around.
bool is_inside(const FixedPoint& p, const std::vector<FixedPoint>& ring) {
  int windings = 0;
  for (std::size_t i = 0; i + 1 < ring.size(); ++i) {
    const FixedPoint &a = ring[i], &b = ring[i + 1];
    const std::int64_t ax = std::int64_t{a.longitude} - p.longitude, ay = std::int64_t{a.latitude} - p.latitude,
                       bx = std::int64_t{b.longitude} - p.longitude, by = std::int64_t{b.latitude} - p.latitude;
    const std::int64_t left = ax * by, right = bx * ay;  // each below 2^63: 360 times 180 degrees
    if (left == right && std::min(ax, bx) <= 0 && std::max(ax, bx) >= 0 && std::min(ay, by) <= 0 &&
        std::max(ay, by) >= 0)
      return true;
    if (ay <= 0 && by > 0 && left > right) ++windings;
    if (ay > 0 && by <= 0 && left < right) --windings;
  }
  return windings != 0;
}

class OsmRoadsWriter {
 public:
  OsmRoadsWriter(std::istream& osm, std::string_view source, const OsmChoice& choice, std::ostream& gr,
                 std::ostream& co, std::ostream& lab)
      : osm_(osm), source_(source), choice_(choice), landmarks_(choice), gr_(gr), co_(co), lab_(lab) {}

  OsmRoads write() {
    if (!pass([&](XmlStream& xml) { note(xml); })) return stopped();
    sort_unique(roads_);
    sort_unique(corners_);
    if (roads_.empty()) fail("there is no road");
    at_.assign(roads_.size(), {unknown, 0});
    corner_at_.assign(corners_.size(), {unknown, 0});
    osm_.clear();
    osm_.seekg(0);
    if (!pass([&](XmlStream& xml) { place(xml); })) return stopped();
    if (!numbered_) number_nodes();
    write_heading();
    write_labels();
    return out_;
  }

 private:
  [[noreturn]] void fail(const std::string& message) const { throw ltl::FormatError(source_, 0, 0, message); }
  OsmRoads stopped() {
    out_.stopped = true;
    return out_;
  }

  // visit(xml) where an element within <osm> begins.
  template <class Visit>
  bool pass(const Visit& visit) {
    XmlStream xml(osm_, source_);
    for (std::uint64_t elements = 0;; ++elements) {
      if (elements % (1U << 16U) == 0 && choice_.stop.stop_requested()) return false;
      const XmlStream::Event event = xml.next();
      if (event == XmlStream::Event::Over) return true;
      if (event != XmlStream::Event::Begin) continue;
      if (xml.depth() == 1 && xml.name() != "osm") xml.fail("expected <osm>, here is <" + xml.name() + ">");
      if (xml.depth() == 2) visit(xml);
    }
  }

  // Which nodes matter: a first reading of the ways.
  void note(XmlStream& xml) {
    if (xml.name() != "way") return;
    const Element way = read(xml);
    if (way.road) {
      roads_.insert(roads_.end(), way.refs.begin(), way.refs.end());
      if (roads_.size() > compact_at_) {  // most nodes of roads are met once, crossings more often
        sort_unique(roads_);
        compact_at_ = roads_.size() + std::max(roads_.size() / 2, std::size_t{1} << 20U);
        if (roads_.size() > RoadGraph::most_nodes) xml.fail("expected at most 2^30 points of roads");
      }
    } else if (way.is_ring() && !way.names.empty()) {
      corners_.insert(corners_.end(), way.refs.begin(), way.refs.end());
      areas_.push_back({way.refs, {}});
      for (const std::string& name : way.names) areas_.back().propositions.push_back(landmarks_.number(name));
    }
  }

  void place(XmlStream& xml) {
    if (xml.name() == "node") return place_node(xml);
    if (xml.name() != "way") return;
    if (!numbered_) number_nodes();
    const Element way = read(xml);
    if (way.road) write_road(way);
  }
  void place_node(XmlStream& xml) {
    if (numbered_) xml.fail("a node behind the ways: sort the file (osmium sort)");
    const Element node = read(xml);
    for (const std::string& name : node.names) found_.push_back({node.at, landmarks_.number(name)});
    place_at(xml, roads_, at_, node);
    place_at(xml, corners_, corner_at_, node);
  }
  static void place_at(const XmlStream& xml, const std::vector<OsmId>& ids, std::vector<FixedPoint>& at,
                       const Element& node) {
    const auto found = std::lower_bound(ids.begin(), ids.end(), node.id);
    if (found == ids.end() || *found != node.id) return;
    FixedPoint& place = at[static_cast<std::size_t>(found - ids.begin())];
    if (place.longitude != unknown) xml.fail("two nodes have the id " + std::to_string(node.id));
    place = node.at;
  }

  Element read(XmlStream& xml) {
    Element out;
    const bool is_node = xml.name() == "node";
    const std::size_t depth = xml.depth();
    if (is_node) {
      out.id = id(xml, "id");
      out.at = {angle(xml, "lon", 180), angle(xml, "lat", 90)};
    }
    std::string highway, oneway, junction;
    for (XmlStream::Event event = xml.next(); event == XmlStream::Event::Begin || xml.depth() > depth;
         event = xml.next()) {
      if (event != XmlStream::Event::Begin) continue;
      if (xml.name() == "nd" && !is_node) out.refs.push_back(id(xml, "ref"));
      if (xml.name() != "tag") continue;
      const std::string_view key = xml.needed("k"), value = xml.needed("v");
      landmarks_.read(key, value, out.names);
      if (key == "highway") highway = value;
      if (key == "oneway") oneway = value;
      if (key == "junction") junction = value;
    }
    out.road = !is_node && !highway.empty();
    if (oneway == "-1" || oneway == "reverse")
      out.forward = false;
    else if (oneway == "yes" || oneway == "true" || oneway == "1" ||
             (oneway.empty() && (junction == "roundabout" || highway == "motorway")))
      out.backward = false;
    return out;
  }
  static OsmId id(XmlStream& xml, std::string_view attribute) {
    const std::string_view text = xml.needed(attribute);
    OsmId out = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), out);
    if (error != std::errc() || end != text.data() + text.size())
      xml.fail("expected a whole number, here is '" + std::string(text) + "'");
    return out;
  }
  static std::int32_t angle(XmlStream& xml, std::string_view attribute, int most) {
    const std::string_view text = xml.needed(attribute);
    double out = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), out);
    if (error != std::errc() || end != text.data() + text.size() || !(std::fabs(out) <= most))
      xml.fail("expected a longitude within ±180 and a latitude within ±90");
    return static_cast<std::int32_t>(std::lround(out * FixedPoint::degree));
  }

  // Nodes that the extract has; rings of areas, where it has all of them.
  void number_nodes() {
    numbered_ = true;
    std::size_t kept = 0;
    for (std::size_t i = 0; i < roads_.size(); ++i) {
      if (at_[i].longitude == unknown) continue;
      roads_[kept] = roads_[i];
      at_[kept++] = at_[i];
    }
    out_.missing = roads_.size() - kept;
    out_.nodes = kept;
    roads_.resize(kept);
    at_.resize(kept);
    if (kept == 0) fail("there is no road whose nodes stand before the ways");
    gr_ << heading();
  }
  const FixedPoint* corner(OsmId id) const {
    const std::size_t i =
        static_cast<std::size_t>(std::lower_bound(corners_.begin(), corners_.end(), id) - corners_.begin());
    return corner_at_[i].longitude == unknown ? nullptr : &corner_at_[i];
  }

  struct Area {
    std::vector<OsmId> refs;
    std::vector<std::uint32_t> propositions;
  };
  static constexpr std::uint32_t none = UINT32_MAX;
  std::uint32_t number(OsmId id) const {
    const auto found = std::lower_bound(roads_.begin(), roads_.end(), id);
    return found != roads_.end() && *found == id ? static_cast<std::uint32_t>(found - roads_.begin()) : none;
  }
  void write_road(const Element& way) {
    std::uint32_t last = none;
    for (const OsmId ref : way.refs) {
      const std::uint32_t here = number(ref);
      if (last != none && here != none && last != here) {
        const auto cost = std::llround(100 * metres(at_[last], at_[here]));
        if (way.forward) write_arc(last, here, cost);
        if (way.backward) write_arc(here, last, cost);
      }
      last = here;
    }
  }
  void write_arc(std::uint32_t from, std::uint32_t to, long long cost) {
    gr_ << "a " << from + 1 << ' ' << to + 1 << ' ' << cost << '\n';
    ++out_.arcs;
  }

  // Written before the arcs, and again, as long, when they are counted.
  std::string heading() const {
    const auto padded = [](std::uint64_t n) {
      const std::string digits = std::to_string(n);
      return std::string(12 - std::min<std::size_t>(12, digits.size()), ' ') + digits;
    };
    return "c points of roads of OpenStreetMap by their ids, costs in centimetres\np sp" + padded(out_.nodes) +
           padded(out_.arcs) + '\n';
  }
  void write_heading() {
    gr_.seekp(0);
    gr_ << heading();
    gr_.seekp(0, std::ios::end);
    co_ << "c longitude and latitude in 10^-7 degrees\np aux sp co " << out_.nodes << '\n';
    for (std::size_t v = 0; v < at_.size(); ++v)
      co_ << "v " << v + 1 << ' ' << at_[v].longitude << ' ' << at_[v].latitude << '\n';
  }

  using Label = std::pair<std::uint32_t, std::uint32_t>;  // node, proposition
  void write_labels() {
    const GlobePoints points(at_);
    std::vector<Label> labels;
    for (const auto& [at, proposition] : found_) labels.emplace_back(points.nearest(at), proposition);
    for (const Area& area : areas_) add_area(area, points, labels);
    sort_unique(labels);
    write_names(labels);
    std::set<std::vector<std::uint32_t>> letters;
    for (std::size_t i = 0; i < labels.size();) {
      const std::uint32_t node = labels[i].first;
      std::vector<std::uint32_t> letter;
      for (; i < labels.size() && labels[i].first == node; ++i) letter.push_back(labels[i].second);
      lab_ << node + 1 << ':';
      for (const std::uint32_t p : letter) lab_ << ' ' << p;
      lab_ << '\n';
      ++out_.labelled;
      letters.insert(std::move(letter));
      if (letters.size() == RoadGraph::most_letters) fail("2^16 different labels: choose some by name or tag");
    }
  }
  // Those that some node has; all that were asked for are among them.
  void write_names(const std::vector<Label>& labels) {
    std::vector<bool> used(landmarks_.names().size(), false);
    for (const auto& [node, p] : labels) used[p] = true;
    std::set<std::string> names;
    for (std::size_t p = 0; p < used.size(); ++p) {
      if (!used[p]) continue;
      lab_ << (names.empty() ? "" : " ") << p << "=\"" << landmarks_.names()[p] << '"';
      names.insert(landmarks_.names()[p]);
    }
    lab_ << '\n';
    out_.labels = names.size();
    const auto expect = [&](const std::string& name, const std::string& asked) {
      if (names.count(name) == 0) fail("there is no landmark '" + asked + "'");
    };
    for (const std::string& name : choice_.names) expect(name, name);
    for (const auto& [key, value] : choice_.tags) expect(landmark_name(value), key + '=' + value);
    if (names.empty()) fail("there is no landmark: nothing has a name that a formula could use");
  }
  void add_area(const Area& area, const GlobePoints& points, std::vector<Label>& labels) const {
    std::vector<FixedPoint> ring;
    for (const OsmId ref : area.refs) {
      const FixedPoint* const at = corner(ref);
      if (at == nullptr) return;
      ring.push_back(*at);
    }
    FixedPoint low = ring[0], high = ring[0];
    for (const FixedPoint& p : ring) {
      low = {std::min(low.longitude, p.longitude), std::min(low.latitude, p.latitude)};
      high = {std::max(high.longitude, p.longitude), std::max(high.latitude, p.latitude)};
    }
    points.for_each_in(low, high, [&](std::uint32_t node) {
      if (!is_inside(at_[node], ring)) return;
      for (const std::uint32_t p : area.propositions) labels.emplace_back(node, p);
    });
  }

  struct Found {  // at a node
    FixedPoint at;
    std::uint32_t proposition;
  };
  std::istream& osm_;
  std::string source_;
  const OsmChoice& choice_;
  Landmarks landmarks_;
  std::ostream &gr_, &co_, &lab_;
  std::vector<OsmId> roads_, corners_;      // ids of nodes on roads, and of corners of areas
  std::vector<FixedPoint> at_, corner_at_;  // their positions
  std::size_t compact_at_ = std::size_t{1} << 20U;
  std::vector<Area> areas_;
  std::vector<Found> found_;  // landmarks that are nodes
  bool numbered_ = false;
  OsmRoads out_;
};

}  // namespace

OsmRoads write_osm_roads(std::istream& osm, std::string_view source, const OsmChoice& choice, std::ostream& gr,
                         std::ostream& co, std::ostream& lab) {
  return OsmRoadsWriter(osm, source, choice, gr, co, lab).write();
}

}  // namespace waymark::plan

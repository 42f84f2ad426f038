#include "libplan/model/formats/read_case.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <optional>

#include "libltl/diagnostic.hpp"
#include "libltl/text/read_text.hpp"
#include "libplan/model/map_mdp.hpp"
#include "libplan/world/json_reader.hpp"

namespace waymark::plan {
namespace {

using Value = JsonReader::Value;

template <typename Enum, std::size_t N>
using Names = std::array<std::pair<std::string_view, Enum>, N>;

constexpr Names<CaseTask::Query, 8> queries{{{"pmax", CaseTask::Query::MaxProbability},
                                             {"pmin", CaseTask::Query::MinProbability},
                                             {"rmin", CaseTask::Query::MinCost},
                                             {"rmax", CaseTask::Query::MaxCost},
                                             {"steps", CaseTask::Query::MinSteps},
                                             {"cycle", CaseTask::Query::MinCycle},
                                             {"lasso", CaseTask::Query::LeastLasso},
                                             {"discounted", CaseTask::Query::Discounted}}};
constexpr Names<CaseTask::Logic, 4> logics{{{"ltl", CaseTask::Logic::Ltl},
                                            {"ltlf", CaseTask::Logic::Ltlf},
                                            {"pctl", CaseTask::Logic::Pctl},
                                            {"derived", CaseTask::Logic::Derived}}};
constexpr Names<std::uint32_t, 4> directions{{{"N", 0}, {"E", 1}, {"S", 2}, {"W", 3}}};

template <typename Enum, std::size_t N>
Enum named(const JsonReader& in, const Names<Enum, N>& names, const Value& value, const std::string& path) {
  const std::string given = in.string(value, path);
  std::string known;
  for (const auto& [name, meaning] : names) {
    if (name == given) return meaning;
    known += (known.empty() ? "" : ", ") + std::string(name);
  }
  in.fail(path, "expected one of " + known);
}

// What both formats share: the name, the tasks, the cost of a step.
class CaseReader {
 public:
  CaseReader(std::string_view text, std::string_view source) : in_(text, source) {}

  PlanningCase read() {
    const Value document = in_.parse();
    const std::string format = in_.string(in_.member(document, "", "format"), "format");
    std::string name = document.contains("name") ? in_.string(document["name"], "name") : "";
    if (format == "ltlgrid/1") return {std::move(name), grid(document), tasks(document)};
    if (format == "ltlmap/1") return {std::move(name), map(document), tasks(document)};
    in_.fail("format", "expected \"ltlgrid/1\" or \"ltlmap/1\"");
  }

 private:
  std::vector<CaseTask> tasks(const Value& document) const {
    std::vector<CaseTask> out;
    if (!document.contains("tasks")) return out;
    in_.each(document, "", "tasks", [&](const Value& value, const std::string& path) {
      in_.check_keys(value, path, {"id", "logic", "formula", "query"});
      CaseTask& task = out.emplace_back();
      task.id = in_.string(in_.member(value, path, "id"), path + ".id");
      task.formula = in_.string(in_.member(value, path, "formula"), path + ".formula");
      const Value &logic = in_.member(value, path, "logic"), &query = in_.member(value, path, "query");
      try {
        task.logic = named(in_, logics, logic, path + ".logic");
        task.query = named(in_, queries, query, path + ".query");
      } catch (const ltl::FormatError& error) {  // the other tasks have answers
        task.fault = error.what();
      }
    });
    return out;
  }

  double step_cost(const Value& document) const {
    if (!document.contains("cost")) return 1;
    const double cost = in_.number(in_.member(document["cost"], "cost", "step"), "cost.step");
    if (!(cost >= 0 && cost <= most_cost)) in_.fail("cost.step", "expected a cost from 0 to 1e100");
    return cost;
  }

  ltl::Letter letter(const Value& object, const std::string& path, ltl::Vocabulary& vocabulary,
                     const std::string& prefix = "") const {
    ltl::Letter out;
    if (!object.contains("props")) return out;
    in_.each(object, path, "props", [&](const Value& value, const std::string& here) {
      const std::string name = in_.string(value, here);
      if (name.empty()) in_.fail(here, "a proposition without a name");
      out.insert(vocabulary.add(prefix + name));
    });
    return out;
  }

  // ltlgrid/1

  SlipChances chances(const Value& motion, const std::string& path) const {
    in_.check_keys(motion, path, {"forward", "left", "right", "back", "blocked"});
    if (motion.contains("blocked") && in_.string(motion["blocked"], path + ".blocked") != "stay")
      in_.fail(path + ".blocked", "a blocked move can only \"stay\"");
    SlipChances out;
    out.forward = in_.number(in_.member(motion, path, "forward"), path + ".forward");
    const auto other = [&](const char* key) {
      return motion.contains(key) ? in_.number(motion[key], path + "." + key) : 0;
    };
    out.left = other("left");
    out.right = other("right");
    out.back = other("back");
    return out;
  }

  // One motion for all moves, or one for each: {"N": {"forward": …}, …}.
  std::array<SlipChances, 4> motion(const Value& document) const {
    std::array<SlipChances, 4> out;
    if (!document.contains("motion")) return out;
    const Value& value = document["motion"];
    const bool each = value.is_object() && value.contains("N");
    for (const auto& [name, d] : directions) {
      const std::string key(name);
      out[d] = each ? chances(in_.member(value, "motion", key), "motion." + key) : chances(value, "motion");
    }
    return out;
  }

  GridCell cell(const Value& value, const std::string& path, ltl::Vocabulary& vocabulary) const {
    if (!value.is_object()) in_.fail(path, "expected what the glyph means, such as {\"props\": [\"a\"]}");
    in_.check_keys(value, path, {"wall", "props", "oneway"});
    GridCell out;
    if (value.contains("wall")) {
      if (!value["wall"].is_boolean()) in_.fail(path + ".wall", "expected true or false");
      out.wall = value["wall"].get<bool>();
    }
    if (value.contains("oneway"))
      out.one_way = static_cast<Compass>(named(in_, directions, value["oneway"], path + ".oneway"));
    out.label = letter(value, path, vocabulary);
    return out;
  }

  struct Palette {
    std::vector<GridCell> cells;
    std::array<std::optional<std::uint16_t>, 256> of_glyph{};
  };
  Palette palette(const Value& document, ltl::Vocabulary& vocabulary) const {
    Palette out;
    const auto add = [&](const std::string& glyph, GridCell cell) {
      out.of_glyph[static_cast<unsigned char>(glyph[0])] = static_cast<std::uint16_t>(out.cells.size());
      out.cells.push_back(std::move(cell));
    };
    add(".", {});
    if (!document.contains("legend")) return out;
    if (!document["legend"].is_object()) in_.fail("legend", "expected an object: glyph → meaning");
    for (const auto& [glyph, value] : document["legend"].items()) {
      if (glyph.size() != 1) in_.fail("legend", "a glyph is one ASCII character, not \"" + glyph + "\"");
      add(glyph, cell(value, "legend." + glyph, vocabulary));
    }
    return out;
  }

  std::uint32_t size(const Value& document, const char* key) const {
    const int value = in_.integer(in_.member(document, "", key), key);
    if (value < 1) in_.fail(key, "expected a whole number from 1 on");
    return static_cast<std::uint32_t>(value);
  }

  GridWorld grid(const Value& document) const {
    in_.check_keys(
        document, "",
        {"format", "name", "width", "height", "rows", "legend", "start", "moves", "motion", "cost", "tasks"});
    if (document.contains("moves") && document["moves"] != Value({"N", "E", "S", "W"}))
      in_.fail("moves", R"(expected ["N", "E", "S", "W"])");
    GridWorld::Shape shape{size(document, "width"), size(document, "height"), motion(document), {}};
    shape.cost.fill(step_cost(document));
    ltl::Vocabulary vocabulary;
    const Palette kinds = palette(document, vocabulary);
    std::vector<std::uint16_t> cells;
    if (in_.member(document, "", "rows").size() != shape.height)
      in_.fail("rows", "expected " + std::to_string(shape.height) + " rows");
    in_.each(document, "", "rows", [&](const Value& value, const std::string& path) {
      const std::string row = in_.string(value, path);
      if (row.size() != shape.width) in_.fail(path, "expected " + std::to_string(shape.width) + " characters");
      for (char glyph : row) {
        const auto kind = kinds.of_glyph[static_cast<unsigned char>(glyph)];
        if (!kind) in_.fail(path, std::string("the glyph '") + glyph + "' is not in the legend");
        cells.push_back(*kind);
      }
    });
    const Value& start = in_.member(document, "", "start");
    const int x = in_.integer(in_.member(start, "start", "x"), "start.x");
    const int y = in_.integer(in_.member(start, "start", "y"), "start.y");
    if (x < 0 || y < 0 || x >= static_cast<int>(shape.width) || y >= static_cast<int>(shape.height))
      in_.fail("start", "the start is off the grid");
    std::optional<GridWorld> out;
    in_.at("", [&] {
      out.emplace(shape, vocabulary, kinds.cells, cells,
                  static_cast<std::uint32_t>(y) * shape.width + static_cast<std::uint32_t>(x));
    });
    return std::move(*out);
  }

  // ltlmap/1: nodes and hallways; a state is (node, heading), its number 4 · node + heading

  struct Hallway {
    std::optional<std::uint32_t> to;
    ltl::Letter ahead = {};  // face_P for every P that the hallway carries
  };
  struct MapGraph {
    std::map<int, std::uint32_t> index;  // by id
    std::vector<ltl::Letter> labels;
    std::vector<std::array<Hallway, 4>> ways;
  };

  std::uint32_t node_of(const MapGraph& graph, const Value& value, const std::string& path) const {
    const auto at = graph.index.find(in_.integer(value, path));
    if (at == graph.index.end()) in_.fail(path, "there is no node with that id");
    return at->second;
  }

  MapGraph graph(const Value& document, ltl::Vocabulary& vocabulary) const {
    MapGraph out;
    in_.each(document, "", "nodes", [&](const Value& value, const std::string& path) {
      const int id = in_.integer(in_.member(value, path, "id"), path + ".id");
      if (!out.index.emplace(id, static_cast<std::uint32_t>(out.labels.size())).second)
        in_.fail(path + ".id", "two nodes have this id");
      out.labels.push_back(letter(value, path, vocabulary));
    });
    out.ways.resize(out.labels.size());
    in_.each(document, "", "edges", [&](const Value& value, const std::string& path) {
      const std::uint32_t from = node_of(out, in_.member(value, path, "from"), path + ".from");
      const std::uint32_t to = node_of(out, in_.member(value, path, "to"), path + ".to");
      const std::uint32_t d = named(in_, directions, in_.member(value, path, "dir"), path + ".dir");
      const ltl::Letter ahead = letter(value, path, vocabulary, "face_");
      for (const auto& [a, b, heading] : {std::tuple{from, to, d}, std::tuple{to, from, (d + 2) % 4}}) {
        if (out.ways[a][heading].to) in_.fail(path, "two hallways leave a node in one direction");
        out.ways[a][heading] = {b, ahead};
      }
    });
    return out;
  }

  struct MapMotion {
    SlipChances forward;
    TurnChances left, right;
  };
  TurnChances turn_chances(const Value& motion, const std::string& action) const {
    TurnChances out;
    if (!motion.contains(action)) return out;
    const Value& value = motion[action];
    const std::string path = "motion." + action;
    in_.check_keys(value, path, {"stay", "beyond"});
    if (value.contains("stay")) out.stay = in_.number(value["stay"], path + ".stay");
    if (value.contains("beyond")) out.beyond = in_.number(value["beyond"], path + ".beyond");
    if (!(out.stay >= 0 && out.beyond >= 0 && out.stay + out.beyond < 1))
      in_.fail(path, "the chances of a turn leave nothing for turning");
    return out;
  }

  // Of the action forward, or for each action: {"forward": {"forward": …}, "left": {"stay": …}, "right": …}.
  MapMotion map_motion(const Value& document) const {
    MapMotion out;
    if (!document.contains("motion")) return out;
    const Value& value = document["motion"];
    if (value.is_object() && value.contains("forward") && value["forward"].is_number()) {
      out.forward = chances(value, "motion");
      return out;
    }
    in_.check_keys(value, "motion", {"forward", "left", "right"});
    if (value.contains("forward")) out.forward = chances(value["forward"], "motion.forward");
    out.left = turn_chances(value, "left");
    out.right = turn_chances(value, "right");
    return out;
  }

  // Outcomes of one action of a node and a heading, none of them twice.
  class Outcomes {
   public:
    void add(std::uint32_t state, double chance) {
      if (chance != 0) chance_[state] += chance;
    }
    template <class Visit>
    void for_each(const Visit& visit) const {
      for (const auto& [state, chance] : chance_) visit(state, chance);
    }

   private:
    std::map<std::uint32_t, double> chance_;
  };

  static Outcomes moved(const MapGraph& graph, std::uint32_t node, std::uint32_t heading, const SlipChances& slip) {
    Outcomes out;
    const std::array<double, 4> chance{slip.forward, slip.right, slip.back, slip.left};  // by turn to the right
    for (std::uint32_t turn = 0; turn < 4; ++turn)
      out.add(4 * graph.ways[node][(heading + turn) % 4].to.value_or(node) + heading, chance[turn]);
    return out;
  }
  static Outcomes turned(std::uint32_t node, std::uint32_t heading, std::uint32_t quarter, const TurnChances& slip) {
    Outcomes out;
    out.add(4 * node + heading, slip.stay);
    out.add(4 * node + (heading + quarter) % 4, 1 - slip.stay - slip.beyond);
    out.add(4 * node + (heading + 2) % 4, slip.beyond);
    return out;
  }

  Mdp map(const Value& document) const {
    in_.check_keys(document, "", {"format", "name", "nodes", "edges", "start", "actions", "motion", "cost", "tasks"});
    if (document.contains("actions") && document["actions"] != Value({"forward", "left", "right"}))
      in_.fail("actions", R"(expected ["forward", "left", "right"])");
    ltl::Vocabulary vocabulary;
    const MapGraph graph = this->graph(document, vocabulary);
    const double cost = step_cost(document);
    MdpBuilder builder(vocabulary);
    const auto letter = [&](std::uint32_t node, std::uint32_t heading) {
      ltl::Letter out = graph.labels[node];
      out.insert_all(graph.ways[node][heading].ahead);
      return builder.letter(out);
    };
    const MapMotion motion = map_motion(document);
    const auto add = [&](const char* action, const Outcomes& outcomes) {
      builder.add_choice(action, cost);
      outcomes.for_each([&](std::uint32_t state, double chance) {
        builder.add_outcome(state, letter(state / 4, state % 4), chance);
      });
    };
    for (const auto& [id, node] : in_order(graph.index))
      for (std::uint32_t heading = 0; heading < 4; ++heading) {
        builder.add_state(std::to_string(id) + ',' + std::string(directions[heading].first));
        if (graph.ways[node][heading].to) add("forward", moved(graph, node, heading, motion.forward));
        add("left", turned(node, heading, 3, motion.left));
        add("right", turned(node, heading, 1, motion.right));
      }
    const Value& start = in_.member(document, "", "start");
    const std::uint32_t node = node_of(graph, in_.member(start, "start", "node"), "start.node");
    const std::uint32_t heading = named(in_, directions, in_.member(start, "start", "heading"), "start.heading");
    const LetterId first = letter(node, heading);
    std::optional<Mdp> out;
    in_.at("motion", [&] { out = std::move(builder).build(4 * node + heading, first); });
    return std::move(*out);
  }

  // (id, node) in the order of the nodes.
  static std::vector<std::pair<int, std::uint32_t>> in_order(const std::map<int, std::uint32_t>& index) {
    std::vector<std::pair<int, std::uint32_t>> out(index.begin(), index.end());
    std::sort(out.begin(), out.end(), [](const auto& a, const auto& b) { return a.second < b.second; });
    return out;
  }

  const JsonReader in_;
};

}  // namespace

std::string_view name(CaseTask::Query query) {
  for (const auto& [name, q] : queries)
    if (q == query) return name;
  return {};
}

PlanningCase parse_case(std::string_view json, std::string_view source) { return CaseReader(json, source).read(); }

PlanningCase read_case(const std::filesystem::path& file) { return parse_case(ltl::read_text(file), file.string()); }

}  // namespace waymark::plan

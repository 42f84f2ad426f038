// waymark map: what a map knows: its places, what stands and hangs there, and its propositions with their meanings.
#include <algorithm>
#include <iostream>
#include <memory>
#include <string>
#include <vector>

#include "libltl/formula.hpp"
#include "libltl/text/print.hpp"
#include "libplan/world/labelling.hpp"
#include "libplan/world/observable_english.hpp"
#include "tools/answer.hpp"
#include "tools/shell/json.hpp"
#include "tools/shell/options.hpp"
#include "tools/shell/subcommand.hpp"

namespace waymark::tools {
namespace {

struct MapCommandOptions {
  std::string map = "grid", data;
  bool all = false, json = false;
};

// A proposition as formulas write it.
struct Named {
  std::string name, written, meaning;
  bool is_here = false;   // of the pose itself, not of what is ahead or at a side
  std::size_t poses = 0;  // whose label has it; an event is in the letters of actions
};

std::vector<Named> propositions_of(const plan::Map& map) {
  ltl::Arena arena(map.vocabulary());
  const auto describe = plan::hallway_english(map.vocabulary());
  const std::vector<plan::Observable> observables = plan::observables_of(map.vocabulary());
  std::vector<Named> out;
  for (std::uint32_t i = 0; i < map.vocabulary().size(); ++i) {
    const ltl::Proposition p{i};
    Named named{map.vocabulary().name(p), ltl::print(arena.atom(p)), describe(p).holds,
                observables[i].direction == plan::Direction::Here || observables[i].kind == plan::Kind::Event};
    for (std::uint32_t pose = 0; pose < map.poses(); ++pose)
      named.poses += map.label(plan::PoseId{pose}).contains(p) ? 1 : 0;
    out.push_back(std::move(named));
  }
  return out;
}

JsonObject map_json(const plan::Map& map, const std::vector<Named>& propositions) {
  const auto names = [](const std::vector<std::string>& all) {
    JsonArray out;
    for (const std::string& name : all) out.add(name);
    return out;
  };
  JsonArray places, list;
  for (const plan::Node& node : map.nodes()) {
    JsonObject place;
    place.add("x", node.x).add("y", node.y);
    if (node.object) place.add("object", *node.object);
    if (node.place) place.add("number", *node.place);
    places.add(place);
  }
  for (const Named& named : propositions)
    list.add(JsonObject().add("name", named.name).add("meaning", named.meaning).add("poses", named.poses));
  return JsonObject()
      .add("map", map.name())
      .add("poses", map.poses())
      .add("hallways", map.edges().size())
      .add("objects", names(map.objects()))
      .add("floors", names(map.floors()))
      .add("paintings", names(map.walls()))
      .add("places", places)
      .add("propositions", list);
}

std::string joined(const std::vector<std::string>& names) {
  std::string out;
  for (const std::string& name : names) out += (out.empty() ? "" : ", ") + name;
  return out.empty() ? "none" : out;
}

// "chair at (0,7), (1,10)"
std::string standing(const plan::Map& map) {
  std::vector<std::string> out;
  for (const std::string& object : map.objects()) {
    std::string places;
    for (const plan::Node& node : map.nodes())
      if (node.object == object)
        places += (places.empty() ? "" : " ") + ('(' + std::to_string(node.x) + ',' + std::to_string(node.y) + ')');
    if (!places.empty()) out.push_back(object + ' ' + places);
  }
  return joined(out);
}

void print_map(const plan::Map& map, const std::vector<Named>& propositions, bool all, const Terminal& terminal) {
  const auto line = [&](const std::string& label, const std::string& text) {
    std::cout << terminal.paint(Paint::Bold, label + std::string(13 - label.size(), ' ')) << text << '\n';
  };
  line("map", map.name() + ": " + counted(map.nodes().size(), "place") + ", " + counted(map.edges().size(), "hallway") +
                  ", " + counted(map.poses(), "pose"));
  line("objects", standing(map));
  line("floors", joined(map.floors()));
  line("paintings", joined(map.walls()));
  std::size_t width = 0, hidden = 0;
  const auto shows = [&](const Named& named) { return all || named.is_here; };
  for (const Named& named : propositions) {
    if (shows(named)) width = std::max(width, ltl::utf8_length(named.written));
    hidden += shows(named) ? 0 : 1;
  }
  std::cout << '\n' << terminal.paint(Paint::Bold, "in formulas") << '\n';
  for (const Named& named : propositions)
    if (shows(named))
      std::cout << "  " << named.written << std::string(width + 2 - ltl::utf8_length(named.written), ' ')
                << named.meaning << '\n';
  if (hidden > 0)
    std::cout << "  and " << counted(hidden, "proposition")
              << " more, of what is ahead, behind, next or at a side: --all\n";
}

ExitCode run_map(const MapCommandOptions& options, const Session& session) {
  const plan::Map map = read_map({options.map, options.data});
  const std::vector<Named> propositions = propositions_of(map);
  if (options.json)
    std::cout << map_json(map, propositions).text() << '\n';
  else
    print_map(map, propositions, options.all, session.out);
  return ExitCode::Done;
}

}  // namespace

Runner setup_map(Command command) {
  const auto options = std::make_shared<MapCommandOptions>();
  command.add_option("map", options->map, "a map that comes with waymark (grid, jelly, l) or a file")
      .type_name("MAP")
      .show_default();
  add_data_option(command, options->data);
  command.add_flag("--all", options->all, "list every proposition");
  command.add_flag("--json", options->json, "one JSON object, with every proposition");
  return [options](const Session& session) { return run_map(*options, session); };
}

}  // namespace waymark::tools

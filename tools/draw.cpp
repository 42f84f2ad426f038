// waymark draw: a map, alone or with a route on it, as a picture.
#include <memory>

#include "tools/corridor.hpp"
#include "tools/picture.hpp"
#include "tools/picture_files.hpp"
#include "tools/shell/options.hpp"
#include "tools/shell/subcommand.hpp"

namespace waymark::tools {
namespace {

struct DrawOptions {
  MapOptions map;
  NotationOptions notation;
  std::string route, formula, start;
  PictureFiles files;
};

// The plan of the formula on its map, as `waymark plan` would give it.
ExitCode draw_plan(const DrawOptions& options, const plan::Map& map, const Session& session) {
  ltl::Arena arena(map.vocabulary());
  const ltl::Formula formula = parse_formula({.text = options.formula, .source = ""}, arena,
                                             parse_options(options.notation, ltl::Unknown::Reject));
  const automata::Dfa dfa = translate(formula, session.stop);
  const CorridorRun corridor_run = run_corridor(map, dfa, formula, start_poses(options.start, map), session.stop);
  const std::optional<ShownRoute> route = shown(corridor_run);
  write_picture(drawn_whole({.map = &map, .dfa = &dfa, .formula = formula, .route = route}), options.files);
  if (route) return ExitCode::Done;
  complain("note", "the picture has no route: " + std::get<plan::Infeasible>(corridor_run.destination).reason);
  return ExitCode::No;
}

ExitCode run_draw(const DrawOptions& options, const Session& session) {
  if (!options.route.empty() && !options.formula.empty()) throw UsageError("give --route or --formula, not both");
  check_picture_files(options.files);
  const plan::Map map = read_map(options.map);
  if (!options.formula.empty()) return draw_plan(options, map, session);
  Picture picture{.map = &map};
  if (!options.route.empty())
    picture.route = plan::parse_walk(read_file(options.route), map, source_name(options.route));
  write_picture(drawn_whole(picture), options.files);
  return ExitCode::Done;
}

}  // namespace

Runner setup_draw(Command command) {
  const auto options = std::make_shared<DrawOptions>();
  add_map_options(command, options->map);
  command.add_option("--route", options->route, "a route or trajectory file (docs/formats); - is standard input")
      .type_name("FILE");
  command.add_option("--formula", options->formula, "plan this formula and draw its route and automaton")
      .type_name("TEXT");
  add_notation_options(command, options->notation);
  add_start_option(command, options->start);
  add_picture_options(command, options->files);
  return [options](const Session& session) { return run_draw(*options, session); };
}

}  // namespace waymark::tools

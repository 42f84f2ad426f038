// waymark draw: a map, alone or with a route on it, as a picture.
#include <CLI/App.hpp>
#include <memory>

#include "tools/render/page.hpp"
#include "tools/shell/options.hpp"
#include "tools/shell/output.hpp"
#include "tools/subcommand.hpp"

namespace waymark::tools {
namespace {

struct Options {
  MapOptions map;
  std::string route, svg;
};

ExitCode run_draw(const Options& options) {
  const plan::Map map = read_map(options.map);
  render::Page page{.map = &map};
  page.caption = "map " + map.name();
  if (!options.route.empty())
    page.route = plan::parse_trajectory(read_file(options.route), map, source_name(options.route));
  write_file(options.svg, render::draw_page(page));
  return ExitCode::Done;
}

}  // namespace

Runner setup_draw(CLI::App& command) {
  const auto options = std::make_shared<Options>();
  add_map_options(command, options->map);
  command
      .add_option("--route", options->route, "a route or trajectory file (docs/formats); - is standard input")
      ->type_name("FILE");
  command.add_option("--svg", options->svg, "the picture; - is standard output")
      ->type_name("FILE")
      ->required();
  return [options](const Session&) { return run_draw(*options); };
}

}  // namespace waymark::tools

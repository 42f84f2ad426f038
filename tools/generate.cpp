// waymark generate map and roads: random maps to plan on (ltlgrid/1, our map format, DIMACS roads).
#include <iostream>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "libplan/model/formats/generate_grid.hpp"
#include "libplan/model/formats/generate_roads.hpp"
#include "libplan/world/generate_hallways.hpp"
#include "tools/shell/exit_code.hpp"
#include "tools/shell/output_file.hpp"
#include "tools/shell/subcommand.hpp"

namespace waymark::tools {
namespace {

struct GenerateCommandOptions {
  std::string kind = "rooms", out;
  plan::GridRecipe recipe;
  plan::RoadRecipe roads;
};

// Three files, far larger than memory should hold: written as they are made, then given their names.
ExitCode run_generate_roads(const GenerateCommandOptions& options) {
  OutputFile gr(options.out + ".gr"), co(options.out + ".co"), lab(options.out + ".lab");
  try {
    plan::generate_roads(options.roads, gr.stream(), co.stream(), lab.stream());
  } catch (const std::invalid_argument& error) {
    throw UsageError(error.what());
  }
  gr.finish();
  co.finish();
  lab.finish();
  return ExitCode::Done;
}

ExitCode run_generate(const GenerateCommandOptions& options) {
  plan::GridRecipe recipe = options.recipe;
  for (plan::GridKind kind : plan::all_grid_kinds)
    if (plan::name(kind) == options.kind) recipe.kind = kind;
  try {
    if (options.kind == "hallway") {
      if (recipe.tasks || recipe.noise != 0) throw UsageError("hallways come without --tasks and --noise");
      std::cout << plan::generate_hallways(
          {.width = recipe.width, .height = recipe.height, .objects = recipe.landmarks, .seed = recipe.seed});
      return ExitCode::Done;
    }
    plan::write_case(std::cout, plan::generate_grid(recipe));
  } catch (const std::invalid_argument& error) {
    throw UsageError(error.what());
  }
  return ExitCode::Done;
}

void add_map_recipe(Command command, GenerateCommandOptions& options) {
  std::vector<std::string> kinds{"hallway"};
  for (plan::GridKind kind : plan::all_grid_kinds) kinds.emplace_back(plan::name(kind));
  command.add_option("--kind", options.kind, "what it looks like").one_of(kinds).show_default();
  command.add_option("--width", options.recipe.width, "cells from west to east").show_default();
  command.add_option("--height", options.recipe.height, "cells from north to south").show_default();
  command.add_option("--landmarks", options.recipe.landmarks, "a, b, …; objects of hallways").show_default();
  command.add_option("--noise", options.recipe.noise, "chance to slip, to each side; back as well among hazards")
      .show_default();
  command.add_option("--seed", options.recipe.seed, "the same seed, the same map").show_default();
  command.add_flag("--tasks", options.recipe.tasks, "with tasks about the landmarks");
}

void add_road_recipe(Command command, GenerateCommandOptions& options) {
  command.add_option("--nodes", options.roads.nodes, "junctions and points between them").show_default();
  command.add_option("--landmarks", options.roads.landmarks, "a, b, …, at junctions").show_default();
  command.add_option("--avoided", options.roads.avoided, "part of the country that is x, and that is y").show_default();
  command.add_option("--seed", options.roads.seed, "the same seed, the same roads").show_default();
  command.add_option("--out", options.out, "write PREFIX.gr, PREFIX.co and PREFIX.lab").type_name("PREFIX").required();
}

}  // namespace

Runner setup_generate(Command command) {
  const auto options = std::make_shared<GenerateCommandOptions>();
  add_map_recipe(command.add_subcommand("map", "a map with landmarks"), *options);
  Command roads = command.add_subcommand("roads", "roads of a made-up country, in the files of DIMACS");
  add_road_recipe(roads, *options);
  command.add_subcommand("corpus", corpus_summary);  // which waymark-lab runs
  return [options, roads](const Session&) {
    return roads.parsed() ? run_generate_roads(*options) : run_generate(*options);
  };
}

}  // namespace waymark::tools

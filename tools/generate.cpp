// waymark generate map: random maps to plan on (ltlgrid/1 or our map format).
#include <iostream>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "libplan/model/formats/generate_grid.hpp"
#include "libplan/world/generate_hallways.hpp"
#include "tools/shell/exit_code.hpp"
#include "tools/shell/subcommand.hpp"

namespace waymark::tools {
namespace {

struct GenerateCommandOptions {
  std::string kind = "rooms";
  plan::GridRecipe recipe;
};

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

}  // namespace

Runner setup_generate(Command command) {
  const auto options = std::make_shared<GenerateCommandOptions>();
  add_map_recipe(command.add_subcommand("map", "a map with landmarks"), *options);
  command.add_subcommand("corpus", corpus_summary);  // which waymark-lab runs
  return [options](const Session&) { return run_generate(*options); };
}

}  // namespace waymark::tools

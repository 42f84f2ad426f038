// waymark ground: instruction → formulas, best first.
#include <CLI/App.hpp>
#include <iostream>
#include <memory>

#include "libltl/print.hpp"
#include "libparser/ground.hpp"
#include "tools/answer.hpp"
#include "tools/shell/batch.hpp"
#include "tools/shell/models.hpp"
#include "tools/shell/options.hpp"
#include "tools/subcommand.hpp"

namespace waymark::tools {
namespace {

struct Options {
  TextOptions text;
  MapOptions map;
  ModelOptions model;
  std::string start;
  std::size_t top = 5;
  bool json = false;
};

Json json_of(const std::string& instruction, const std::vector<parser::Reading>& readings,
             const plan::Map& map) {
  JsonArray array;
  for (const parser::Reading& reading : readings)
    array.add(
        JsonObject().add("formula", ltl::print(reading.formula)).add("probability", reading.probability));
  return JsonObject()
      .add("instruction", instruction)
      .add("map", map.name())
      .add("formula", ltl::print(readings.front().formula))
      .add("readings", array);
}

ExitCode ground_one(const Text& text, const Options& options, const Session& session,
                    const parser::Grounder& model, const plan::Map& map) {
  ltl::Arena arena(map.vocabulary());
  auto readings = read_instruction(model, text, map, start_poses(options.start, map), arena);
  readings.resize(std::min(readings.size(), std::max<std::size_t>(options.top, 1)), readings.front());
  if (options.json) {
    std::cout << json_of(text.text, readings, map).text() << '\n';
  } else {
    for (const parser::Reading& reading : readings)
      std::cout << fixed(reading.probability, 4) << "  " << shown(reading.formula, session.out) << '\n';
  }
  return ExitCode::Done;
}

ExitCode run_ground(const Options& options, const Session& session) {
  TextReader texts(options.text, "instruction");
  const parser::Grounder model = read_model(options.model, options.map.data);
  const plan::Map map = read_map(options.map);
  return answer_each(
      texts, session.stop, [&](const Text& text) { return ground_one(text, options, session, model, map); },
      [&](const Text& text, const std::string& message) {
        if (options.json) std::cout << json_error(text.line, message).text() << '\n';
      });
}

}  // namespace

Runner setup_ground(CLI::App& command) {
  const auto options = std::make_shared<Options>();
  add_text_options(command, options->text, "instruction");
  add_map_options(command, options->map);
  add_model_options(command, options->model);
  add_start_option(command, options->start);
  command.add_option("--top", options->top, "how many readings to show")
      ->type_name("K")
      ->capture_default_str();
  command.add_flag("--json", options->json, "one JSON object a line");
  return [options](const Session& session) { return run_ground(*options, session); };
}

}  // namespace waymark::tools

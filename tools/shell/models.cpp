#include "tools/shell/models.hpp"

#include <CLI/App.hpp>

#include "libltl/diagnostic.hpp"
#include "libparser/weights_file.hpp"
#include "libplan/world/read_map.hpp"
#include "tools/shell/data_directory.hpp"

namespace waymark::tools {

void add_model_options(CLI::App& command, ModelOptions& options) {
  command
      .add_option("--model-file", options.file,
                  "a model of one's own (else models/linear.waymark of the data)")
      ->type_name("FILE");
}

parser::LinearModel read_model(const ModelOptions& options, const std::string& data) {
  const std::string file =
      options.file.empty() ? (data_directory(data) / "models" / "linear.waymark").string() : options.file;
  return parser::parse_linear_model(read_file(file), file);
}

void add_model_kind_option(CLI::App& command, std::string& kind) {
  command.add_option("--model", kind, "kind of model")
      ->check(CLI::IsMember({"linear"}))
      ->capture_default_str();
}

void add_training_options(CLI::App& command, parser::TrainOptions& options) {
  command.add_option("--seed", options.seed, "same seed, same machine, same bytes")
      ->type_name("N")
      ->capture_default_str();
  command.add_option("--epochs", options.epochs, "passes over the sentences")
      ->type_name("N")
      ->check(CLI::Range(1, 1000))
      ->capture_default_str();
  command
      .add_option_function<std::string>(
          "--then",
          [&options](const std::string& meaning) {
            options.then = meaning == "stepwise" ? parser::Then::Stepwise : parser::Then::WholePlan;
          },
          "what 'then' means: whole-plan (the default) or stepwise")
      ->type_name("MEANING")
      ->check(CLI::IsMember({"whole-plan", "stepwise"}));
  command.add_option("--threads", options.threads, "of no influence on the result")
      ->type_name("N")
      ->check(CLI::Range(1, 256))
      ->capture_default_str();
}

std::vector<plan::Map> maps_of(const parser::Corpus& corpus, const std::string& data) {
  if (!corpus.maps.empty()) return corpus.maps;
  const auto directory = data_directory(data);
  std::vector<plan::Map> maps;
  for (const std::string& name : plan::shipped_maps(directory))
    maps.push_back(plan::read_map(name, directory));
  return maps;
}

std::vector<parser::Reading> read_instruction(const parser::LinearModel& model, const Text& text,
                                              const plan::Map& map, std::span<const plan::PoseId> starts,
                                              ltl::Arena& arena) {
  auto readings = parser::ground(model, text.text, map, starts, arena);
  if (readings.empty())
    throw ltl::FormatError(text.source, text.source.empty() ? 0 : text.line, 0,
                           "the instruction '" + text.text + "' has no word that could be read");
  return readings;
}

}  // namespace waymark::tools

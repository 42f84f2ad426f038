// waymark generate corpus: instructions of our own over maps, with their trajectories and formulas.
#include <filesystem>
#include <iostream>
#include <memory>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "libparser/corpus/corpus_file.hpp"
#include "libparser/corpus/corpus_output.hpp"
#include "libparser/language/generate.hpp"
#include "tools/shell/data_directory.hpp"
#include "tools/shell/models.hpp"
#include "tools/shell/options.hpp"
#include "tools/shell/output.hpp"
#include "tools/shell/subcommand.hpp"

namespace waymark::tools {
namespace {

struct GenerateCorpusOptions {
  parser::GenerateOptions recipe{.dialect = parser::Dialect::Temporal, .most_clauses = 3};
  std::vector<std::string> maps;
  std::string data, out, format = "jsonl", clauses = "1..3", formulas = "all";
  bool plain = false;
};

std::filesystem::path map_file(const std::string& name, const std::string& data) {
  return std::filesystem::exists(name) ? std::filesystem::path(name) : data_directory(data) / "maps" / (name + ".json");
}

parser::GenerateOptions recipe_of(const GenerateCorpusOptions& options) {
  parser::GenerateOptions recipe = options.recipe;
  std::istringstream clauses(options.clauses);
  char first = 0, second = 0;
  if (!(clauses >> recipe.least_clauses >> first >> second >> recipe.most_clauses) || first != '.' || second != '.' ||
      !clauses.eof() || recipe.least_clauses < 1 || recipe.least_clauses > recipe.most_clauses ||
      recipe.most_clauses > 12)
    throw UsageError("--clauses '" + options.clauses + "': expected FEWEST..MOST, 1 to 12");
  if (options.plain) recipe.dialect = parser::Dialect::Plain;
  if (options.formulas == "known") recipe.formulas = parser::Formulas::Known;
  if (options.formulas == "held-out") recipe.formulas = parser::Formulas::HeldOut;
  return recipe;
}

ExitCode generate_corpus(const GenerateCorpusOptions& options) {
  std::vector<plan::Map> maps;
  for (const std::string& name : options.maps) maps.push_back(plan::read_map(name, data_directory(options.data)));
  if (maps.empty()) maps = shipped_maps(options.data);
  parser::Corpus corpus;
  try {
    corpus = parser::generate_corpus(maps, recipe_of(options));
  } catch (const std::invalid_argument& error) {
    throw UsageError(error.what());
  }
  if (options.out.empty()) {
    std::cout << (options.format == "tsv" ? parser::pairs_text(corpus) : parser::json_lines(corpus));
    return ExitCode::Done;
  }
  const std::filesystem::path folder = options.out;
  std::vector<std::string> texts;  // read first: a map may be one of those that are removed
  for (const std::string& map : options.maps) texts.push_back(read_file(map_file(map, options.data).string()));
  make_directory(options.maps.empty() ? folder : folder / "maps");
  for (const std::filesystem::path& older : parser::map_files(folder)) remove_file(older);  // they would be read, too
  for (std::size_t m = 0; m < texts.size(); ++m) write_file(folder / "maps" / (maps[m].name() + ".json"), texts[m]);
  write_file(folder / "pairs.tsv", parser::pairs_text(corpus));
  write_file(folder / "instructions.jsonl", parser::json_lines(corpus));
  std::cout << options.out << ": " << corpus.paragraphs.size() << " paragraphs, " << corpus.sentences()
            << " sentences\n";
  return ExitCode::Done;
}

void add_recipe(Command command, GenerateCorpusOptions& options) {
  command.add_option("--map", options.maps, "a shipped map or a file, several times; else all shipped maps")
      .type_name("MAP");
  add_data_option(command, options.data);
  command.add_option("--out", options.out, "write instructions.jsonl, pairs.tsv and the maps named there")
      .type_name("DIR");
  command.add_option("--format", options.format, "without --out, on standard output")
      .one_of({"jsonl", "tsv"})
      .show_default();
  command.add_option("--paragraphs", options.recipe.paragraphs, "spread over the maps")
      .between(1, 1'000'000)
      .show_default();
  command.add_option("--sentences", options.recipe.sentences, "of each paragraph").between(1, 1000).show_default();
  command.add_option("--clauses", options.clauses, "of each sentence").type_name("FEWEST..MOST").show_default();
  command
      .add_option("--formulas", options.formulas,
                  "one formula in five is held out, the same for every seed: all, known, held-out")
      .one_of({"all", "known", "held-out"})
      .show_default();
  command.add_flag("--plain", options.plain, "without past, second, until, without, before, after, if");
  command
      .add_option("--refused", options.recipe.judged.refused, "up to so many trajectories that each sentence refuses")
      .between(0, 1000)
      .show_default();
  command
      .add_option("--also-good", options.recipe.judged.also_good,
                  "up to so many further trajectories that each sentence allows")
      .between(0, 1000)
      .show_default();
  command.add_option("--seed", options.recipe.seed, "the same seed, the same corpus").show_default();
}

}  // namespace

Runner setup_generate_corpus(Command command) {
  const auto options = std::make_shared<GenerateCorpusOptions>();
  add_recipe(command.add_subcommand("corpus", corpus_summary), *options);
  return [options](const Session&) { return generate_corpus(*options); };
}

}  // namespace waymark::tools

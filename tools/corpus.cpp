// waymark corpus: what a corpus holds, of hallways or of streets.
#include <iomanip>
#include <iostream>
#include <memory>

#include "libparser/corpus/sail_corpus.hpp"
#include "libparser/corpus/statistics.hpp"
#include "libparser/domain/streets/street_corpus.hpp"
#include "tools/shell/json.hpp"
#include "tools/shell/subcommand.hpp"

namespace waymark::tools {
namespace {

using parser::CorpusStatistics;

struct CorpusOptions {
  std::string directory;
  bool json = false;
};

struct Row {
  const char* name;
  const char* key;
  Json (*value)(const CorpusStatistics&);
  int digits;  // shown in the table
  double (*number)(const CorpusStatistics&);
};

template <auto Member>
Json value(const CorpusStatistics& s) {
  return (s.*Member)();
}
template <auto Member>
double number(const CorpusStatistics& s) {
  return static_cast<double>((s.*Member)());
}
template <auto Member>
constexpr Row row(const char* name, const char* key, int digits) {
  return {name, key, value<Member>, digits, number<Member>};
}

constexpr Row corpus_rows[] = {
    row<&CorpusStatistics::sequences>("sequences", "sequences", 0),
    row<&CorpusStatistics::unsegmented>("  of them without sentences", "unsegmented", 0),
    row<&CorpusStatistics::sentences>("sentences", "sentences", 0),
    row<&CorpusStatistics::sentences_per_sequence>("sentences a sequence", "sentences_per_sequence", 2),
    row<&CorpusStatistics::tokens_per_sentence>("tokens a sentence", "tokens_per_sentence", 2),
    row<&CorpusStatistics::vocabulary>("vocabulary", "vocabulary", 0),
    row<&CorpusStatistics::average_trajectory>("average trajectory", "average_trajectory", 2),
    row<&CorpusStatistics::longest_trajectory>("longest trajectory", "longest_trajectory", 0),
};

Json corpus_json(const CorpusStatistics& statistics) {
  JsonObject out;
  for (const Row& row : corpus_rows) out.add(row.key, row.value(statistics));
  return out;
}

void print_table(const parser::StatisticsByMap& statistics) {
  constexpr int name_width = 30, width = 14;
  std::cout << std::left << std::setw(name_width) << "" << std::right;
  for (const auto& [map, unused] : statistics.by_map) std::cout << std::setw(width) << map;
  std::cout << std::setw(width) << "all" << '\n';
  for (const Row& row : corpus_rows) {
    std::cout << std::left << std::setw(name_width) << row.name << std::right;
    for (const auto& [map, one] : statistics.by_map)
      std::cout << std::setw(width) << fixed(row.number(one), row.digits);
    std::cout << std::setw(width) << fixed(row.number(statistics.all), row.digits) << '\n';
  }
}

parser::StatisticsByMap statistics_of(const streets::StreetCorpus& corpus) {
  parser::StatisticsByMap out;  // an instruction is a sequence of one sentence
  for (const streets::StreetInstruction& instruction : corpus.instructions)
    for (CorpusStatistics* one : {&out.by_map[corpus.maps[instruction.map].name], &out.all}) {
      one->add_sequence(1);
      one->add_sentence(instruction.tokens, instruction.path.size());
    }
  return out;
}

ExitCode run_corpus(const CorpusOptions& options) {
  const bool streets = streets::is_street_corpus(options.directory);
  const parser::StatisticsByMap statistics = streets ? statistics_of(streets::read_street_corpus(options.directory))
                                                     : parser::statistics(parser::read_sail_corpus(options.directory));
  if (!options.json) {
    print_table(statistics);
    return ExitCode::Done;
  }
  JsonObject by_map, out;
  out.add("kind", streets ? "streets" : "hallways");
  for (const Row& row : corpus_rows) out.add(row.key, row.value(statistics.all));
  for (const auto& [map, one] : statistics.by_map) by_map.add(map, corpus_json(one));
  std::cout << out.add("by_map", by_map).text() << '\n';
  return ExitCode::Done;
}

}  // namespace

Runner setup_corpus(Command command) {
  const auto options = std::make_shared<CorpusOptions>();
  command.add_option("directory", options->directory, "holds instructions.jsonl and maps/").type_name("DIR").required();
  command.add_flag("--json", options->json, "one JSON object");
  return [options](const Session&) { return run_corpus(*options); };
}

}  // namespace waymark::tools

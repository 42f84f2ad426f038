// Every finished part is kept, so that a run that was killed goes on after it and ends with the same bytes.
#include "tools/lab/compare_systems.hpp"

#include <iostream>

#include "libltl/text/xxhash.hpp"
#include "libparser/experiment/evaluate.hpp"
#include "tools/shell/input.hpp"
#include "tools/shell/learning.hpp"
#include "tools/shell/models.hpp"
#include "tools/shell/results_table.hpp"

namespace waymark::tools {
namespace {

// One system of the table; what several members are together stands in a row of its own.
struct System {
  const char* name;
  const char* parts;  // with which the names of its checkpoints begin
  parser::ReaderKind reader;
  bool actions, reranker, ensemble;
};

// Systems of one kind of reader share it, with a reranker and without.
constexpr System all_systems[] = {
    {"actions", "actions", parser::ReaderKind::EncoderDecoder, true, false, false},
    {"linear", "linear", parser::ReaderKind::Linear, false, true, false},
    {"encoder-decoder, no reranker", "encoder-decoder", parser::ReaderKind::EncoderDecoder, false, false, true},
    {"encoder-decoder", "encoder-decoder", parser::ReaderKind::EncoderDecoder, false, true, true},
};

struct Held {  // what is learned from and tested on
  parser::Corpus corpus;
  std::optional<parser::Corpus> test;
  std::vector<plan::Map> maps;
};

// All that a part depends on: another build may round or search otherwise.
std::string settings_of(const CompareSystemsOptions& options, const Held& held) {
  std::string out = "table4\ncorpus " + hexadecimal(held.corpus.checksum) + '\n';
  if (held.test) out += "test corpus " + hexadecimal(held.test->checksum) + '\n';
  out += "seed " + std::to_string(options.train.seed) + "\nensemble " + std::to_string(options.ensemble) + '\n';
  if (options.epochs > 0) out += "epochs " + std::to_string(options.epochs) + '\n';
  out += "place numbers " + told_or_hidden(options.tell_place_numbers) + '\n';
  out += "version " + std::string(WAYMARK_VERSION) + '\n';
  out += "program " + hexadecimal(ltl::xxh64(read_file("/proc/self/exe"))) + '\n';
  return out;
}

parser::EvaluateOptions options_for(const System& system, const CompareSystemsOptions& options,
                                    const parser::Checkpoints& checkpoints) {
  parser::EvaluateOptions out;
  out.train = options.train;
  out.train.reader = system.reader;
  out.train.reranker = system.reranker;
  if (options.epochs > 0) out.train.epochs = out.train.network.epochs = options.epochs;
  out.absolute = options.absolute;
  out.relative = options.relative;
  out.actions = system.actions;
  out.ensemble = system.ensemble ? options.ensemble : 1;
  out.checkpoints = &checkpoints;
  out.system = system.parts;
  return out;
}

std::vector<ResultRow> rows_of(const CompareSystemsOptions& options, const Held& held, const Session& session) {
  const parser::Checkpoints checkpoints(options.directory, settings_of(options, held));
  std::vector<ResultRow> rows;
  for (const System& system : all_systems) {
    parser::EvaluateOptions how = options_for(system, options, checkpoints);
    how.train.stop = session.stop;
    ProgressBar bar;
    how.train.progress = [&](double fraction, std::string_view what) {
      bar.show(fraction, std::string(system.name) + ": " + std::string(what));
    };
    const parser::Evaluation evaluation =
        parser::evaluate_leave_one_map_out(held.corpus, held.test ? &*held.test : nullptr, held.maps, how);
    bar.wipe();
    const bool together = evaluation.singles.size() > 1;
    rows.push_back({system.name, together ? evaluation.singles : std::vector{evaluation.all}});
    if (together) rows.push_back({"  " + std::to_string(how.ensemble) + " of them that vote", {evaluation.all}});
    std::cerr << system.name << ": done\n";
  }
  rows.push_back(
      {"who stays put",
       {scores_of_staying(held.test ? *held.test : held.corpus, held.maps, options.absolute, options.relative)}});
  return rows;
}

void print_json(const CompareSystemsOptions& options, const Held& held, const std::vector<ResultRow>& rows) {
  JsonArray list;
  for (const ResultRow& row : rows) list.add(json_of(row));
  std::cout << JsonObject()
                   .add("table", "table4")
                   .add("corpus", hexadecimal(held.corpus.checksum))
                   .add("seed", options.train.seed)
                   .add("place_numbers", told_or_hidden(options.tell_place_numbers))
                   .add("rows", list)
                   .add("published", published_results())
                   .text()
            << '\n';
}

}  // namespace

ExitCode compare_systems(const CompareSystemsOptions& options, const Session& session) {
  Held held{read_hallway_corpus(options.corpus, options.tell_place_numbers), {}, {}};
  if (!options.test_corpus.empty()) held.test = read_hallway_corpus(options.test_corpus, options.tell_place_numbers);
  held.maps = maps_of(held.corpus, options.data);
  const std::vector<ResultRow> rows = learn_from(options.corpus, [&] { return rows_of(options, held, session); });
  if (options.json) {
    print_json(options, held, rows);
    return ExitCode::Done;
  }
  print_results("one map left out, weighted", rows);
  print_published_results();
  return ExitCode::Done;
}

}  // namespace waymark::tools

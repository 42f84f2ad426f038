// waymark train: corpus → model, learnt from trajectories alone; or pairs of sentence and formula → model.
#include <iostream>
#include <memory>

#include "libparser/annotations.hpp"
#include "libparser/corpus/corpus_file.hpp"
#include "libparser/corpus/corpus_output.hpp"
#include "libparser/language/generate.hpp"
#include "libparser/learn.hpp"
#include "libparser/weights_file.hpp"
#include "tools/corridor.hpp"
#include "tools/formula_table.hpp"
#include "tools/learning.hpp"
#include "tools/shell/models.hpp"
#include "tools/shell/options.hpp"
#include "tools/shell/output.hpp"
#include "tools/subcommand.hpp"

namespace waymark::tools {
namespace {

struct Options {
  std::string corpus, supervised, out = "model.waymark", data, convention = "absolute";
  TrainingOptions training;
  bool json = false;
};

// Of a corpus, of pairs, or of our own language when neither is named.
struct Lessons {
  parser::Corpus corpus;
  std::vector<plan::Map> maps;
  std::vector<parser::Annotation> pairs;
  std::uint64_t checksum = 0;
  std::size_t sentences = 0;
};

Lessons lessons_of(const Options& options, parser::Dialect dialect) {
  Lessons lessons;
  if (!options.supervised.empty()) {
    const std::string text = read_file(options.supervised);
    lessons.maps = shipped_maps(options.data);
    if (lessons.maps.empty())
      throw ltl::FormatError(options.data, 0, 0, "there are no maps whose vocabulary formulas could be over");
    parser::Annotations annotations = parser::parse_annotations(text, lessons.maps.front().vocabulary(),
                                                                dialect, source_name(options.supervised));
    report_refused(annotations, options.supervised);
    if (annotations.pairs.empty())
      throw ltl::FormatError(source_name(options.supervised), 0, 0, "holds no pair to learn from");
    lessons.pairs = std::move(annotations.pairs);
    lessons.checksum = parser::fnv1a(text);
    lessons.sentences = lessons.pairs.size();
    return lessons;
  }
  if (options.corpus.empty()) {
    lessons.corpus = parser::generate_corpus(shipped_maps(options.data), parser::own_language);
    lessons.corpus.checksum = parser::fnv1a(parser::json_lines(lessons.corpus));
  } else {
    lessons.corpus = read_hallway_corpus(options.corpus);
  }
  lessons.maps = maps_of(lessons.corpus, options.data);
  lessons.checksum = lessons.corpus.checksum;
  lessons.sentences = lessons.corpus.sentences();
  return lessons;
}

void report(const Options& options, const parser::TrainOptions& train, const Lessons& lessons,
            std::size_t bytes, double seconds) {
  const bool supervised = !options.supervised.empty();
  if (options.json)
    std::cout << JsonObject()
                     .add("model", options.training.model)
                     .add("out", options.out)
                     .add("paragraphs", lessons.corpus.paragraphs.size())
                     .add("sentences", lessons.sentences)
                     .add("corpus_checksum", hexadecimal(lessons.checksum))
                     .add("seed", train.seed)
                     .add("convention", options.convention)
                     .add("bytes", bytes)
                     .add("seconds", seconds)
                     .text()
              << '\n';
  else
    std::cout << "trained " << options.training.model << " on " << lessons.sentences << " sentences "
              << (supervised ? "with their formulas"
                             : "of " + std::to_string(lessons.corpus.paragraphs.size()) + " paragraphs")
              << " (checksum " << hexadecimal(lessons.checksum) << ", "
              << (supervised ? "" : "unknown headings " + options.convention + ", ") << "seed " << train.seed
              << "), " << bytes << " bytes, " << fixed(seconds, 1) << " s: " << options.out << '\n';
}

ExitCode run_train(const Options& options, const Session& session) {
  StopWatch watch;
  if (!options.corpus.empty() && !options.supervised.empty())
    throw UsageError("--corpus and --supervised: learning from trajectories, or from formulas?");
  check_writable(options.out);
  parser::TrainOptions train =
      options.training.settled(options.corpus.empty() ? parser::Dialect::Temporal : parser::Dialect::Plain);
  train.stop = session.stop;
  train.convention =
      options.convention == "relative" ? parser::Convention::Relative : parser::Convention::Absolute;
  ProgressBar bar;
  train.progress = [&](double fraction, std::string_view what) { bar.show(fraction, what); };
  const Lessons lessons = lessons_of(options, train.dialect);
  const std::string& source = options.supervised.empty() ? options.corpus : options.supervised;
  const parser::Grounder grounder = learn_from(source, [&] {
    return lessons.pairs.empty() ? parser::train(lessons.corpus, lessons.maps, train)
                                 : parser::train_supervised(lessons.pairs, lessons.maps.front(), train);
  });
  const std::string bytes = parser::serialize_within(grounder, parser::most_bytes);
  bar.wipe();
  write_file(options.out, bytes);
  report(options, train, lessons, bytes.size(), watch.lap());
  return ExitCode::Done;
}

}  // namespace

Runner setup_train(Command command) {
  const auto options = std::make_shared<Options>();
  add_corpus_option(command, options->corpus, false);
  command
      .add_option("--supervised", options->supervised,
                  "learn from lines 'sentence TAB formula' instead, over the vocabulary of the shipped maps")
      .type_name("FILE");
  add_data_option(command, options->data);
  command.add_option("--out", options->out, "the model file; written whole or not at all")
      .type_name("FILE")
      .show_default();
  add_training_options(command, options->training, {"linear", "encoder-decoder"});
  add_convention_option(command, options->convention, {"absolute", "relative"});
  command.add_flag("--json", options->json, "one JSON object");
  return [options](const Session& session) { return run_train(*options, session); };
}

}  // namespace waymark::tools

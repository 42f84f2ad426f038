// waymark train: corpus → model, learnt from trajectories alone.
#include <CLI/App.hpp>
#include <iostream>
#include <memory>

#include "libparser/beam.hpp"
#include "libparser/learn.hpp"
#include "libparser/sail_corpus.hpp"
#include "libparser/weights_file.hpp"
#include "tools/corridor.hpp"
#include "tools/shell/models.hpp"
#include "tools/shell/options.hpp"
#include "tools/shell/output.hpp"
#include "tools/subcommand.hpp"

namespace waymark::tools {
namespace {

struct Options {
  std::string corpus, out, data, convention = "absolute";
  TrainingOptions training;
  bool json = false;
};

ExitCode run_train(const Options& options, const Session& session) {
  StopWatch watch;
  const parser::Corpus corpus = parser::read_sail_corpus(options.corpus);
  parser::TrainOptions train = options.training.settled();
  train.stop = session.stop;
  train.convention =
      options.convention == "relative" ? parser::Convention::Relative : parser::Convention::Absolute;
  ProgressBar bar;
  train.progress = [&](double fraction, std::string_view what) { bar.show(fraction, what); };
  std::string bytes;
  try {
    bytes = parser::serialize_within(
        parser::linear_model_of(parser::train(corpus, maps_of(corpus, options.data), train)),
        parser::most_bytes);
  } catch (const parser::Stopped&) {
    throw Interrupted();
  }
  bar.wipe();
  write_file(options.out, bytes);
  const double seconds = watch.lap();
  if (options.json)
    std::cout << JsonObject()
                     .add("model", options.training.model)
                     .add("out", options.out)
                     .add("paragraphs", corpus.paragraphs.size())
                     .add("sentences", corpus.sentences())
                     .add("corpus_checksum", hexadecimal(corpus.checksum))
                     .add("seed", train.seed)
                     .add("convention", options.convention)
                     .add("bytes", bytes.size())
                     .add("seconds", seconds)
                     .text()
              << '\n';
  else
    std::cout << "trained " << options.training.model << " on " << corpus.sentences() << " sentences of "
              << corpus.paragraphs.size() << " paragraphs (checksum " << hexadecimal(corpus.checksum)
              << ", unknown headings " << options.convention << ", seed " << train.seed << "), "
              << bytes.size() << " bytes, " << fixed(seconds, 1) << " s: " << options.out << '\n';
  return ExitCode::Done;
}

}  // namespace

Runner setup_train(CLI::App& command) {
  const auto options = std::make_shared<Options>();
  command
      .add_option("--corpus", options->corpus,
                  "directory with instructions.jsonl and, if it has its own, maps/")
      ->type_name("DIR")
      ->required();
  add_data_option(command, options->data);
  command.add_option("--out", options->out, "the model file; written whole or not at all")
      ->type_name("FILE")
      ->required();
  add_training_options(command, options->training, {"linear", "encoder-decoder"});
  command.add_option("--convention", options->convention, "what an unknown start heading counts as")
      ->check(CLI::IsMember({"absolute", "relative"}))
      ->capture_default_str();
  command.add_flag("--json", options->json, "one JSON object");
  return [options](const Session& session) { return run_train(*options, session); };
}

}  // namespace waymark::tools

// waymark train: corpus → model, learnt from trajectories alone; or pairs of sentence and formula → model.
#include <algorithm>
#include <iostream>
#include <memory>

#include "libparser/corpus/corpus_file.hpp"
#include "libparser/corpus/corpus_output.hpp"
#include "libparser/domain/commands/command_examples.hpp"
#include "libparser/domain/commands/learn_mentions.hpp"
#include "libparser/language/generate.hpp"
#include "libparser/model_file.hpp"
#include "libparser/training/annotations.hpp"
#include "libparser/training/learn.hpp"
#include "tools/answer.hpp"
#include "tools/corridor.hpp"
#include "tools/formula_table.hpp"
#include "tools/shell/command_training.hpp"
#include "tools/shell/learning.hpp"
#include "tools/shell/models.hpp"
#include "tools/shell/options.hpp"
#include "tools/shell/output.hpp"
#include "tools/shell/subcommand.hpp"

namespace waymark::tools {
namespace {

struct TrainCommandOptions {
  std::string corpus, supervised, out = "model.waymark", data, convention = "absolute";
  TrainingOptions training;
  CommandTrainingOptions commands;
  std::string base, map;
  std::vector<std::string> mentions;  // files of commands
  bool json = false, leave_out = false;
};

// Lines that are no programs over the names of the map: all of them are learned from, or none.
void check_refused(const parser::Annotations& annotations, const TrainCommandOptions& options, const std::string& map) {
  const std::size_t refused = annotations.refused.size(), all = refused + annotations.pairs.size();
  if (refused == 0) return;
  constexpr std::size_t most = 3;
  for (std::size_t i = 0; i < std::min(refused, most); ++i)
    std::cerr << source_name(options.supervised) << ':' << annotations.refused[i].line << ": "
              << annotations.refused[i].reason << '\n';
  const std::string share = "no programs over the names of the map " + map + ": the formulas of " +
                            std::to_string(refused) + " of " + counted(all, "line");
  if (!options.leave_out)
    throw ltl::FormatError(source_name(options.supervised), 0, 0,
                           share + "; --map names another one, --leave-out learns from the other lines");
  complain("note", share + ", which are left out");
}

// Of a corpus, of pairs, or of our own language when neither is named.
struct TrainingData {
  parser::Corpus corpus;
  std::vector<plan::Map> maps;
  std::vector<parser::Annotation> pairs;
  std::uint64_t checksum = 0;
  std::size_t sentences = 0;
};

TrainingData training_data_of(const TrainCommandOptions& options, parser::Dialect dialect) {
  TrainingData instances;
  if (!options.supervised.empty()) {
    const std::string text = read_file(options.supervised);
    if (options.map.empty())
      instances.maps = shipped_maps(options.data);
    else
      instances.maps.push_back(read_map({options.map, options.data}));
    if (instances.maps.empty())
      throw ltl::FormatError(options.data, 0, 0, "there are no maps whose vocabulary formulas could be over");
    parser::Annotations annotations =
        parser::parse_annotations(text, instances.maps.front().vocabulary(), dialect, source_name(options.supervised));
    check_refused(annotations, options, instances.maps.front().name());
    if (annotations.pairs.empty())
      throw ltl::FormatError(source_name(options.supervised), 0, 0, "holds no pair to learn from");
    instances.pairs = std::move(annotations.pairs);
    instances.checksum = parser::fnv1a(text);
    instances.sentences = instances.pairs.size();
    return instances;
  }
  if (options.corpus.empty()) {
    instances.corpus = parser::generate_corpus(shipped_maps(options.data), parser::own_language);
    instances.corpus.checksum = parser::fnv1a(parser::json_lines(instances.corpus));
  } else {
    instances.corpus = read_hallway_corpus(options.corpus, options.training.tell_place_numbers);
  }
  instances.maps = maps_of(instances.corpus, options.data);
  instances.checksum = instances.corpus.checksum;
  instances.sentences = instances.corpus.sentences();
  return instances;
}

void report(const TrainCommandOptions& options, const parser::TrainOptions& train, const TrainingData& instances,
            std::size_t bytes, double seconds) {
  const bool supervised = !options.supervised.empty();
  const std::string numbers = told_or_hidden(options.training.tell_place_numbers || options.corpus.empty());
  if (options.json)
    std::cout << JsonObject()
                     .add("model", options.training.model)
                     .add("out", options.out)
                     .add("paragraphs", instances.corpus.paragraphs.size())
                     .add("sentences", instances.sentences)
                     .add("corpus_checksum", hexadecimal(instances.checksum))
                     .add("seed", train.seed)
                     .add("convention", options.convention)
                     .add("place_numbers", numbers)
                     .add("bytes", bytes)
                     .add("seconds", seconds)
                     .text()
              << '\n';
  else
    std::cout << "trained " << options.training.model << " on " << instances.sentences << " sentences "
              << (supervised ? "with their formulas"
                             : "of " + std::to_string(instances.corpus.paragraphs.size()) + " paragraphs")
              << " (checksum " << hexadecimal(instances.checksum) << ", "
              << (supervised ? "" : "unknown headings " + options.convention + ", numbers of places " + numbers + ", ")
              << "seed " << train.seed << "), " << bytes << " bytes, " << fixed(seconds, 1) << " s: " << options.out
              << '\n';
}

// The reader of commands: from people's commands, our own, and what it must leave to the reader of programs.
std::shared_ptr<const parser::LiftedReader> learn_commands(const TrainCommandOptions& options, const TrainingData& data,
                                                           const parser::TrainOptions& train) {
  const auto vectors = read_vectors(options.data);
  const auto synonyms = std::make_shared<const parser::Synonyms>(read_synonyms(options.data));
  std::vector<parser::LiftedExample> examples =
      parser::own_commands(read_grammar(options.data), *vectors, options.commands.how.own);
  const auto routes = parser::route_instructions(data.corpus, data.maps, *vectors, *synonyms, 0.25);
  examples.insert(examples.end(), routes.begin(), routes.end());
  parser::MentionModel mentions{parser::mention_weights_by_hand(), synonyms};
  std::vector<std::string> files = options.commands.files;
  std::erase(files, "own");
  std::vector<std::string> naming = files;
  naming.insert(naming.end(), options.mentions.begin(), options.mentions.end());
  std::optional<parser::CommandDomains> domains;
  if (!naming.empty()) {
    domains = domains_of(options.commands, naming.front());
    mentions.weights = parser::learn_mentions(commands_of(naming, false), *domains, *synonyms).weights;
  }
  for (const std::string& file : files) {
    const auto labelled = parser::labelled_commands(parser::read_commands(file), *domains, mentions, 0.3);
    examples.insert(examples.end(), labelled.examples.begin(), labelled.examples.end());
    if (labelled.left_out > 0)
      std::cerr << file << ": " << labelled.left_out
                << " commands are left out: their texts do not name what their formulas speak of\n";
  }
  std::vector<std::shared_ptr<const parser::LiftedNetwork>> networks;
  const std::size_t n = options.commands.how.networks;
  for (std::size_t i = 0; i < n; ++i) {
    parser::LiftedTraining how = options.commands.how.network;
    how.seed = train.seed + i;
    networks.push_back(parser::learn_lifted(examples, vectors, how, [&](double done) {
      train.progress((static_cast<double>(i) + done) / static_cast<double>(n), "learning commands");
    }));
  }
  return std::make_shared<const parser::LiftedReader>(vectors, std::move(networks), mentions);
}

ExitCode run_train(const TrainCommandOptions& options, const Session& session) {
  StopWatch watch;
  if (!options.corpus.empty() && !options.supervised.empty())
    throw UsageError("--corpus and --supervised: learning from trajectories, or from formulas?");
  if ((!options.map.empty() || options.leave_out) && options.supervised.empty())
    throw UsageError("--map and --leave-out go with --supervised");
  if (!options.mentions.empty() && options.commands.files.empty())
    throw UsageError("--mentions needs --commands: the reader of commands is learned from them");
  check_writable(options.out);
  parser::TrainOptions train =
      options.training.settled(options.corpus.empty() ? parser::Dialect::Temporal : parser::Dialect::Plain);
  train.stop = session.stop;
  train.convention = options.convention == "relative" ? parser::Convention::Relative : parser::Convention::Absolute;
  ProgressBar bar;
  train.progress = [&](double fraction, std::string_view what) { bar.show(fraction, what); };
  const TrainingData instances = training_data_of(options, train.dialect);
  const std::string& source = options.supervised.empty() ? options.corpus : options.supervised;
  parser::Grounder grounder = !options.base.empty() ? parser::load_grounder(options.base) : learn_from(source, [&] {
    return instances.pairs.empty() ? parser::train(instances.corpus, instances.maps, train)
                                   : parser::train_supervised(instances.pairs, instances.maps.front(), train);
  });
  if (!options.commands.files.empty()) grounder.commands = learn_commands(options, instances, train);
  const std::string bytes = parser::serialize_within(grounder, parser::most_bytes);
  bar.wipe();
  write_file(options.out, bytes);
  report(options, train, instances, bytes.size(), watch.lap());
  return ExitCode::Done;
}

}  // namespace

Runner setup_train(Command command) {
  const auto options = std::make_shared<TrainCommandOptions>();
  add_corpus_option(command, options->corpus, false);
  command
      .add_option("--supervised", options->supervised,
                  "learn from lines 'sentence TAB formula' instead, over the vocabulary of the shipped maps")
      .type_name("FILE");
  command.add_option("--map", options->map, "with --supervised: formulas are over the names of this map (name or file)")
      .type_name("MAP");
  command.add_flag("--leave-out", options->leave_out,
                   "with --supervised: leave out lines whose formula is no program; else they are an error");
  add_command_training_options(command, options->commands);
  command
      .add_option("--mentions", options->mentions,
                  "commands that tell which words name which landmark, and whose formulas are not learned")
      .type_name("FILE")
      .group("Commands");
  command.add_option("--base", options->base, "keep the reader of programs of this model, learn the commands alone")
      .type_name("FILE")
      .group("Commands");
  add_data_option(command, options->data);
  command.add_option("--out", options->out, "the model file; written whole or not at all")
      .type_name("FILE")
      .show_default();
  add_training_options(command, options->training, {"linear", "encoder-decoder"});
  add_convention_option(command, options->convention, {"absolute", "relative"});
  command.in("Output").add_flag("--json", options->json, "one JSON object");
  return [options](const Session& session) { return run_train(*options, session); };
}

}  // namespace waymark::tools

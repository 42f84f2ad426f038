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

// What the reader of commands is learned from, read before anything is learned.
struct CommandData {
  std::shared_ptr<const parser::WordVectors> vectors;
  std::shared_ptr<const parser::Synonyms> synonyms;
  std::optional<parser::SynchronousGrammar> grammar;
  std::optional<parser::CommandDomains> domains;
  std::vector<std::pair<std::string, std::vector<parser::Command>>> learned;  // file by file
  std::vector<parser::Command> naming;  // which tell how landmarks are named: these, and those of --mentions
};

CommandData command_data_of(const TrainCommandOptions& options) {
  CommandData data;
  data.vectors = read_vectors(options.data);
  data.synonyms = std::make_shared<const parser::Synonyms>(read_synonyms(options.data));
  data.grammar.emplace(read_grammar(options.data));
  std::vector<std::string> files = options.commands.files;
  std::erase(files, "own");
  for (const std::string& file : files) {
    data.learned.emplace_back(file, parser::read_commands(file));
    data.naming.insert(data.naming.end(), data.learned.back().second.begin(), data.learned.back().second.end());
  }
  for (parser::Command& command : commands_of(options.mentions, false)) data.naming.push_back(std::move(command));
  files.insert(files.end(), options.mentions.begin(), options.mentions.end());
  if (files.empty() && options.commands.domains.empty()) return data;
  data.domains.emplace(domains_of(options.commands, files.empty() ? "" : files.front()));
  for (const parser::Command& command : data.naming)
    if (!command.suspect && !command.marked)
      data.domains->of(command.domain);  // cities are read when they are first asked for
  return data;
}

// What a reader of commands was learned from.
struct CommandsReport {
  std::size_t networks = 0, own = 0, people = 0, left_out = 0, routes = 0, vectors = 0;
  std::uint64_t seed = 0;  // of the first network

  Json json() const {
    return JsonObject()
        .add("networks", networks)
        .add("seed", seed)
        .add("own", own)
        .add("people", people)
        .add("left_out", left_out)
        .add("route_instructions", routes)
        .add("vectors", vectors);
  }
  std::string text() const {
    const std::string seeds = networks == 1
                                  ? "seed " + std::to_string(seed)
                                  : "seeds " + std::to_string(seed) + " to " + std::to_string(seed + networks - 1);
    return counted(networks, "network") + " (" + seeds + ") on " + std::to_string(own) + " commands of our own, " +
           std::to_string(people) + " of people (" + std::to_string(left_out) + " left out) and " +
           counted(routes, "route instruction") + ", with " + counted(vectors, "word vector");
  }
};

// The reader of commands: from people's commands, our own, and what it must leave to the reader of programs.
std::shared_ptr<const parser::LiftedReader> learn_commands(const TrainCommandOptions& options, const TrainingData& data,
                                                           CommandData& read, const parser::TrainOptions& train,
                                                           CommandsReport& said) {
  std::vector<parser::LiftedExample> own = parser::own_commands(*read.grammar, *read.vectors, options.commands.how.own);
  said.own = own.size();
  std::vector<parser::LiftedExample> examples;
  const auto routes = parser::route_instructions(data.corpus, data.maps, *read.vectors, *read.synonyms, 0.25);
  examples.insert(examples.end(), routes.begin(), routes.end());
  parser::MentionModel mentions{parser::mention_weights_by_hand(), read.synonyms};
  if (!read.naming.empty())
    mentions.weights = parser::learn_mentions(read.naming, *read.domains, *read.synonyms).weights;
  const parser::MarkedCommands marked(read_map({"grid", options.data}).vocabulary(), read.synonyms.get());
  for (const auto& [file, commands] : read.learned) {
    std::vector<parser::Command> with_marks, others;
    for (const parser::Command& c : commands)
      if (!c.suspect) (c.marked ? with_marks : others).push_back(c);
    const auto labelled = parser::labelled_commands(others, *read.domains, mentions, 0.3);
    const auto texts = parser::marked_examples(with_marks, marked);
    examples.insert(examples.end(), labelled.examples.begin(), labelled.examples.end());
    examples.insert(examples.end(), texts.examples.begin(), texts.examples.end());
    const std::size_t left_out = labelled.left_out + texts.left_out;
    said.left_out += left_out;
    said.people += with_marks.size() + others.size() - left_out;
    if (left_out > 0)
      std::cerr << file << ": " << left_out
                << " commands are left out: their texts do not name what their formulas speak of\n";
  }
  parser::CommandsExperiment how = options.commands.how;
  how.network.seed = train.seed;
  how.progress = [&](double done) { train.progress(done, "learning commands"); };
  said.networks = how.networks, said.seed = train.seed, said.routes = routes.size(),
  said.vectors = read.vectors->size();
  return std::make_shared<const parser::LiftedReader>(
      parser::learn_reader(std::move(own), examples, read.vectors, mentions, how));
}

struct Trained {
  std::size_t bytes;
  double seconds;
  std::optional<CommandsReport> commands;  // of the reader that was learned, if one was
};

void report_json(const TrainCommandOptions& options, const parser::TrainOptions& train, const TrainingData& instances,
                 const Trained& trained) {
  JsonArray readers;
  if (options.base.empty()) readers.add("programs");
  if (trained.commands) readers.add("commands");
  std::cout << JsonObject()
                   .add("model", options.base.empty() ? Json(options.training.model) : Json())
                   .add("base", options.base.empty() ? Json() : Json(options.base))
                   .add("trained", readers)
                   .add("out", options.out)
                   .add("paragraphs", instances.corpus.paragraphs.size())
                   .add("sentences", instances.sentences)
                   .add("corpus_checksum", hexadecimal(instances.checksum))
                   .add("seed", train.seed)
                   .add("convention", options.convention)
                   .add("place_numbers", told_or_hidden(options.training.tell_place_numbers || options.corpus.empty()))
                   .add("commands", trained.commands ? trained.commands->json() : Json())
                   .add("bytes", trained.bytes)
                   .add("seconds", trained.seconds)
                   .text()
            << '\n';
}

void report(const TrainCommandOptions& options, const parser::TrainOptions& train, const TrainingData& instances,
            const Trained& trained) {
  const bool supervised = !options.supervised.empty();
  const std::string numbers = told_or_hidden(options.training.tell_place_numbers || options.corpus.empty());
  const std::string end =
      std::to_string(trained.bytes) + " bytes, " + fixed(trained.seconds, 1) + " s: " + options.out + '\n';
  if (options.base.empty())
    std::cout << "trained " << options.training.model << " on " << instances.sentences << " sentences "
              << (supervised ? "with their formulas"
                             : "of " + std::to_string(instances.corpus.paragraphs.size()) + " paragraphs")
              << " (checksum " << hexadecimal(instances.checksum) << ", "
              << (supervised ? "" : "unknown headings " + options.convention + ", numbers of places " + numbers + ", ")
              << "seed " << train.seed << "), " << end;
  else
    std::cout << "kept the reader of programs of " << options.base << ", " << end;
  std::cout << (options.base.empty() ? "base model: none; reader of commands: " : "reader of commands: ")
            << (trained.commands ? trained.commands->text() : "none") << '\n';
}

ExitCode run_train(const TrainCommandOptions& options, const Session& session) {
  StopWatch watch;
  if (!options.corpus.empty() && !options.supervised.empty())
    throw UsageError("--corpus and --supervised: learning from trajectories, or from formulas?");
  if ((!options.map.empty() || options.leave_out) && options.supervised.empty())
    throw UsageError("--map and --leave-out go with --supervised");
  if (!options.mentions.empty() && options.commands.files.empty())
    throw UsageError("--mentions needs --commands: the reader of commands is learned from them");
  if (!options.base.empty() && options.commands.files.empty())
    throw UsageError("--base needs --commands: the reader of programs is kept, and the commands are learned");
  if (!options.base.empty() && !options.supervised.empty())
    throw UsageError("--base and --supervised: keep a reader of programs, or learn one?");
  check_writable(options.out);
  parser::TrainOptions train =
      options.training.settled(options.corpus.empty() ? parser::Dialect::Temporal : parser::Dialect::Plain);
  train.stop = session.stop;
  train.convention = options.convention == "relative" ? parser::Convention::Relative : parser::Convention::Absolute;
  ProgressBar bar;
  train.progress = [&](double fraction, std::string_view what) { bar.show(fraction, what); };
  const TrainingData instances = training_data_of(options, train.dialect);
  std::optional<CommandData> commands;
  if (!options.commands.files.empty()) commands = command_data_of(options);
  Trained trained{};
  const std::string& source = options.supervised.empty() ? options.corpus : options.supervised;
  parser::Grounder grounder = !options.base.empty() ? parser::load_grounder(options.base) : learn_from(source, [&] {
    return instances.pairs.empty() ? parser::train(instances.corpus, instances.maps, train)
                                   : parser::train_supervised(instances.pairs, instances.maps.front(), train);
  });
  if (commands) grounder.commands = learn_commands(options, instances, *commands, train, trained.commands.emplace());
  const std::string bytes = parser::serialize_within(grounder, parser::most_bytes);
  bar.wipe();
  write_file(options.out, bytes);
  trained.bytes = bytes.size(), trained.seconds = watch.lap();
  (options.json ? report_json : report)(options, train, instances, trained);
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

#include "tools/shell/models.hpp"

#include <map>

#include "libltl/diagnostic.hpp"
#include "libltl/text/xxhash.hpp"
#include "libparser/model_file.hpp"
#include "libplan/world/read_map.hpp"
#include "tools/shell/data_directory.hpp"
#include "tools/shell/terminal.hpp"

namespace waymark::tools {

void add_model_options(Command command, ModelOptions& options) {
  command
      .add_option("--model-file", options.file,
                  "a model of one's own (else models/encoder-decoder.waymark of the data)")
      .type_name("FILE");
}

namespace {

std::string file_of(const ModelOptions& options, const std::string& data) {
  return options.file.empty() ? (data_directory(data) / "models" / "encoder-decoder.waymark").string() : options.file;
}

}  // namespace

std::string checksum_of_model(const ModelOptions& options, const std::string& data) {
  const std::string file = file_of(options, data);
  return file == "-" ? file : hexadecimal(ltl::xxh64(read_file(file)));
}

parser::Grounder read_model(const ModelOptions& options, const std::string& data) {
  const std::string file = file_of(options, data);
  if (file == "-") return parser::parse_grounder(read_file(file), source_name(file));
  return parser::load_grounder(file);
}

namespace {

template <class Value>
void add_choice(Command command, const std::string& name, Value& value, const std::map<std::string, Value>& choices,
                const std::string& help) {
  std::vector<std::string> names;
  for (const auto& [choice, meaning] : choices) names.push_back(choice);
  command
      .add_option_function(
          name, [&value, choices](const std::string& choice) { value = choices.at(choice); }, help)
      .type_name("KIND")
      .one_of(names);
}

void add_network_options(Command command, parser::NetworkTraining& network) {
  using namespace parser;
  const std::string group = "Encoder-decoder";
  const auto number = [&](const std::string& name, auto& value, const std::string& help) {
    return command.add_option(name, value, help).type_name("N").show_default().group(group);
  };
  add_choice<Objective>(command, "--objective", network.objective,
                        {{"mml", Objective::MarginalLikelihood},
                         {"reinforce", Objective::Reinforce},
                         {"meritocratic", Objective::Meritocratic}},
                        "what is maximised: mml (the default), reinforce, meritocratic");
  add_choice<FeedbackKind>(command, "--feedback", network.feedback,
                           {{"plan", FeedbackKind::Plan},
                            {"progression", FeedbackKind::Progression},
                            {"discriminating", FeedbackKind::Discriminating}},
                           "what is rewarded: plan (the default), progression, discriminating");
  add_choice<ProgramSearch>(command, "--search", network.search,
                            {{"consistent", ProgramSearch::Consistent}, {"beam", ProgramSearch::Beam}},
                            "where programs come from: consistent (the default), or the randomised beam alone");
  number("--rate", network.rate, "learning rate of Adam").between(1e-9, 1.0);
  number("--epsilon", network.epsilon, "of the randomised beam").between(0.0, 1.0);
  number("--train-beam", network.beam, "places of the randomised beam").between(1, 1000);
  number("--beta", network.beta, "of the meritocratic objective").between(0.0, 1.0);
  number("--least", network.least, "consistent programs of less prior weight, compared with the best, are left out")
      .between(0.0, 1.0);
  number("--batch", network.batch, "sentences a step").between(1, 10000);
  number("--dropout", network.dropout, "share of signals left out in training").between(0.0, 0.9);
  number("--word-size", network.sizes.word, "of embeddings of words").between(1, 1000);
  number("--width", network.sizes.width, "of each LSTM").between(1, 1000);
  number("--query", network.sizes.query, "of the decoder's hidden layer").between(1, 1000);
  number("--symbol-size", network.sizes.symbol, "of embeddings of symbols").between(1, 1000);
  number("--history", network.sizes.history, "symbols that the decoder looks back on, K").between(1, 16);
}

}  // namespace

std::string told_or_hidden(bool tell_place_numbers) { return tell_place_numbers ? "told" : "hidden"; }

void add_training_options(Command command, TrainingOptions& options, const std::vector<std::string>& models) {
  command = command.in("Training");
  parser::TrainOptions& train = options.train;
  command.add_option("--model", options.model, "what is learned").type_name("KIND").one_of(models).show_default();
  command.add_option("--seed", train.seed, "same seed, same machine, same bytes").type_name("N").show_default();
  command.add_option("--epochs", options.epochs, "passes over the sentences").type_name("N").between(1, 1000);
  command
      .add_option_function(
          "--programs",
          [&options](const std::string& name) {
            options.dialect = name == "plain" ? parser::Dialect::Plain : parser::Dialect::Temporal;
          },
          "what sentences are read as: plain steps, or temporal: also past, without, keep, when, whether")
      .type_name("KIND")
      .one_of({"plain", "temporal"});
  add_choice<parser::Then>(command, "--then", train.then,
                           {{"whole-plan", parser::Then::WholePlan}, {"stepwise", parser::Then::Stepwise}},
                           "what 'then' means: whole-plan (the default) or stepwise");
  command.add_option("--threads", train.threads, "of no influence on the result")
      .type_name("N")
      .between(1, 256)
      .show_default();
  command.add_flag("--reranker,!--no-reranker", train.reranker,
                   "a reranker on the map decides between the ends that readings lead to (on)");
  command.add_flag("--tell-place-numbers", options.tell_place_numbers,
                   "sentences keep the numbers of places, which nobody sees who walks: 'position 5'");
  command.add_flag("--clauses,!--no-clauses", train.clauses,
                   "sentences of several clauses are also read clause by clause (on)");
  command
      .add_option("--pose-beam", train.beam_width,
                  "poses kept along a paragraph; 1: each sentence is settled before the next is heard")
      .type_name("N")
      .between(1, 1000)
      .show_default();
  command.add_flag("--plain", options.plain,
                   "as the paper has it: no lexicon, no prior on wording, no mirror images, every route alike, "
                   "sentences as a whole");
  add_network_options(command, train.network);
}

parser::TrainOptions TrainingOptions::settled(parser::Dialect usual) const {
  parser::TrainOptions out = train;
  out.dialect = dialect.value_or(usual);
  out.reader = model == "linear" ? parser::ReaderKind::Linear : parser::ReaderKind::EncoderDecoder;
  if (epochs > 0) out.epochs = out.network.epochs = epochs;
  if (plain) {
    out.network.sizes.lexicon = false;
    out.mention = 0;
    out.wording = 0;
    out.other_route = 1;
    out.trust = 0;
    out.clauses = false;
    out.mirrored = false;
  }
  return out;
}

void add_corpus_option(Command command, std::string& corpus, bool required) {
  command.add_option("--corpus", corpus, "directory with instructions.jsonl and, if it has its own, maps/")
      .type_name("DIR")
      .required(required);
}

void add_convention_option(Command command, std::string& convention, const std::vector<std::string>& names) {
  command.add_option("--convention", convention, "what an unknown start heading counts as")
      .one_of(names)
      .show_default();
}

std::vector<plan::Map> maps_of(const parser::Corpus& corpus, const std::string& data) {
  return corpus.maps.empty() ? shipped_maps(data) : corpus.maps;
}

std::vector<plan::Map> shipped_maps(const std::string& data) {
  const auto directory = data_directory(data);
  std::vector<plan::Map> maps;
  for (const std::string& name : plan::shipped_maps(directory)) maps.push_back(plan::read_map(name, directory));
  return maps;
}

std::vector<parser::Reading> read_instruction(const parser::Grounder& model, const Text& text, const plan::Map& map,
                                              std::span<const plan::PoseId> starts, ltl::Arena& arena) {
  auto readings = parser::ground(model, text.text, map, starts, arena);
  if (readings.empty())
    throw ltl::FormatError(text.source, text.source.empty() ? 0 : text.line, 0,
                           "the instruction '" + text.text + "' has no word that could be read");
  return readings;
}

}  // namespace waymark::tools

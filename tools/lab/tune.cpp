// waymark tune: which settings validate best, for each map that is to be left out.
#include <algorithm>
#include <iomanip>
#include <iostream>
#include <memory>
#include <optional>
#include <sstream>

#include "libparser/experiment/tune.hpp"
#include "tools/shell/json.hpp"
#include "tools/shell/learning.hpp"
#include "tools/shell/models.hpp"
#include "tools/shell/options.hpp"
#include "tools/shell/subcommand.hpp"

namespace waymark::tools {
namespace {

struct TuneOptions {
  std::string corpus, data, convention = "absolute", checkpoints;
  TrainingOptions training;
  std::vector<std::string> grid;
  bool json = false;
};

// One axis of the grid: "rate=1e-3,3e-3".
struct Axis {
  std::string name;
  std::vector<double> values;
};

Axis axis_of(const std::string& text) {
  const std::size_t equals = text.find('=');
  if (equals == std::string::npos) throw UsageError("--grid '" + text + "': expected NAME=VALUE,VALUE,…");
  Axis axis{text.substr(0, equals), {}};
  std::istringstream list(text.substr(equals + 1));
  for (std::string value; std::getline(list, value, ',');) {
    std::istringstream number(value);
    double x = 0;
    if (!(number >> x) || !number.eof()) throw UsageError("--grid '" + text + "': '" + value + "' is no number");
    axis.values.push_back(x);
  }
  if (axis.values.empty()) throw UsageError("--grid '" + text + "' has no value");
  return axis;
}

void set(parser::TrainOptions& train, const std::string& name, double value) {
  const bool is_share = name == "dropout" || name == "epsilon" || name == "beta" || name == "least";
  const bool may_be_zero = is_share || name == "decay" || name == "wording";
  const bool is_possible = may_be_zero ? value >= 0 && (!is_share || value < 1 || (value == 1 && name != "dropout"))
                           : name == "rate" ? value > 0
                                            : value >= 1 && value <= 1000;
  if (!is_possible) throw UsageError("--grid: " + name + " cannot be " + fixed(value, 4));
  parser::NetworkTraining& network = train.network;
  const auto whole = [&] { return static_cast<std::int32_t>(value); };
  if (name == "rate")
    network.rate = train.learning_rate = value;
  else if (name == "epochs")
    network.epochs = train.epochs = whole();
  else if (name == "epsilon")
    network.epsilon = value;
  else if (name == "beta")
    network.beta = value;
  else if (name == "train-beam")
    network.beam = static_cast<std::size_t>(value);
  else if (name == "dropout")
    network.dropout = value;
  else if (name == "least")
    network.least = value;
  else if (name == "word-size")
    network.sizes.word = whole();
  else if (name == "width")
    network.sizes.width = whole();
  else if (name == "query")
    network.sizes.query = whole();
  else if (name == "symbol-size")
    network.sizes.symbol = whole();
  else if (name == "history")
    network.sizes.history = whole();
  else if (name == "decay")
    train.decay = value;
  else if (name == "wording")
    train.wording = value;
  else if (name == "beam")
    train.beam = static_cast<std::size_t>(value);
  else
    throw UsageError("--grid: there is no setting '" + name + "'");
}

using Setting = std::vector<std::pair<std::string, double>>;

std::vector<Setting> settings_of(const std::vector<std::string>& grid) {
  std::vector<Setting> settings{{}};
  for (const std::string& text : grid) {
    const Axis axis = axis_of(text);
    std::vector<Setting> longer;
    for (const Setting& setting : settings)
      for (const double value : axis.values) {
        longer.push_back(setting);
        longer.back().emplace_back(axis.name, value);
      }
    settings = std::move(longer);
  }
  return settings;
}

std::string show(const Setting& setting) {
  std::ostringstream out;
  for (const auto& [name, value] : setting) out << (out.tellp() > 0 ? " " : "") << name << '=' << value;
  return out.str().empty() ? "as it is" : out.str();
}

struct Row {
  Setting setting;
  std::vector<double> left_out;  // by map: the validation of the others
};

void print_row(const Row& row, const std::vector<plan::Map>& maps, bool json) {
  if (json) {
    JsonObject setting, validation;
    for (const auto& [name, value] : row.setting) setting.add(name, value);
    for (std::size_t m = 0; m < maps.size(); ++m) validation.add(maps[m].name(), row.left_out[m]);
    std::cout << JsonObject().add("setting", setting).add("left_out", validation).text() << std::endl;
    return;
  }
  std::cout << std::left << std::setw(40) << show(row.setting) << std::right;
  for (const double value : row.left_out) std::cout << std::setw(10) << fixed(value, 2);
  std::cout << std::endl;
}

void print_head(const std::string& convention, const std::vector<plan::Map>& maps) {
  std::cout << "per cent of sentences, " << convention
            << ": learned from one of the other maps, tested on another of them\n"
            << std::left << std::setw(40) << "setting, for the map left out:" << std::right;
  for (const plan::Map& map : maps) std::cout << std::setw(10) << map.name();
  std::cout << std::endl;
}

// By map left out. `source`: whose corpus it is, for messages.
std::vector<double> validated(const parser::Corpus& corpus, const std::vector<plan::Map>& maps,
                              const parser::TrainOptions& train, const parser::KeptPairs& kept,
                              const std::string& source) {
  return learn_from(source, [&] {
    std::vector<double> left_out;
    const auto pairs = parser::validate(corpus, maps, train, kept);
    for (std::size_t m = 0; m < maps.size(); ++m) left_out.push_back(parser::without_map(pairs, m).value());
    return left_out;
  });
}

// A grid may grow: its parts are kept by setting.
std::optional<parser::Checkpoints> checkpoints_of(const TuneOptions& options, const parser::Corpus& corpus,
                                                  const Session& session) {
  if (options.checkpoints.empty()) return std::nullopt;
  return parser::Checkpoints(options.checkpoints,
                             session.settings({"--grid", "--json"}) + "corpus " + hexadecimal(corpus.checksum) + '\n');
}

ExitCode run_tune(const TuneOptions& options, const Session& session) {
  const parser::Corpus corpus = read_hallway_corpus(options.corpus, options.training.tell_place_numbers);
  const std::vector<plan::Map> maps = maps_of(corpus, options.data);
  const std::vector<Setting> settings = settings_of(options.grid);
  for (const Setting& setting : settings) {  // what is wrong with a grid is said before anything is learned
    parser::TrainOptions unused;
    for (const auto& [name, value] : setting) set(unused, name, value);
  }
  const std::optional<parser::Checkpoints> checkpoints = checkpoints_of(options, corpus, session);
  const auto train_for = [&](const Setting& setting) {
    parser::TrainOptions train = options.training.settled();
    train.convention = options.convention == "relative" ? parser::Convention::Relative : parser::Convention::Absolute;
    train.stop = session.stop;
    for (const auto& [name, value] : setting) set(train, name, value);
    return train;
  };
  const auto kept_for = [&](const Setting& setting) {
    return parser::KeptPairs{checkpoints ? &*checkpoints : nullptr, show(setting) + ' '};
  };
  // Processes that share the grid begin with what nobody else has begun, of all settings.
  if (checkpoints)
    for (const Setting& setting : settings)
      learn_from(options.corpus,
                 [&] { parser::help_to_validate(corpus, maps, train_for(setting), kept_for(setting)); });
  if (!options.json) print_head(options.convention, maps);
  std::vector<Row> rows;
  for (const Setting& setting : settings) {
    parser::TrainOptions train = train_for(setting);
    ProgressBar bar;
    train.progress = [&](double fraction, std::string_view) {
      bar.show((static_cast<double>(rows.size()) + fraction) / static_cast<double>(settings.size()), show(setting));
    };
    Row row{setting, validated(corpus, maps, train, kept_for(setting), options.corpus)};
    bar.wipe();
    print_row(row, maps, options.json);
    rows.push_back(std::move(row));
  }
  if (options.json) return ExitCode::Done;
  for (std::size_t m = 0; m < maps.size(); ++m) {
    const auto best = std::max_element(rows.begin(), rows.end(),
                                       [&](const Row& a, const Row& b) { return a.left_out[m] < b.left_out[m]; });
    std::cout << "best when " << maps[m].name() << " is left out: " << show(best->setting) << '\n';
  }
  return ExitCode::Done;
}

}  // namespace

Runner setup_tune(Command command) {
  const auto options = std::make_shared<TuneOptions>();
  add_corpus_option(command, options->corpus);
  command
      .add_option("--grid", options->grid,
                  "NAME=VALUE,VALUE,… of a setting: rate, epochs, dropout, least, epsilon, beta, train-beam, "
                  "history, "
                  "width, query, word-size, symbol-size, decay, wording, beam; several options make a grid")
      .type_name("AXIS");
  add_convention_option(command, options->convention, {"absolute", "relative"});
  command
      .add_option("--checkpoints", options->checkpoints,
                  "where finished parts are kept, and found again by the same command; several processes may share it")
      .type_name("DIR");
  add_data_option(command, options->data);
  add_training_options(command, options->training, {"linear", "encoder-decoder"});
  command.in("Output").add_flag("--json", options->json, "one JSON object a line, a line each setting");
  return [options](const Session& session) { return run_tune(*options, session); };
}

}  // namespace waymark::tools

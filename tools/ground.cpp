// waymark ground: instruction → formulas, best first.
#include <algorithm>
#include <map>
#include <memory>
#include <mutex>
#include <sstream>

#include "libltl/diagnostic.hpp"
#include "libltl/text/print.hpp"
#include "libparser/decode/explain.hpp"
#include "libparser/grounding/instruction.hpp"
#include "libparser/grounding/understand.hpp"
#include "tools/answer.hpp"
#include "tools/attention.hpp"
#include "tools/ground_named.hpp"
#include "tools/shell/batch.hpp"
#include "tools/shell/models.hpp"
#include "tools/shell/options.hpp"
#include "tools/shell/parallel.hpp"
#include "tools/shell/subcommand.hpp"
#include "tools/understood.hpp"

namespace waymark::tools {
namespace {

struct GroundCommandOptions {
  TextOptions text;
  MapOptions map;
  ModelOptions model;
  std::string start;
  std::size_t top = 5, beam = 64;
  ParallelOptions parallel;
  NamedOptions commands;
  bool json = false, explain = false, force = false;
};

class Grounding {
 public:
  Grounding(const GroundCommandOptions& options, const Session& session)
      : options_(options), session_(session), model_(read_model(options.model, options.map.data)) {
    if (options.commands.any()) commands_.emplace(options.commands, model_, options.top, options.json, options.force);
    if (options.explain && network_of(model_) == nullptr)
      throw UsageError("--explain shows what an encoder-decoder attends to; this model is a linear one");
  }

  Reply operator()(const Text& line) {
    const parser::Instruction instruction = parser::parse_instruction(line.text, line.source, line.line);
    if (commands_) return (*commands_)(instruction, line);
    const Place& place = place_of(instruction.map.value_or(options_.map.map));
    const plan::Map& map = place.map;
    ltl::Arena arena(map.vocabulary());
    const auto starts = start_poses(instruction.start.value_or(options_.start), map);
    parser::Understanding understood = parser::understand(model_, instruction.text, place.executor, starts, arena,
                                                          {.ground = {.beam = options_.beam, .one_an_end = true},
                                                           .least = options_.force ? 0 : parser::least_understood});
    std::vector<parser::Reading>& readings = understood.readings;
    if (readings.empty()) return not_understood(instruction.text, map, understood);
    const std::size_t top = std::max<std::size_t>(options_.top, 1);
    if (readings.size() > top) readings.erase(readings.begin() + static_cast<std::ptrdiff_t>(top), readings.end());
    std::vector<Attended> explained;
    if (options_.explain) explained = attended(model_, instruction.text, starts.size() > 1, options_.beam);
    return {.text = options_.json ? json_of(instruction.text, readings, map, explained).text() + '\n'
                                  : text_of(readings, explained)};
  }

 private:
  struct Place {  // the executor refers to the map
    explicit Place(plan::Map read) : map(std::move(read)), executor(map) {}
    plan::Map map;
    parser::Executor executor;
  };

  const Place& place_of(const std::string& name) {
    const std::lock_guard lock(reading_);
    std::unique_ptr<Place>& place = places_[name];
    if (!place) {
      MapOptions options = options_.map;
      options.map = name;
      place = std::make_unique<Place>(read_map(options));
    }
    return *place;
  }

  Reply not_understood(const std::string& text, const plan::Map& map, const parser::Understanding& understood) const {
    return {.code = ExitCode::NotUnderstood,
            .text = options_.json ? not_understood_json(text, map.name(), understood).text() + '\n' : std::string(),
            .problem = not_understood_message(text, understood)};
  }

  static Json json_of(const std::string& text, const std::vector<parser::Reading>& readings, const plan::Map& map,
                      const std::vector<Attended>& explained) {
    JsonArray array;
    for (const parser::Reading& reading : readings)
      array.add(JsonObject().add("formula", ltl::print(reading.formula)).add("probability", reading.probability));
    JsonObject object;
    object.add("instruction", text)
        .add("map", map.name())
        .add("formula", ltl::print(readings.front().formula))
        .add("readings", array);
    if (explained.empty()) return object;
    return object.add("explain", tools::json_of(explained));
  }

  std::string text_of(const std::vector<parser::Reading>& readings, const std::vector<Attended>& explained) const {
    std::ostringstream out;
    for (const parser::Reading& reading : readings)
      out << fixed(reading.probability, 4) << "  " << shown(reading.formula, session_.out) << '\n';
    for (const Attended& sentence : explained) {
      out << '\n';
      for (const parser::ExplainedSymbol& symbol : sentence.symbols) print(out, symbol, sentence.words);
    }
    return out.str();
  }

  // "chair        0.93  chair 0.88, the 0.07": the words that got a twentieth of the attention or more.
  static void print(std::ostream& out, const parser::ExplainedSymbol& symbol, const std::vector<std::string>& words) {
    out << symbol.symbol << std::string(symbol.symbol.size() < 13 ? 13 - symbol.symbol.size() : 1, ' ');
    if (symbol.weights.empty()) {
      out << "follows\n";
      return;
    }
    std::vector<std::size_t> order;
    for (std::size_t w = 0; w < words.size(); ++w)
      if (symbol.weights[w] >= 0.05) order.push_back(w);
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return symbol.weights[a] > symbol.weights[b]; });
    out << fixed(symbol.probability, 2) << "  ";
    for (std::size_t i = 0; i < order.size(); ++i)
      out << (i > 0 ? ", " : "") << words[order[i]] << ' ' << fixed(symbol.weights[order[i]], 2);
    out << '\n';
  }

  const GroundCommandOptions& options_;
  const Session& session_;
  parser::Grounder model_;
  std::optional<NamedGrounding> commands_;
  std::mutex reading_;
  std::map<std::string, std::unique_ptr<Place>> places_;  // by the name that was asked for
};

ExitCode run_ground(const GroundCommandOptions& options, const Session& session) {
  TextReader texts(options.text, "instruction");
  Grounding grounding(options, session);
  ParallelOptions parallel = options.parallel;
  parallel.settings = [&] {
    return session.settings({}) + "model " + checksum_of_model(options.model, options.map.data) + '\n';
  };
  return answer_in_parallel(
      texts, session.stop, parallel, [&](const Text& text, const TextWatch&) { return grounding(text); },
      [&](const Text& text, const std::string& message) {
        return options.json ? json_error(text.line, message).text() + '\n' : std::string();
      });
}

}  // namespace

Runner setup_ground(Command command) {
  const auto options = std::make_shared<GroundCommandOptions>();
  add_text_options(command, options->text, "instruction");
  add_map_options(command, options->map);
  add_model_options(command, options->model);
  add_start_option(command, options->start);
  command.add_option("--top", options->top, "how many readings to show").type_name("K").show_default();
  command.add_option("--beam", options->beam, "programs that are considered for a sentence")
      .type_name("N")
      .between(1, 100000)
      .show_default();
  command.add_option("--threads", options->parallel.threads, "instructions read at a time (0: all cores)")
      .type_name("N")
      .show_default();
  add_deal_options(command, options->parallel.deal);
  command.add_flag("--explain", options->explain,
                   "the words that each symbol of a sentence's likeliest program attended to (encoder-decoders)");
  add_named_options(command, options->commands);
  command.add_flag("--force", options->force, "answer what was hardly understood, too");
  command.in("Output").add_flag("--json", options->json, "one JSON object a line");
  return [options](const Session& session) { return run_ground(*options, session); };
}

}  // namespace waymark::tools

// waymark run: the whole corridor, from an English instruction to a certified route.
#include <iostream>
#include <memory>

#include "libautomata/hoa/finite.hpp"
#include "libltl/text/print.hpp"
#include "libparser/grounding/understand.hpp"
#include "tools/answer.hpp"
#include "tools/picture.hpp"
#include "tools/plan_walk.hpp"
#include "tools/shell/batch.hpp"
#include "tools/shell/models.hpp"
#include "tools/shell/options.hpp"
#include "tools/shell/output.hpp"
#include "tools/shell/subcommand.hpp"

namespace waymark::tools {
namespace {

// What is shown when nothing is asked: an instruction of our own, on the map grid.
constexpr std::string_view demo_instruction =
    "walk past the lamp to the easel. take a left. go forward until you reach the blue hall.";
constexpr std::string_view demo_map = "grid", demo_start = "1,9,0";

struct RunOptions {
  TextOptions text;
  MapOptions map;
  ModelOptions model;
  std::string start, svg, hoa, semantics = "auto";
  std::size_t top = 0;  // 0: 1 as text, 5 in JSON
  bool force = false;
  bool json = false, demo = false;
};

std::vector<WeighedFormula> weighed(const std::vector<parser::Reading>& readings, std::size_t top) {
  std::vector<WeighedFormula> out;
  for (std::size_t i = 0; i < std::min(readings.size(), top); ++i)
    out.push_back({readings[i].formula, readings[i].probability});
  return out;
}

class Running {
 public:
  Running(const RunOptions& options, const Session& session)
      : options_(options),
        session_(session),
        model_(read_model(options.model, options.map.data)),
        map_(read_map(options.map)),
        executor_(map_),
        starts_(start_poses(options.start, map_)),
        load_(watch_.lap()) {}

  ExitCode operator()(const Text& text) const {
    ltl::Arena arena(map_.vocabulary());
    StopWatch watch;
    const parser::Understanding understood = parser::understand(
        model_, text.text, executor_, starts_, arena, {.least = options_.force ? 0.0 : parser::UnderstandOptions().least});
    const std::vector<parser::Reading>& readings = understood.readings;
    if (readings.empty()) return not_understood(text, understood);
    const double grounding = watch.lap();
    const ltl::Formula formula = readings.front().formula;
    if (options_.semantics == "infinite" || (options_.semantics == "auto" && understood.ongoing))
      return run_for_ever(text, readings);
    const automata::Dfa dfa = translate(formula, session_.stop);
    const double translating = watch.lap();
    Answer answer{.instruction = text.text,
                  .formula = formula,
                  .readings = weighed(readings, options_.top > 0 ? options_.top
                                                : options_.json  ? 5
                                                                 : 1),
                  .corridor_run = run_corridor(map_, dfa, formula, starts_, session_.stop)};
    Seconds& seconds = answer.corridor_run.seconds;
    seconds.load = load_, seconds.ground = grounding, seconds.translate = translating;
    show(answer, dfa);
    return route_of(answer.corridor_run) != nullptr ? ExitCode::Done : ExitCode::No;
  }

 private:
  ExitCode not_understood(const Text& text, const parser::Understanding& understood) const {
    std::string message = "not understood: '" + text.text + "'";
    if (!understood.words_not_understood.empty()) {
      message += "; these words are not known here: ";
      for (const std::string& word : understood.words_not_understood) message += (message.back() == ' ' ? "" : ", ") + word;
    }
    if (options_.json) {
      JsonArray words;
      for (const std::string& word : understood.words_not_understood) words.add(word);
      std::cout << JsonObject()
                       .add("instruction", text.text)
                       .add("map", map_.name())
                       .add("status", "not understood")
                       .add("understood", Json())
                       .add("probability", understood.probability)
                       .add("words", words)
                       .text()
                << '\n';
    }
    std::cerr << message << '\n';
    return ExitCode::NotUnderstood;
  }

  // A task without end: its lasso.
  ExitCode run_for_ever(const Text& text, const std::vector<parser::Reading>& readings) const {
    JsonArray array;
    for (const WeighedFormula& reading : weighed(readings, options_.top > 0 ? options_.top : 5))
      array.add(JsonObject().add("formula", ltl::print(reading.formula)).add("probability", reading.probability));
    WalkOptions walk{.svg = options_.svg, .json = options_.json, .load = load_};
    walk.head.add("instruction", text.text).add("readings", array);
    return plan_lasso({map_, starts_, readings.front().formula}, walk, session_);
  }


  void show(const Answer& answer, const automata::Dfa& dfa) const {
    if (options_.json)
      std::cout << json_of(answer, map_).text() << '\n';
    else
      print(std::cout, session_.out, answer, map_);
    if (!options_.hoa.empty())
      write_file(options_.hoa, automata::write_hoa(dfa, {.name = ltl::print(*answer.formula)}));
    if (options_.svg.empty()) return;
    draw({.map = &map_,
          .dfa = &dfa,
          .instruction = *answer.instruction,
          .formula = answer.formula,
          .route = tools::shown(answer.corridor_run)},
         options_.svg);
  }

  const RunOptions& options_;
  const Session& session_;
  StopWatch watch_;
  parser::Grounder model_;
  plan::Map map_;
  parser::Executor executor_;
  std::vector<plan::PoseId> starts_;
  double load_;
};

ExitCode run_all(RunOptions options, const Session& session) {
  const bool asked_nothing = options.text.arguments.empty() && options.text.file.empty();
  if (options.demo && !asked_nothing) throw UsageError("--demo has its own instruction");
  if (options.demo || (asked_nothing && stdin_is_terminal())) {
    options.text.arguments = {std::string(demo_instruction)};
    options.map.map = demo_map;
    options.start = demo_start;
  }
  TextReader texts(options.text, "instruction");
  if (texts.is_batch() && (!options.svg.empty() || !options.hoa.empty()))
    throw UsageError("--svg and --hoa are for a single instruction given as an argument");
  const Running running(options, session);
  return answer_each(
      texts, session.stop, [&](const Text& text) { return running(text); }, options.json);
}

}  // namespace

Runner setup_run(Command command) {
  const auto options = std::make_shared<RunOptions>();
  add_text_options(command, options->text, "instruction");
  add_map_options(command, options->map);
  add_model_options(command, options->model);
  add_start_option(command, options->start);
  command.add_option("--top", options->top, "show the K likeliest readings with their probabilities")
      .type_name("K");
  command.add_option("--semantics", options->semantics, "finite or infinite words; auto: as the words say")
      .type_name("KIND")
      .one_of({"auto", "finite", "infinite"});
  command.add_flag("--force", options->force, "answer what was hardly understood, too");
  command.add_flag("--json", options->json, "one JSON object a line");
  command.add_option("--svg", options->svg, "draw map, route and automaton").type_name("FILE");
  command.add_option("--hoa", options->hoa, "write the automaton").type_name("FILE");
  command.add_flag("--demo", options->demo,
                   "an instruction, map and start of our own; so does waymark run at a terminal");
  return [options](const Session& session) { return run_all(*options, session); };
}

}  // namespace waymark::tools

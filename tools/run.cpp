// waymark run: the whole corridor, from an English instruction to a certified route.
#include <algorithm>
#include <iostream>
#include <map>
#include <memory>
#include <optional>
#include <span>

#include "libautomata/hoa/finite.hpp"
#include "libltl/diagnostic.hpp"
#include "libltl/text/parse.hpp"
#include "libltl/text/print.hpp"
#include "libparser/grounding/instruction.hpp"
#include "libparser/grounding/understand.hpp"
#include "tools/alternatives.hpp"
#include "tools/heard.hpp"
#include "tools/picture.hpp"
#include "tools/plan_walk.hpp"
#include "tools/shell/batch.hpp"
#include "tools/shell/models.hpp"
#include "tools/shell/options.hpp"
#include "tools/shell/output.hpp"
#include "tools/shell/subcommand.hpp"
#include "tools/understood.hpp"

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
  bool force = false, ask = false;
  bool json = false, demo = false;
};

// A text that is a formula with an operator, over propositions of the map.
bool is_formula(const std::string& text, const ltl::Vocabulary& vocabulary) {
  try {
    ltl::Arena arena(vocabulary);
    return !ltl::parse(text, arena, {.unknown = ltl::Unknown::Reject}).operands().empty();
  } catch (const ltl::SyntaxError&) {
    return false;
  }
}

class Running {
 public:
  Running(const RunOptions& options, const Session& session)
      : options_(options), session_(session), model_(read_model(options.model, options.map.data)) {
    place_of(options.map.map);
    load_ = watch_.lap();
  }

  ExitCode operator()(const Text& line) {
    const parser::Instruction said = parser::parse_instruction(line.text, line.source, line.line);
    const Place& place = place_of(said.map.value_or(options_.map.map));
    const auto starts = start_poses(said.start.value_or(options_.start), place.map);
    ltl::Arena arena(place.map.vocabulary());
    if (is_formula(said.text, place.map.vocabulary()))
      std::cerr << "note: read as English; waymark plan takes formulas\n";
    StopWatch watch;
    parser::Understanding understood = parser::understand(model_, said.text, place.executor, starts, arena,
                                                          {.least = options_.force ? 0 : parser::least_understood});
    if (understood.readings.empty()) return not_understood(said.text, place.map, understood);
    const double grounding = watch.lap();
    const Heard heard{said.id, said.text, place.map, starts, understood.readings, shown_readings()};
    if (options_.ask && understood.readings.size() > 1) ask(understood.readings, place.map, starts);
    if (options_.semantics == "infinite" || (options_.semantics == "auto" && understood.ongoing))
      return run_for_ever(heard);
    return run_once(heard, grounding);
  }

 private:
  struct Place {  // the executor refers to the map
    explicit Place(plan::Map read) : map(std::move(read)), executor(map) {}
    plan::Map map;
    parser::Executor executor;
  };
  const Place& place_of(const std::string& name) {
    std::unique_ptr<Place>& place = places_[name];
    if (!place) {
      MapOptions options = options_.map;
      options.map = name;
      place = std::make_unique<Place>(read_map(options));
    }
    return *place;
  }

  std::size_t shown_readings() const { return options_.top > 0 ? options_.top : options_.json ? 5 : 1; }

  ExitCode not_understood(const std::string& text, const plan::Map& map,
                          const parser::Understanding& understood) const {
    if (options_.json) std::cout << not_understood_json(text, map.name(), understood).text() << '\n';
    std::cerr << "waymark: " << not_understood_message(text, understood) << '\n';
    return ExitCode::NotUnderstood;
  }

  // Two readings are close when the second has a third of the probability of the first. The answer goes first.
  void ask(std::vector<parser::Reading>& readings, const plan::Map& map, std::span<const plan::PoseId> starts) const {
    constexpr double close = 1.0 / 3;
    const auto others = alternatives(readings, map, starts, session_.stop, 1, close * readings.front().probability);
    if (others.empty()) return;
    const Alternative& other = others.front();
    std::cerr << "Two readings are close:\n  1  " << in_english(readings.front().formula, ltl::Semantics::Finite, map)
              << "\n  2  " << other.english << '\n';
    if (other.route) {
      std::cerr << "Is this a route that you would let pass? Only reading " << (other.first_accepts_route ? 1 : 2)
                << " accepts it:\n";
      print_steps(std::cerr, *other.route, map);
    }
    std::cerr << "1 or 2? ";
    std::string answer;
    std::getline(std::cin, answer);
    if (answer != "2") return;
    const auto chosen = std::find_if(readings.begin(), readings.end(),
                                     [&](const parser::Reading& r) { return r.formula == other.formula; });
    std::rotate(readings.begin(), chosen, chosen + 1);
  }

  // A task without end: its lasso.
  ExitCode run_for_ever(const Heard& heard) const {
    const ltl::Formula formula = heard.readings.front().formula;
    WalkOptions walk{.svg = options_.svg, .json = options_.json, .load = load_, .head = head_of_lasso(heard)};
    if (!options_.json)
      std::cout << "understood   " << in_english(formula, ltl::Semantics::Infinite, heard.map) << '\n';
    return plan_lasso({heard.map, heard.starts, formula}, walk, session_, std::cout);
  }

  ExitCode run_once(const Heard& heard, double grounding) const {
    const ltl::Formula formula = heard.readings.front().formula;
    StopWatch watch;
    const automata::Dfa dfa = translate(formula, session_.stop);
    const double translating = watch.lap();
    Answer answer = answer_of(heard, dfa, session_.stop);
    if (options_.json && heard.readings.size() > 1)
      answer.alternatives = json_of(alternatives(heard.readings, heard.map, heard.starts, session_.stop), heard.map);
    Seconds& seconds = answer.corridor_run.seconds;
    seconds.load = load_, seconds.ground = grounding, seconds.translate = translating;
    show(answer, heard.map, dfa);
    return route_of(answer.corridor_run) != nullptr ? ExitCode::Done : ExitCode::No;
  }

  void show(const Answer& answer, const plan::Map& map, const automata::Dfa& dfa) const {
    if (options_.json)
      std::cout << json_of(answer, map).text() << '\n';
    else
      print(std::cout, session_.out, answer, map);
    if (!options_.hoa.empty())
      write_file(options_.hoa, automata::write_hoa(dfa, {.name = ltl::print(*answer.formula)}));
    if (options_.svg.empty()) return;
    draw({.map = &map,
          .dfa = &dfa,
          .instruction = *answer.instruction,
          .formula = answer.formula,
          .route = tools::shown(answer.corridor_run)},
         options_.svg, session_.stop);
  }

  const RunOptions& options_;
  const Session& session_;
  StopWatch watch_;
  parser::Grounder model_;
  std::map<std::string, std::unique_ptr<Place>> places_;  // by the name that was asked for
  double load_ = 0;
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
  Running running(options, session);
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
  command.add_option("--top", options->top, "show the K likeliest readings with their probabilities").type_name("K");
  command.add_option("--semantics", options->semantics, "finite or infinite words; auto: as the words say")
      .type_name("KIND")
      .one_of({"auto", "finite", "infinite"});
  command.add_flag("--ask", options->ask,
                   "where two readings are close, ask which is meant (the answer: standard input)");
  command.add_flag("--force", options->force, "answer what was hardly understood, too");
  command.in("Output").add_flag("--json", options->json, "one JSON object a line");
  command.in("Output").add_option("--svg", options->svg, "draw map, route and automaton").type_name("FILE");
  command.in("Output").add_option("--hoa", options->hoa, "write the automaton").type_name("FILE");
  command.add_flag("--demo", options->demo,
                   "an instruction, map and start of our own; so does waymark run at a terminal");
  return [options](const Session& session) { return run_all(*options, session); };
}

}  // namespace waymark::tools

// waymark draw: whatever can be drawn, by one command: formulas, automata, maps, products, routes, lassos, policies and
// values.
#include <cmath>
#include <iostream>
#include <limits>
#include <memory>

#include "libautomata/hoa/dot_finite.hpp"
#include "libautomata/hoa/dot_omega.hpp"
#include "libltl/text/print.hpp"
#include "libplan/model/map_mdp.hpp"
#include "libplan/product/compose.hpp"
#include "libplan/product/product_mdp.hpp"
#include "libplan/solve/decide.hpp"
#include "libplan/solve/task_automaton.hpp"
#include "tools/corridor.hpp"
#include "tools/draw_data.hpp"
#include "tools/formula_tree.hpp"
#include "tools/picture.hpp"
#include "tools/picture_files.hpp"
#include "tools/plan_walk.hpp"
#include "tools/product_picture.hpp"
#include "tools/render/value_picture.hpp"
#include "tools/shell/json.hpp"
#include "tools/shell/noise.hpp"
#include "tools/shell/options.hpp"
#include "tools/shell/subcommand.hpp"
#include "tools/terminal_map.hpp"

namespace waymark::tools {
namespace {

struct DrawOptions {
  std::string kind = "map";
  MapOptions map;
  NotationOptions notation;
  NoiseOptions noise;
  std::string route, formula, automaton, start, query = "cost", data_file;
  PictureFiles files;
  bool terminal = false, json = false;
};

// What is answered: the picture, and a word on it.
struct Sketch {
  std::string svg;
  std::string characters = {};  // for --terminal; empty: only of maps
  std::string formula = {};
  ExitCode code = ExitCode::Done;
};

constexpr std::size_t most_pairs = 200'000;  // of pose and state of the automaton

class Drawing {
 public:
  Drawing(const DrawOptions& options, const Session& session)
      : options_(options), session_(session), map_(read_map(options.map)), arena_(map_.vocabulary()) {}

  Sketch sketch() {
    if (options_.kind == "formula") return tree();
    if (options_.kind == "automaton") return automaton();
    if (options_.kind == "product") return product();
    if (options_.kind == "lasso" && options_.route.empty()) return lasso();
    if (options_.kind == "policy" || options_.kind == "values") return values();
    if (!options_.formula.empty()) return planned();
    Picture picture{.map = &map_};
    if (!options_.route.empty())
      picture.route = plan::parse_walk(read_file(options_.route), map_, source_name(options_.route));
    else if (options_.kind == "route")
      throw UsageError("draw route needs --formula or --route");
    return walked(picture);
  }

 private:
  // Of the map's names; of any names where no map is needed.
  ltl::Formula formula(ltl::Arena& arena, ltl::Unknown unknown) const {
    if (options_.formula.empty()) throw UsageError("draw " + options_.kind + " needs --formula");
    const Text text{.text = options_.formula, .source = ""};
    if (unknown == ltl::Unknown::Reject) return parse_on_map(text, arena, options_.notation, options_.map.map);
    return parse_formula(text, arena, parse_options(options_.notation, unknown));
  }
  ltl::Formula formula() { return formula(arena_, ltl::Unknown::Reject); }

  Sketch walked(const Picture& picture) const {
    return {options_.files.given() ? drawn_whole(picture, session_.stop) : "",
            terminal_map(map_, picture.route, session_.out), picture.formula ? ltl::print(*picture.formula) : ""};
  }

  Sketch tree_of(ltl::Formula f) const { return {graph_picture(dot_of_tree(f), session_.stop), "", ltl::print(f)}; }
  Sketch tree() const {
    ltl::Arena names;
    return tree_of(formula(names, ltl::Unknown::Add));
  }

  Sketch automaton() const {
    if (!options_.automaton.empty()) {
      const plan::GivenAutomaton given =
          plan::read_given_automaton(read_file(options_.automaton), source_name(options_.automaton));
      if (const auto* dfa = std::get_if<automata::Dfa>(&given))
        return {graph_picture(automata::write_dot(*dfa), session_.stop)};
      const auto dot = automata::write_dot_within(std::get<automata::Automaton>(given), most_drawn_edges);
      if (!dot) throw GaveUp("not drawn: the automaton has more than " + std::to_string(most_drawn_edges) + " edges");
      return {graph_picture(*dot, session_.stop)};
    }
    ltl::Arena names;
    const ltl::Formula f = formula(names, ltl::Unknown::Add);
    return {graph_picture(automata::write_dot(translate(f, session_.stop)), session_.stop), "", ltl::print(f)};
  }

  Sketch product() {
    const ltl::Formula f = formula();
    const automata::Dfa dfa = translate(f, session_.stop);
    const auto starts = start_poses(options_.start, map_);
    const auto composed = plan::compose(map_, dfa, starts, {.states = SIZE_MAX, .stop = session_.stop});
    if (!composed) throw Interrupted();
    return {product_svg(picture_of(*composed), session_.stop), "", ltl::print(f)};
  }

  // The plan of the formula on its map, as `waymark plan` would give it.
  Sketch planned() {
    const ltl::Formula f = formula();
    const automata::Dfa dfa = translate(f, session_.stop);
    const CorridorRun run = run_corridor(map_, dfa, f, start_poses(options_.start, map_), session_.stop);
    Sketch out = walked({.map = &map_, .dfa = &dfa, .formula = f, .route = shown(run)});
    if (shown(run)) return out;
    complain("note", "the picture has no route: " + std::get<plan::Infeasible>(run.destination).reason);
    out.code = ExitCode::No;
    return out;
  }

  Sketch lasso() {
    const ltl::Formula f = formula();
    const auto starts = start_poses(options_.start, map_);
    const PlannedLasso plan = planned_lasso({map_, starts, f, nullptr}, {}, session_.stop);
    Picture picture{.map = &map_, .omega = &plan.automaton, .formula = f};
    if (plan.lasso) picture.route = *plan.lasso;
    Sketch out = walked(picture);
    if (plan.lasso) return out;
    complain("note", "the picture has no lasso: none satisfies the formula");
    out.code = ExitCode::No;
    return out;
  }

  // By pose, while the automaton is in the state that it is in at the start.
  Sketch values() {
    const ltl::Formula f = formula();
    const automata::Dfa dfa = translate(f, session_.stop);
    const plan::PoseId start = start_poses(options_.start, map_).front();
    const plan::Mdp mdp = plan::mdp_of(map_, start, noise_of(options_.noise));
    const plan::TaskTable table(dfa, mdp.letters());
    const auto product =
        plan::ProductMdp<plan::Mdp>::explore(mdp, table, {.states = most_pairs, .stop = session_.stop});
    if (session_.stop.stop_requested()) throw Interrupted();
    if (!product) throw GaveUp("not drawn: the product has more than " + std::to_string(most_pairs) + " states");
    const bool cost = options_.query == "cost";
    const plan::IterationOptions limits{.keep_values = true, .stop = session_.stop};
    const auto decided = cost ? plan::least_cost(*product, limits) : plan::greatest_probability(*product, limits);
    if (!decided) throw GaveUp("value iteration came to no end within its limits");
    render::ValuePage page{.map = &map_, .formula = ltl::print(f, ltl::Style::Unicode)};
    page.marks = marks(*product, *decided, cost);
    const plan::Pose pose = map_.pose(start);
    page.caption = std::string(cost ? "least expected cost" : "greatest probability") + " at the start " +
                   plan::show(pose) + ": " + value_text(decided->value.middle(), cost) +
                   "; by pose, with the automaton as at the start; darker is better";
    return {render::draw_values(page), "", ltl::print(f)};
  }

  static std::string value_text(double value, bool cost) {
    if (std::isinf(value)) return "∞";
    return fixed(value, cost && value == std::round(value) ? 0 : 2);
  }

  std::vector<render::PoseMark> marks(const plan::ProductMdp<plan::Mdp>& product, const plan::Decided& decided,
                                      bool cost) const {
    std::vector<render::PoseMark> out;
    if (decided.values.empty()) return out;  // the value at the start says it all
    std::uint32_t first = UINT32_MAX;        // the state of the automaton at the start
    product.for_each_state([&](const auto& s) {
      if (s.index == product.starts().front()) first = s.task;
    });
    double most = 1;
    std::vector<double> value;
    product.for_each_state([&](const auto& s) {
      if (s.task != first) return;
      const std::uint32_t choice = decided.strategy.choice[s.index];
      const bool goal = product.is_goal(s), acts = choice != plan::Strategy::none && !goal;
      const double v = cost && !acts && !goal ? std::numeric_limits<double>::infinity() : decided.values[s.index];
      render::PoseMark mark{.pose = plan::PoseId{s.place}, .value = value_text(v, cost)};
      if (options_.kind == "policy" && acts) mark.action = plan::parse_action(product.model().action(s.place, choice));
      if (options_.kind == "policy" && !acts) mark.value.clear();
      if (cost && !std::isinf(v)) most = std::max(most, v);
      value.push_back(v);
      out.push_back(std::move(mark));
    });
    for (std::size_t i = 0; i < out.size(); ++i)
      out[i].share = !cost ? value[i] : std::isinf(value[i]) ? 0 : 1 - value[i] / (most + 1);
    return out;
  }

  const DrawOptions& options_;
  const Session& session_;
  plan::Map map_;
  ltl::Arena arena_;
};

Sketch sketch_of(const DrawOptions& options, const Session& session) {
  const bool curve = options.kind == "curve", data = curve || options.kind == "table";
  if (data == options.data_file.empty())
    throw UsageError("draw curve and draw table need --from FILE, and nothing else does");
  if (!data) return Drawing(options, session).sketch();
  const std::string text = read_file(options.data_file), source = source_name(options.data_file);
  return {curve ? curves_picture(text, source) : table_picture(text, source)};
}

ExitCode run_draw(const DrawOptions& options, const Session& session) {
  if (!options.route.empty() && !options.formula.empty()) throw UsageError("give --route or --formula, not both");
  if (!options.terminal || options.files.given()) check_picture_files(options.files);
  const Sketch sketch = sketch_of(options, session);
  if (options.terminal && sketch.characters.empty())
    throw UsageError("--terminal draws map, route and lasso; " + options.kind + " needs --svg, --png or --pdf");
  if (options.files.given()) write_picture(sketch.svg, options.files);
  if (options.terminal) std::cout << sketch.characters;
  if (!options.json) return sketch.code;
  JsonObject json;
  json.add("kind", options.kind);
  if (!sketch.formula.empty()) json.add("formula", sketch.formula);
  for (const auto& [key, file] : {std::pair{"svg", &options.files.svg}, std::pair{"png", &options.files.png},
                                  std::pair{"pdf", &options.files.pdf}})
    if (!file->empty()) json.add(key, *file);
  std::cout << json.add("found", sketch.code == ExitCode::Done).text() << '\n';
  return sketch.code;
}

}  // namespace

Runner setup_draw(Command command) {
  const auto options = std::make_shared<DrawOptions>();
  command
      .add_option("kind", options->kind, "what is drawn; formula: its syntax tree; a map with --formula has its route")
      .one_of({"map", "route", "lasso", "formula", "automaton", "product", "policy", "values", "curve", "table"})
      .type_name("KIND")
      .show_default();
  command.add_option("--formula", options->formula, "the task: planned on the map, translated, or drawn itself")
      .type_name("TEXT");
  command.add_option("--route", options->route, "a route or trajectory file (docs/formats); - is standard input")
      .type_name("FILE");
  command.add_option("--automaton", options->automaton, "an automaton in HOA; - is standard input").type_name("FILE");
  command
      .add_option("--from", options->data_file,
                  "of curve: an answer of compare --json; of table: CSV, TSV or JSON lines; - is standard input")
      .type_name("FILE");
  command.add_option("--query", options->query, "of policy and values: least cost, or greatest probability")
      .one_of({"cost", "probability"})
      .show_default();
  add_notation_options(command, options->notation);
  add_map_options(command, options->map);
  add_start_option(command, options->start);
  add_noise_options(command, options->noise);
  add_picture_options(command.in("Output"), options->files);
  command.in("Output").add_flag("--terminal", options->terminal, "map, route and lasso in characters");
  command.in("Output").add_flag("--json", options->json, "one JSON object: what was drawn, and the files");
  return [options](const Session& session) { return run_draw(*options, session); };
}

}  // namespace waymark::tools

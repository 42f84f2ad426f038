#include "tools/studio/formulas.hpp"

#include "libautomata/hoa/dot_finite.hpp"
#include "libautomata/hoa/dot_omega.hpp"
#include "libautomata/omega/edges.hpp"
#include "libltl/limits.hpp"
#include "libltl/text/print.hpp"
#include "libplan/solve/task_automaton.hpp"
#include "tools/answer.hpp"
#include "tools/automaton_output.hpp"
#include "tools/explanation.hpp"
#include "tools/render/automaton_picture.hpp"
#include "tools/shell/exit_code.hpp"
#include "tools/translations.hpp"
#include "tools/understood.hpp"

namespace waymark::studio {
namespace {

using tools::Json;
using tools::JsonArray;
using tools::JsonObject;

// Small enough to be laid out at once: many may be asked for, and others wait.
render::Layout layout_for(const Context& context) {
  return {.edges = most_drawn_edges, .seconds = most_layout_seconds, .stop = context.stop};
}

ltl::Semantics semantics_of(const Request& request) {
  return request.one_of("semantics", {"finite", "infinite"}) == "finite" ? ltl::Semantics::Finite
                                                                         : ltl::Semantics::Infinite;
}

// A formula over the propositions of a map.
struct Written {
  std::shared_ptr<const World> world;
  ltl::Arena arena;
  ltl::Formula formula;

  Written(const Request& request, const Context& context)
      : world(context.worlds.of(request.text_or("map", "grid"))),
        arena(world->map.vocabulary()),
        formula(formula_of(request, arena)) {}
};

Json drawing(const std::optional<std::string>& dot, const Context& context) {
  if (!dot) return Json();
  std::string left_out;
  const auto laid_out = render::lay_out_or_leave_out(*dot, layout_for(context), left_out);
  if (!laid_out) return Json();
  render::Svg svg;
  svg.open("svg", "xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 " + render::number(laid_out->width) + ' ' +
                      render::number(laid_out->height) + "\" width=\"" + render::number(laid_out->width) +
                      "\" height=\"" + render::number(laid_out->height) + '"');
  svg.raw(laid_out->content);
  svg.close("svg");
  return svg.str();
}

JsonObject drawn(const automata::Dfa& dfa, const Context& context) {
  JsonArray accepting, traps;
  for (std::uint32_t q = 0; q < dfa.states(); ++q) {
    if (dfa.is_accepting(automata::StateId{q})) accepting.add(q);
    if (dfa.is_trap(automata::StateId{q})) traps.add(q);
  }
  const bool readable = automata::count_edges(dfa, most_drawn_edges).has_value();
  return tools::json_of(tools::size_of(dfa))
      .add("initial", dfa.initial().index)
      .add("accepting", accepting)
      .add("traps", traps)
      .add("svg", drawing(readable ? std::optional(automata::write_dot(dfa)) : std::nullopt, context));
}

JsonObject drawn(const automata::Automaton& automaton, const Context& context) {
  return JsonObject()
      .add("states", automaton.states())
      .add("edges", automata::count_edges(automaton.transitions()))
      .add("sets", automaton.acceptance().sets)
      .add("propositions", automaton.reads().size())
      .add("initial", automaton.initial().index)
      .add("svg", drawing(automata::write_dot_within(automaton, most_drawn_edges), context));
}

}  // namespace

JsonObject write_formula(const Request& request, const Context& context) {
  const Written written(request, context);
  const ltl::Formula f = written.formula;
  const plan::Map& map = written.world->map;
  return JsonObject()
      .add("formula", ltl::print(f))
      .add("unicode", ltl::print(f, ltl::Style::Unicode))
      .add("latex", ltl::print(f, ltl::Style::Latex))
      .add("english", JsonObject()
                          .add("finite", tools::in_english(f, ltl::Semantics::Finite, map))
                          .add("infinite", tools::in_english(f, ltl::Semantics::Infinite, map)));
}

JsonObject explain_formula(const Request& request, const Context& context) {
  const Written written(request, context);
  const auto semantics = semantics_of(request);
  try {
    const ltl::Limits limits{.stop = context.stop};
    return tools::json_of(tools::explain(written.formula, semantics, true, limits), ltl::print(written.formula),
                          semantics);
  } catch (const tools::ExplanationLimit&) {
    throw tools::GaveUp("no automaton within the limits");
  }
}

JsonObject translate_formula(const Request& request, const Context& context) {
  const Written written(request, context);
  const std::string semantics = request.one_of("semantics", {"finite", "infinite"});
  const std::string format = request.one_of("format", {"hoa", "dot", "never", "lbtt", "ba", "tsv"});
  const tools::Translation& translation = tools::find_translation(semantics, request.text_or("to", ""));
  const tools::Translated made = translation.run(written.formula, {.stop = context.stop});
  if (std::holds_alternative<automata::Exhausted>(made)) throw tools::GaveUp("no automaton within the limits");
  const tools::Shown about{.name = ltl::print(written.formula),
                           .unicode_name = ltl::print(written.formula, ltl::Style::Unicode),
                           .semantics = semantics};
  const tools::OutputOptions output{.format = format, .edges = 100'000};
  struct Show {
    const tools::Shown& about;
    const tools::OutputOptions& output;
    tools::Reply operator()(const automata::Dfa& dfa) const { return tools::show(dfa, about, output); }
    tools::Reply operator()(const automata::Translated& omega) const {
      return tools::show(omega.automaton, about, output);
    }
    tools::Reply operator()(const automata::TranslatedForMdps& ldba) const {
      return tools::show(ldba.automaton, about, output);
    }
    tools::Reply operator()(const automata::Exhausted&) const { throw std::logic_error("no automaton to show"); }
  };
  const tools::Reply reply = std::visit(Show{about, output}, made);
  if (!reply.problem.empty()) throw tools::GaveUp(reply.problem);
  return JsonObject().add("format", format).add("text", reply.text);
}

JsonObject draw_automaton(const Request& request, const Context& context) {
  const Written written(request, context);
  if (semantics_of(request) == ltl::Semantics::Finite)
    return drawn(tools::translate(written.formula, context.stop), context);
  const auto automaton = plan::lasso_automaton(written.formula, {.stop = context.stop});
  if (!automaton) throw tools::GaveUp("no automaton within the limits");
  return drawn(*automaton, context);
}

}  // namespace waymark::studio

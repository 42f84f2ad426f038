#include "tools/studio/walks.hpp"

#include <algorithm>

#include "libautomata/finite/run.hpp"
#include "libltl/formula.hpp"
#include "libltl/meaning/progress.hpp"
#include "libltl/rewriting/simplify.hpp"
#include "libltl/text/print.hpp"
#include "libplan/solve/task_automaton.hpp"
#include "tools/corridor.hpp"
#include "tools/shell/exit_code.hpp"

namespace waymark::studio {
namespace {

using tools::Json;
using tools::JsonArray;
using tools::JsonObject;

constexpr std::size_t most_tree = 20'000;  // nodes of a formula that is written

// The word with the formulas that its letters leave: what is common to finite and infinite words.
struct Walked {
  std::shared_ptr<const World> world;
  ltl::Arena arena;
  ltl::Formula formula;
  plan::Trajectory walk;
  std::size_t repeated;  // actions at the end; of finite words without a meaning
  ltl::Trace word;
  std::vector<ltl::Formula> rests = {};

  Walked(const Request& request, const Context& context, ltl::Semantics semantics)
      : world(context.worlds.of(request.text_or("map", "grid"))),
        arena(world->map.vocabulary()),
        formula(formula_of(request, arena)),
        walk(request.trajectory("trajectory", world->map)),
        repeated(request.count_or("cycle", 0, 0, walk.actions.size())),
        word(plan::word_of(walk, world->map)) {
    const auto over = semantics == ltl::Semantics::Finite ? ltl::Over::Rest : ltl::Over::Infinite;
    ltl::Formula rest = formula;
    for (const ltl::Letter& letter : word) {
      if (context.stop.stop_requested()) throw tools::Interrupted();
      rest = ltl::simplify(ltl::progress(rest, letter, semantics), over);
      if (ltl::tree_size(rest) > most_tree) throw tools::GaveUp("what remains of the formula is too large");
      rests.push_back(rest);
    }
  }

  JsonObject step(std::size_t i) const {
    const plan::Map& map = world->map;
    const plan::Pose pose = map.pose(walk.poses[i]);
    JsonArray letter;
    for (const ltl::Proposition p : word[i].members()) letter.add(map.vocabulary().name(p));
    return JsonObject()
        .add("pose", JsonArray().add(pose.x).add(pose.y).add(pose.heading))
        .add("action", i == 0 ? Json() : Json(plan::name(walk.actions[i - 1])))
        .add("letter", letter)
        .add("remains", ltl::print(rests[i]))
        .add("unicode", ltl::print(rests[i], ltl::Style::Unicode));
  }

  JsonObject head(bool satisfied) const {
    JsonArray progress;
    for (const ltl::Formula rest : rests) progress.add(ltl::print(rest));
    return JsonObject()
        .add("formula", ltl::print(formula))
        .add("map", world->map.name())
        .add("letters", word.size())
        .add("satisfied", satisfied)
        .add("progress", progress);
  }
};

JsonObject check_finite(const Request& request, const Context& context) {
  const Walked walked(request, context, ltl::Semantics::Finite);
  const automata::Dfa dfa = tools::translate(walked.formula, context.stop);
  const automata::Run run = automata::run(dfa, walked.word);
  const bool satisfied = ltl::holds(walked.word, walked.formula);
  if (run.accepted != satisfied || ltl::accepts_empty(walked.rests.back()) != satisfied)
    throw std::logic_error("automaton, progression and definition disagree on " + ltl::print(walked.formula));
  JsonArray steps;
  for (std::size_t i = 0; i < walked.word.size(); ++i) {
    const automata::StateId q = run.states[i + 1];
    steps.add(walked.step(i)
                  .add("states", JsonArray().add(q.index))
                  .add("verdict", dfa.is_accepting(q) ? "satisfied"
                                  : dfa.is_trap(q)    ? "lost"
                                                      : "open"));
  }
  return walked.head(satisfied)
      .add("lost_at", run.trapped ? Json(std::max<std::size_t>(1, *run.trapped)) : Json())
      .add("steps", steps);
}

// Every state in which a run on the letters so far may be.
std::vector<automata::StateId> after(const automata::Automaton& automaton, const std::vector<automata::StateId>& states,
                                     const ltl::Letter& letter) {
  std::vector<automata::StateId> out;
  for (const automata::StateId q : states)
    for (const automata::Branch& branch : automaton.next(q, letter)) out.push_back(automata::StateId{branch.target});
  std::sort(out.begin(), out.end());
  out.erase(std::unique(out.begin(), out.end()), out.end());
  return out;
}

// With `cycle` = n, the last n actions are repeated for ever: a lasso, which satisfies the formula or does not. Without
// it the word goes on, and only what every continuation shares is known.
JsonObject check_infinite(const Request& request, const Context& context) {
  const Walked walked(request, context, ltl::Semantics::Infinite);
  const auto automaton = plan::lasso_automaton(walked.formula, {.stop = context.stop});
  if (!automaton) throw tools::GaveUp("no automaton within the limits");
  const std::size_t actions = walked.walk.actions.size();
  const std::size_t cycle = walked.repeated;
  std::optional<bool> satisfied;
  if (cycle > 0) {
    if (walked.walk.poses[actions - cycle] != walked.walk.poses.back())
      throw RequestError(400, "request", "'cycle': the last actions do not lead back to where they begin");
    const std::vector<ltl::Letter> letters(walked.word.begin(), walked.word.end());
    const auto loop = letters.end() - static_cast<std::ptrdiff_t>(cycle);
    satisfied = ltl::holds(ltl::Lasso({letters.begin(), loop}, {loop, letters.end()}), walked.formula);
  }
  std::vector<automata::StateId> states{automaton->initial()};
  std::optional<std::size_t> lost;
  JsonArray steps;
  for (std::size_t i = 0; i < walked.word.size(); ++i) {
    states = after(*automaton, states, walked.word[i]);
    if (states.empty() && !lost) lost = i;
    JsonArray shown;
    for (const automata::StateId q : states) shown.add(q.index);
    steps.add(walked.step(i).add("states", shown).add("verdict", states.empty() ? "lost" : "open"));
  }
  return walked.head(satisfied.value_or(false))
      .add("semantics", "infinite")
      .add("decided", satisfied.has_value())
      .add("lost_at", lost ? Json(*lost + 1) : Json())
      .add("steps", steps);
}

}  // namespace

JsonObject check_walk(const Request& request, const Context& context) {
  if (request.one_of("semantics", {"finite", "infinite"}) == "finite") return check_finite(request, context);
  return check_infinite(request, context);
}

}  // namespace waymark::studio

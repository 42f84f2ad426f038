// waymark plan on a map beyond one route of a finite task: the K cheapest routes, and lassos of tasks over infinite
// words.
#pragma once
#include <iosfwd>
#include <optional>
#include <span>
#include <stop_token>
#include <string>

#include "libautomata/omega/automaton.hpp"
#include "libltl/formula.hpp"
#include "libplan/solve/least_lasso.hpp"
#include "libplan/solve/task_automaton.hpp"
#include "libplan/world/map.hpp"
#include "tools/shell/exit_code.hpp"
#include "tools/shell/json.hpp"
#include "tools/shell/subcommand.hpp"

namespace waymark::tools {

struct WalkOptions {
  std::string order = "prefix";  // of lassos
  std::string svg = {};
  std::size_t top = 1;
  bool json = false;
  double load = 0, translate = 0;  // seconds that reading the map took, and the translation of a DFA
  JsonObject head = {};            // what comes first in the JSON
  bool adds_route = false;         // … and prefix and one round of the cycle as a route, with its cost
  std::string tree = {};           // a file: the lasso as a behaviour tree
};

// The task on the map: the formula, or the automaton where there is none.
struct WalkTask {
  const plan::Map& map;
  std::span<const plan::PoseId> starts;
  std::optional<ltl::Formula> formula;
  const plan::GivenAutomaton* given = nullptr;
};

// The certified lasso that comes first in the order; of several starts the first whose lasso does. Throws Interrupted,
// UsageError for an automaton about finite words.
ExitCode plan_lasso(const WalkTask& task, const WalkOptions& options, const Session& session, std::ostream& out);

// The same, found and not printed.
struct PlannedLasso {
  JsonObject json;  // as printed with --json
  std::optional<plan::CertifiedLasso> lasso;
  automata::Automaton automaton;
};
PlannedLasso planned_lasso(const WalkTask& task, const WalkOptions& options, const std::stop_token& stop);

// The cheapest routes of a DFA, certified, of all starts together.
ExitCode plan_routes(const WalkTask& task, const automata::Dfa& dfa, const WalkOptions& options, const Session& session,
                     std::ostream& out);

}  // namespace waymark::tools

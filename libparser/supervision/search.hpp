// The search for consistent programs: those whose plan from the gold start pose ends at the gold end pose.
//
//   one step      all goals of one or two literals under reach, next, advance and face; forward k; stay. Goals are
//                 minimal: a pair is kept when neither literal does the job alone
//   oriented      orient, then forward k or advance with one or two literals: for starts whose heading is unknown
//   more steps    the gold route cut where it changes between turning and moving; each part by a short step that does
//                 just that part; kept when the plan of the whole is the gold route
// One-step goals are tested by bit sets over the arrivals in shortlex order: the plan of a goal ends at its first set
// bit.
#pragma once
#include <vector>

#include "libparser/programs/execute.hpp"
#include "libparser/programs/postfix_grammar.hpp"

namespace waymark::parser {

struct Consistent {
  Program program;          // that is consistent
  bool same_route = false;  // its plan is the gold route, not just one with the same end
};

struct GoldRoute {                    // the trajectory of a sentence
  plan::PoseId start, end;            // poses
  std::vector<plan::Action> actions;  // between them
  bool heading_unknown = false;       // of the start
  friend auto operator<=>(const GoldRoute&, const GoldRoute&) = default;
};

// Each program once.
std::vector<Consistent> consistent_programs(const Executor& executor, const PostfixGrammar& grammar,
                                            const GoldRoute& gold);

}  // namespace waymark::parser

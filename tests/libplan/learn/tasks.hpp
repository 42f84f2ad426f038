// Tasks for the tests of learners: a map and a formula, tabulated.
#pragma once
#include <string>

#include "libautomata/finite/ltlf_to_dfa.hpp"
#include "libltl/text/parse.hpp"
#include "libplan/learn/tabular_product.hpp"
#include "tests/libplan/maps.hpp"

namespace waymark::plan {

inline automata::Dfa dfa_of(const std::string& formula) {
  ltl::Arena arena;
  return automata::ltlf_to_dfa(ltl::parse(formula, arena));
}

inline TabularProduct task_on(const Map& map, const std::string& formula, PoseId start = PoseId{0},
                              const SlipChances& slip = {}) {
  return tabulate(map, dfa_of(formula), start, slip);
}

inline constexpr SlipChances slippery{.forward = 0.7, .left = 0.1, .right = 0.15, .back = 0.05};

}  // namespace waymark::plan

#include "libplan/model/jani/read_jani.hpp"

#include "libplan/model/jani/jani_program.hpp"

namespace waymark::plan {

Mdp parse_jani(std::string_view text, std::string_view source, const ltl::Limits& limits, const PrismOptions& options) {
  const JaniText in(text, source);
  PrismExpressions expressions(in);
  JaniExpressions names(in, expressions);
  const PrismProgram program = read_jani_program(in, expressions, names, options.constants);
  expect_given(in, options.constants, program.given);
  return explore(program, expressions, in, {program.labels, cost_structure(program, options.rewards, in)}, limits);
}

}  // namespace waymark::plan

#include "libplan/model/prism/read_prism.hpp"

#include <algorithm>

namespace waymark::plan {

std::optional<std::size_t> cost_structure(const PrismProgram& program, const std::string& wanted,
                                          const ModelText& text) {
  const auto named = [&](auto matches) -> std::optional<std::size_t> {
    const auto found = std::find_if(program.rewards.begin(), program.rewards.end(), matches);
    if (found == program.rewards.end()) return std::nullopt;
    return static_cast<std::size_t>(found - program.rewards.begin());
  };
  if (!wanted.empty()) {
    const auto found = named([&](const PrismProgram::Rewards& r) { return r.name == wanted; });
    if (!found) text.fail(text.end(), "there are no rewards of the name \"" + wanted + '"');
    return found;
  }
  const auto usual = named([](const PrismProgram::Rewards& r) { return r.name == "cost" || r.name == "steps"; });
  return usual || program.rewards.empty() ? usual : std::optional<std::size_t>(0);
}

Mdp parse_prism(std::string_view text, std::string_view source, const ltl::Limits& limits,
                const PrismOptions& options) {
  PrismTokens in(text, source);
  PrismExpressions expressions(in);
  const PrismProgram program = read_prism_program(in, expressions, options.constants);
  expect_given(in, options.constants, program.given);
  return explore(program, expressions, in, {program.labels, cost_structure(program, options.rewards, in)}, limits);
}

}  // namespace waymark::plan

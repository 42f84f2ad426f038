// An instruction that was understood on a map, and its answer: over finite words a route, else what stands before its
// lasso.
#pragma once
#include <optional>
#include <span>
#include <stop_token>
#include <string>
#include <vector>

#include "libparser/ground.hpp"
#include "tools/answer.hpp"

namespace waymark::tools {

struct Heard {
  const std::optional<std::string>& id;
  const std::string& text;
  const plan::Map& map;
  std::span<const plan::PoseId> starts;
  const std::vector<parser::Reading>& readings;
  std::size_t shown = 1;  // readings in the answer
};

// The answer of the first reading. Its automaton: `dfa`. Throws Interrupted.
Answer answer_of(const Heard& heard, const automata::Dfa& dfa, const std::stop_token& stop);
// The keys that come first in the answer of a task without end.
JsonObject head_of_lasso(const Heard& heard);

}  // namespace waymark::tools

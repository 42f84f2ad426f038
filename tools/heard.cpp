#include "tools/heard.hpp"

#include <algorithm>

#include "libltl/text/print.hpp"
#include "tools/understood.hpp"

namespace waymark::tools {

Answer answer_of(const Heard& heard, const automata::Dfa& dfa, const std::stop_token& stop) {
  const ltl::Formula formula = heard.readings.front().formula;
  Answer answer{.id = heard.id,
                .instruction = heard.text,
                .understood = in_english(formula, ltl::Semantics::Finite, heard.map),
                .formula = formula,
                .corridor_run = run_corridor(heard.map, dfa, formula, heard.starts, stop)};
  for (std::size_t i = 0; i < std::min(heard.readings.size(), heard.shown); ++i)
    answer.readings.push_back({heard.readings[i].formula, heard.readings[i].probability});
  return answer;
}

JsonObject head_of_lasso(const Heard& heard) {
  JsonArray array;
  for (std::size_t i = 0; i < std::min(heard.readings.size(), heard.shown); ++i)
    array.add(JsonObject()
                  .add("formula", ltl::print(heard.readings[i].formula))
                  .add("probability", heard.readings[i].probability));
  JsonObject head;
  if (heard.id) head.add("id", *heard.id);
  return head.add("instruction", heard.text)
      .add("understood", in_english(heard.readings.front().formula, ltl::Semantics::Infinite, heard.map))
      .add("readings", array);
}

}  // namespace waymark::tools

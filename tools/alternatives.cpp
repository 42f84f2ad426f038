#include "tools/alternatives.hpp"

#include <algorithm>

#include "libautomata/finite/product.hpp"
#include "libltl/text/print.hpp"
#include "libplan/plan_of.hpp"
#include "tools/answer.hpp"
#include "tools/corridor.hpp"
#include "tools/understood.hpp"

namespace waymark::tools {
namespace {

// A cheapest route of one formula and not of the other.
std::optional<plan::Route> route_of_only(ltl::Formula one, ltl::Formula other, const plan::Map& map,
                                         std::span<const plan::PoseId> starts, const std::stop_token& stop) {
  const auto planned = plan::plan_of(map, ltl::conjunction(one, ltl::negate(other)), starts,
                                     {.automaton_states = 20'000, .explain = false, .stop = stop});
  const auto* found = std::get_if<plan::CertifiedRoute>(&planned);
  return found != nullptr ? std::optional(found->route()) : std::nullopt;
}

}  // namespace

std::vector<Alternative> alternatives(std::span<const parser::Reading> readings, const plan::Map& map,
                                      std::span<const plan::PoseId> starts, const std::stop_token& stop,
                                      std::size_t most, double least) {
  std::vector<Alternative> out;
  const ltl::Formula first = readings.front().formula;
  const automata::Dfa dfa = translate(first, stop);
  for (const parser::Reading& reading : readings.subspan(1)) {
    if (out.size() == most || reading.probability < least) break;
    const auto difference = automata::difference(dfa, translate(reading.formula, stop));
    if (!difference) continue;
    Alternative a{.formula = reading.formula,
                  .probability = reading.probability,
                  .english = in_english(reading.formula, ltl::Semantics::Finite, map),
                  .first_accepts = difference->first_accepts,
                  .vocabulary = difference->vocabulary,
                  .word = difference->word};
    a.route = route_of_only(first, reading.formula, map, starts, stop);
    a.first_accepts_route = a.route.has_value();
    if (!a.route) a.route = route_of_only(reading.formula, first, map, starts, stop);
    out.push_back(std::move(a));
  }
  return out;
}

JsonArray json_of(std::span<const Alternative> alternatives, const plan::Map& map) {
  JsonArray all;
  for (const Alternative& a : alternatives) {
    JsonObject difference;
    difference.add("word", ltl::show(a.word, a.vocabulary))
        .add("word_of", a.first_accepts ? "first" : "this")
        .add("route", a.route ? Json(json_of(*a.route, map)) : Json());
    if (a.route) difference.add("route_of", a.first_accepts_route ? "first" : "this");
    all.add(JsonObject()
                .add("formula", ltl::print(a.formula))
                .add("english", a.english)
                .add("probability", a.probability)
                .add("distinguishing", difference));
  }
  return all;
}

}  // namespace waymark::tools

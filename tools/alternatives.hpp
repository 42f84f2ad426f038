// Readings of a text that differ in meaning, each with what tells it from the first: a shortest word, and a route.
#pragma once
#include <optional>
#include <span>
#include <stop_token>
#include <string>
#include <vector>

#include "libltl/word.hpp"
#include "libparser/ground.hpp"
#include "libplan/world/map.hpp"
#include "tools/shell/json.hpp"
#include "tools/shown_route.hpp"

namespace waymark::tools {

struct Alternative {
  ltl::Formula formula;
  double probability = 0;
  std::string english;
  bool first_accepts = false;             // the word: is it the first reading's, or this one's?
  ltl::Vocabulary vocabulary;             // of the word
  ltl::Trace word;                        // a shortest one that tells them apart
  std::optional<plan::Route> route = {};  // a cheapest one that only one of them accepts, if there is any
  bool first_accepts_route = false;
};

// Over finite words: at most `most` readings after the first, of at least `least` probability, each of another language.
std::vector<Alternative> alternatives(std::span<const parser::Reading> readings, const plan::Map& map,
                                      std::span<const plan::PoseId> starts, const std::stop_token& stop,
                                      std::size_t most = 3, double least = 0.02);
JsonArray json_of(std::span<const Alternative> alternatives, const plan::Map& map);

}  // namespace waymark::tools

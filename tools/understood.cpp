#include "tools/understood.hpp"

#include <algorithm>

#include "libltl/diagnostic.hpp"
#include "libltl/english/verbalise.hpp"
#include "libplan/world/observable_english.hpp"

namespace waymark::tools {

std::string in_english(ltl::Formula formula, ltl::Semantics semantics, const plan::Map& map) {
  return ltl::verbalise(formula, {semantics, plan::hallway_english(map.vocabulary())});
}

std::string in_english(ltl::Formula formula, ltl::Semantics semantics) {
  const ltl::Vocabulary& vocabulary = formula.arena().vocabulary();
  return ltl::verbalise(formula, {semantics, [&vocabulary](ltl::Proposition p) {
                                    std::string name = vocabulary.name(p);
                                    std::replace(name.begin(), name.end(), '_', ' ');
                                    return ltl::place(name);
                                  }});
}

namespace {
std::string quoted(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "'" : ", '") + word + "'";
  return text;
}
}  // namespace

std::string not_understood_message(const std::string& text, const parser::Understanding& understood) {
  std::string message = "not understood: '" + text + "'";
  if (understood.missing) {
    message += "; nothing here is called '" + understood.missing->words + "'";
    if (!understood.missing->nearest.empty()) message += "; nearest: " + quoted(understood.missing->nearest);
  } else if (!understood.words_not_understood.empty()) {
    message += "; no command says " + quoted(understood.words_not_understood);
  }
  return ltl::printable(message) + " (--force answers all the same)";
}

JsonObject not_understood_json(const std::string& text, const std::string& map,
                               const parser::Understanding& understood) {
  JsonArray words;
  for (const std::string& word : understood.words_not_understood) words.add(word);
  JsonObject missing;
  if (understood.missing) {
    JsonArray nearest;
    for (const std::string& name : understood.missing->nearest) nearest.add(name);
    missing.add("words", understood.missing->words).add("nearest", nearest);
  }
  return JsonObject()
      .add("instruction", text)
      .add("map", map)
      .add("formula", Json())
      .add("status", "not understood")
      .add("understood", Json())
      .add("probability", understood.probability)
      .add("words", words)
      .add("missing", understood.missing ? Json(missing) : Json())
      .add("readings", JsonArray());
}

}  // namespace waymark::tools

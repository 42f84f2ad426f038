#include "libparser/model/program_language.hpp"

#include <unordered_map>
#include <utility>

#include "libltl/diagnostic.hpp"

namespace waymark::parser {
namespace {

// "ahead_chair" → {"ahead", "chair"}, "chair" → {"here", "chair"}, "dead_end" → {"here", "dead_end"}.
std::pair<std::string, std::string> parts_of(const std::string& literal) {
  for (const char* direction : {"ahead", "left", "right", "behind", "next", "turned", "place"}) {
    const std::string prefix = std::string(direction) + "_";
    if (literal.rfind(prefix, 0) == 0) return {direction, literal.substr(prefix.size())};
  }
  return {"here", literal};
}

}  // namespace

Columns::Columns(const PostfixGrammar& grammar) : tokens(grammar.tokens()) {
  std::unordered_map<std::string, std::uint16_t> index;
  const auto part = [&](const std::string& part_name) {
    const auto [it, is_new] = index.try_emplace(part_name, static_cast<std::uint16_t>(size()));
    if (is_new) parts.push_back(part_name);
    return it->second;
  };
  mention = part("mention");
  for (std::size_t t = 0; t < tokens; ++t) {
    const std::string& token_name = grammar.name(static_cast<Token>(t));
    if (grammar.is_literal(static_cast<Token>(t))) {
      const auto [d, o] = parts_of(token_name);
      direction.push_back(part("direction " + d));
      thing.push_back(part("thing " + o));
    } else {
      const bool forward = t >= PostfixGrammar::first_forward && t < PostfixGrammar::first_literal;
      direction.push_back(part(forward ? "forward" : "operator"));
      thing.push_back(part(forward ? "count " + token_name.substr(8) : "operator " + token_name));
    }
  }
}

ProgramLanguage::ProgramLanguage(const ltl::Vocabulary& vocabulary, Dialect dialect)
    : vocabulary_(vocabulary), grammar_(vocabulary, dialect), columns_(grammar_) {}

void ProgramLanguage::check_vocabulary(const ltl::Vocabulary& vocabulary, std::string_view whose) const {
  if (vocabulary == vocabulary_) return;
  std::string message =
      "the model was trained on another vocabulary than that of " + std::string(whose) + ": ";
  for (const std::string& name : vocabulary_.names()) {
    if (vocabulary.find(name)) continue;
    throw ltl::FormatError("", 0, 0, message + "'" + name + "' is missing there");
  }
  for (const std::string& name : vocabulary.names()) {
    if (vocabulary_.find(name)) continue;
    throw ltl::FormatError("", 0, 0, message + "the model does not know '" + name + "'");
  }
  throw ltl::FormatError("", 0, 0, message + "the same names stand in another order");
}

}  // namespace waymark::parser

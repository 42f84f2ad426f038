// What the tests of this area share: the shipped maps, random programs, the corpus that may be missing.
#pragma once
#include <cstdlib>
#include <filesystem>
#include <random>
#include <vector>

#include "libparser/programs/postfix_grammar.hpp"
#include "libplan/world/map.hpp"
#include "libplan/world/read_map.hpp"

namespace waymark::parser {

inline const std::vector<plan::Map>& shipped_maps() {
  static const std::vector<plan::Map> maps = [] {
    const std::filesystem::path data = std::filesystem::path(WAYMARK_SOURCE_DIR) / "data";
    return std::vector<plan::Map>{plan::read_map("grid", data), plan::read_map("jelly", data),
                                  plan::read_map("l", data)};
  }();
  return maps;
}

// Where the SAIL corpus is looked for: $WAYMARK_SHARED/sail, else ../shared/sail beside the source tree.
inline std::filesystem::path sail_directory() {
  const char* const shared = std::getenv("WAYMARK_SHARED");
  const std::filesystem::path root =
      shared != nullptr ? shared : std::filesystem::path(WAYMARK_SOURCE_DIR) / ".." / "shared";
  return root / "sail";
}

// A random complete program of the decoder's language, token by token.
inline Program random_program(const PostfixGrammar& grammar, std::mt19937_64& random) {
  std::vector<Token> tokens;
  for (PrefixState state; !state.ended;) {
    std::vector<Token> allowed;
    for (std::size_t t = 0; t < grammar.tokens(); ++t)
      if (grammar.allowed(state, static_cast<Token>(t))) allowed.push_back(static_cast<Token>(t));
    // Literals are most of the tokens: every second time, choose among the others.
    std::vector<Token> operators;
    for (Token t : allowed)
      if (!grammar.is_literal(t)) operators.push_back(t);
    const auto& pool = !operators.empty() && random() % 2 == 0 ? operators : allowed;
    tokens.push_back(pool[random() % pool.size()]);
    state = grammar.after(state, tokens.back());
  }
  return grammar.program_of(tokens);
}

}  // namespace waymark::parser

// The rewrite rules of simplify.hpp: each a comment (match, result), a function, and a row here.
//
// A rule is a claim about words: at every position of a finite (`finite`) or infinite (`infinite`) word the two sides
// agree. The tests hold every rule to every claim, and every missing claim to a counterexample.
#pragma once
#include <optional>
#include <span>
#include <string_view>

#include "libltl/formula.hpp"
#include "libltl/rewriting/implication.hpp"

namespace waymark::ltl {

struct RewriteRule {
  std::string_view name;
  std::optional<Formula> (*apply)(Formula f, Implication& implies);  // nothing when f does not match
  bool finite, infinite;
};

// In the order in which they are tried.
std::span<const RewriteRule> rewrite_rules();

}  // namespace waymark::ltl

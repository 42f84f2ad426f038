// The rewrite rules of simplify.hpp. Each rule has a comment (match, result), a function, and a row here.
//
// A rule claims that its two sides agree at every position of a finite (`finite`) or infinite (`infinite`) word. The
// tests check every claim, and find a counterexample for every claim that a rule does not make.
#pragma once
#include <optional>
#include <span>
#include <string_view>

#include "libltl/formula.hpp"
#include "libltl/rewriting/implication.hpp"

namespace waymark::ltl {

struct RewriteRule {
  std::string_view name;                                             // of the function
  std::optional<Formula> (*apply)(Formula f, Implication& implies);  // nothing when f does not match
  bool finite, infinite;                                             // over which words both sides agree
};

// In the order in which they are tried.
std::span<const RewriteRule> rewrite_rules();

}  // namespace waymark::ltl

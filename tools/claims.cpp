#include "tools/claims.hpp"

#include <algorithm>
#include <array>

#include "libplan/world/json_reader.hpp"

namespace waymark::tools {
namespace {

// Names that the asker gave, and what the run that found the answer took.
constexpr std::array<std::string_view, 12> no_claims{
    "id",       "line",    "case",          "task",           "method", "seconds",
    "peak_mib", "product", "product_edges", "product_states", "roads",  "automaton_states"};

bool is_no_claim(std::string_view key) { return std::find(no_claims.begin(), no_claims.end(), key) != no_claims.end(); }

}  // namespace

const Claims::Value& Claims::member(const char* key) {
  asked_.insert(key);
  return in_.member(answer_, "", key);
}

std::string Claims::text(const char* key) { return in_.string(member(key), key); }

bool Claims::has(const char* key) const { return answer_.contains(key); }

std::optional<double> Claims::number(const char* key) {
  const Value& value = member(key);
  if (value.is_null()) return std::nullopt;
  if (value.is_string() && value == "inf") return INFINITY;
  return in_.number(value, key);
}

void Claims::expect_text(const char* key, std::string_view right) {
  if (!has(key)) return;
  const Value& value = member(key);
  add(value.is_string() && value == std::string(right), std::string(key) + " is " + value.dump());
}

void Claims::only(const Value& object, const std::string& path, const std::vector<std::string_view>& known) {
  for (const auto& item : object.items())
    if (std::find(known.begin(), known.end(), item.key()) == known.end()) add(std::nullopt, path + '.' + item.key());
}

std::vector<Claim> Claims::all() && {
  for (const auto& item : answer_.items())
    if (!asked_.contains(item.key()) && !is_no_claim(item.key())) add(std::nullopt, item.key());
  return std::move(claims_);
}

ExitCode verdict_of(const std::vector<Claim>& claims) {
  ExitCode code = ExitCode::Done;
  for (const Claim& claim : claims) {
    if (claim.holds == false) return ExitCode::No;
    if (!claim.holds) code = ExitCode::PartlyVerified;
  }
  return code;
}

const char* verdict_in_words(ExitCode verdict) {
  if (verdict == ExitCode::Done) return "verified";
  return verdict == ExitCode::No ? "refuted" : "partly verified";
}

}  // namespace waymark::tools

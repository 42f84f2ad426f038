// The claims of one printed answer: each is verified, refuted, or was not examined.
//
// A key of an answer that no examiner asked for is a claim that was not examined. Labels and the figures of the run
// that found the answer are no claims.
#pragma once
#include <algorithm>
#include <cmath>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "tools/shell/exit_code.hpp"

namespace waymark::plan {
class JsonReader;
}

namespace waymark::tools {

struct Claim {
  std::string text;
  std::optional<bool> holds;  // nothing: not examined
};

class Claims {
 public:
  using Value = nlohmann::json;

  Claims(const plan::JsonReader& in, const Value& answer) : in_(in), answer_(answer) {}

  void add(std::optional<bool> holds, std::string text) { claims_.push_back({std::move(text), holds}); }

  // A member of the answer, which is examined now. Throws ltl::FormatError where it is missing.
  const Value& member(const char* key);
  std::string text(const char* key);
  // A cost that no strategy keeps finite is the text "inf"; null is no number.
  std::optional<double> number(const char* key);
  bool has(const char* key) const;
  void is_figure(const char* key) { asked_.insert(key); }     // of the run that found this answer: no claim
  void expect_text(const char* key, std::string_view right);  // a key that may be missing
  // Members of an object inside of the answer that are not among these are not examined.
  void only(const Value& object, const std::string& path, const std::vector<std::string_view>& known);

  // All that were added; then those of the keys that nobody asked for.
  std::vector<Claim> all() &&;

 private:
  const plan::JsonReader& in_;
  const Value& answer_;
  std::set<std::string, std::less<>> asked_;
  std::vector<Claim> claims_;
};

// Done: all are verified; No: one is refuted; PartlyVerified: one was not examined.
ExitCode verdict_of(const std::vector<Claim>& claims);
const char* verdict_in_words(ExitCode verdict);

// Equal up to the rounding of sums.
inline bool is_close(double a, double b) {
  return std::isfinite(a) && std::isfinite(b) && std::abs(a - b) <= 1e-9 * std::max({1.0, std::abs(a), std::abs(b)});
}

}  // namespace waymark::tools

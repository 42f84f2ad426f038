// Names as PRISM's language has them [KNP11]: what is reserved, and how any text becomes a name.
#pragma once
#include <set>
#include <string>
#include <string_view>

namespace waymark::plan {

bool is_prism_reserved(std::string_view word);  // a word of the language

// Names for texts, all different and none of them reserved, nor among those given at the start.
class PrismNames {
 public:
  explicit PrismNames(std::set<std::string> taken = {}) : taken_(std::move(taken)) {}
  std::string add(std::string_view text);  // the name for the text; another one for each text

 private:
  std::set<std::string> taken_;
};

}  // namespace waymark::plan

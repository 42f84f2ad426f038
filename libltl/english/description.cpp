#include "libltl/english/description.hpp"

#include "libltl/text/print.hpp"

namespace waymark::ltl {

Described symbol(std::string_view name) {
  const std::string printed = print_name(name);
  return {.holds = printed + " holds", .fails = printed + " does not hold"};
}

Described place(const std::string& noun) {
  return {.holds = "you are at " + noun,
          .fails = "you are not at " + noun,
          .reach = "go to " + noun,
          .enter = "go to " + noun};
}

Described floor(const std::string& noun) {
  return {.holds = "you are on " + noun,
          .fails = "you are not on " + noun,
          .reach = "go to " + noun,
          .enter = "step on " + noun};
}

Described event(const std::string& action) {
  return {.holds = "you " + action, .fails = "you do not " + action, .enter = action, .act = action};
}

Described state(std::string holds, std::string fails) { return {.holds = std::move(holds), .fails = std::move(fails)}; }

std::vector<Described> described(const Vocabulary& vocabulary, const VerbaliseOptions& options) {
  std::vector<Described> out;
  for (std::uint32_t p = 0; p < vocabulary.size(); ++p)
    out.push_back(options.describe ? options.describe({p}) : symbol(vocabulary.name({p})));
  return out;
}

}  // namespace waymark::ltl

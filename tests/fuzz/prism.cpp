// PRISM's models, in its language and as explicit files (.tra, then .lab after a line "---"): refused with the place,
// or a model whose choices are distributions over its own states. Behind a line "===" stand properties.
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>

#include "libltl/diagnostic.hpp"
#include "libplan/model/formats/prism_properties.hpp"
#include "libplan/model/prism/read_prism.hpp"
#include "libplan/model/prism/read_prism_explicit.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace waymark;
  if (size > 4'096) return 0;
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  const std::size_t cut = text.find("\n---\n"), properties = text.find("\n===\n");
  try {
    if (properties != std::string_view::npos) {
      for (const plan::PrismProperty& p : plan::parse_prism_properties(
               {text.substr(0, properties + 1), ""}, {text.substr(properties + 5), ""}, {{"n", "3"}}, {.states = 200}))
        if (p.fault.empty() != (p.model != nullptr)) std::abort();
      return 0;
    }
    const plan::Mdp model =
        cut == std::string_view::npos
            ? plan::parse_prism(text, "", {.states = 2'000})
            : plan::parse_prism_explicit({std::string(text.substr(0, cut + 1)), std::string(text.substr(cut + 5))});
    for (std::uint32_t s = 0; s < model.states(); ++s)
      for (std::uint32_t k = 0; k < model.choices(s); ++k) {
        double sum = 0;
        for (std::uint32_t i = 0; i < model.outcome_count(s, k); ++i) {
          if (model.outcome(s, k, i).target >= model.states()) std::abort();
          sum += model.outcome(s, k, i).probability;
        }
        if (!(std::abs(sum - 1) < 1e-6)) std::abort();
      }
  } catch (const ltl::FormatError&) {
  } catch (const ltl::SyntaxError&) {
  }
  return 0;
}

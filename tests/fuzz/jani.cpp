// Models in JANI with their properties: refused with the place, or a model whose choices are distributions over its own
// states, and questions that have a model or a fault.
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "libltl/diagnostic.hpp"
#include "libplan/model/formats/jani_properties.hpp"
#include "libplan/model/jani/read_jani.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace waymark;
  if (size > 8'192) return 0;
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  const plan::PrismConstants constants{{"n", "3"}};
  try {
    const plan::Mdp model = plan::parse_jani(text, "", {.states = 2'000}, {constants, ""});
    for (std::uint32_t s = 0; s < model.states(); ++s)
      for (std::uint32_t k = 0; k < model.choices(s); ++k) {
        double sum = 0;
        for (std::uint32_t i = 0; i < model.outcome_count(s, k); ++i) {
          if (model.outcome(s, k, i).target >= model.states()) std::abort();
          sum += model.outcome(s, k, i).probability;
        }
        if (!(std::abs(sum - 1) < 1e-6)) std::abort();
      }
    for (const plan::PrismProperty& p : plan::parse_jani_properties({text, ""}, constants, {.states = 200}))
      if (p.fault.empty() != (p.model != nullptr)) std::abort();
  } catch (const ltl::FormatError&) {
  }
  return 0;
}

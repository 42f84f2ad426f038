// Transition systems in YAML: refused with a FormatError, or a model whose moves stay in it.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "libltl/diagnostic.hpp"
#include "libplan/model/formats/read_transition_system.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace waymark;
  if (size > 4'096) return 0;
  try {
    const plan::Mdp model =
        plan::parse_transition_system({reinterpret_cast<const char*>(data), size}, "transition system");
    for (std::uint32_t s = 0; s < model.states(); ++s)
      for (std::uint32_t k = 0; k < model.choices(s); ++k)
        if (model.outcome_count(s, k) != 1 || model.outcome(s, k, 0).target >= model.states()) std::abort();
  } catch (const ltl::FormatError&) {
  }
  return 0;
}

// Planning cases and street graphs in JSON: refused with a FormatError, or a model whose moves stay in it.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>
#include <variant>

#include "libltl/diagnostic.hpp"
#include "libplan/model/formats/read_case.hpp"
#include "libplan/model/formats/read_streets.hpp"

namespace {

template <class Model>
void stays_in(const Model& model) {
  for (std::uint32_t s = 0; s < model.states(); ++s)
    for (std::uint32_t k = 0; k < model.choices(s); ++k)
      model.for_each_outcome(s, k, [&](std::uint32_t t, waymark::plan::LetterId letter, double probability) {
        if (t >= model.states() || letter.index >= model.letters().size() || !(probability > 0)) std::abort();
      });
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace waymark;
  if (size > 4'096) return 0;
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  try {
    if (text.find("\"edges\"") == std::string_view::npos)
      std::visit([](const auto& model) { stays_in(model); }, plan::parse_case(text).model);
    else
      stays_in(plan::parse_streets(text));
  } catch (const ltl::FormatError&) {
  }
  return 0;
}

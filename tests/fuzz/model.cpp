// Weights files: refused with a FormatError, or a model that writes and reads back as the same bytes.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>

#include "libltl/diagnostic.hpp"
#include "libparser/linear_model.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace waymark;
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  try {
    const std::string written = parser::serialize(parser::parse_linear_model(bytes));
    if (parser::serialize(parser::parse_linear_model(written)) != written) std::abort();
  } catch (const ltl::FormatError&) {
  }
  return 0;
}

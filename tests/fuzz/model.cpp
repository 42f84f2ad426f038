// Model files: refused with a FormatError, or a model that writes and reads back as the same bytes. The checksum would
// keep nearly every mutation away from the reader, so the target seals its inputs itself.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>

#include "libltl/diagnostic.hpp"
#include "libltl/text/xxhash.hpp"
#include "libparser/model_file.hpp"

namespace {

using namespace waymark;

// With the checksum that the reader asks for.
std::string sealed(std::string body) {
  const std::uint64_t sum = ltl::xxh64(body);
  for (std::size_t k = 0; k < 8; ++k) body += static_cast<char>(sum >> (8 * k) & 0xFFU);
  return body;
}

void read(std::string_view bytes) {
  try {
    const std::string written = parser::serialize(parser::parse_grounder(bytes));
    if (parser::serialize(parser::parse_grounder(written)) != written) std::abort();
  } catch (const ltl::FormatError&) {
  }
}

// A seal that the reader does not accept would leave it untested without a word.
bool seal_fits() {
  const std::string file =
      parser::serialize(parser::grounder_of(parser::LinearModel(ltl::Vocabulary({"chair", "moved"}))));
  return sealed(file.substr(0, file.size() - 8)) == file;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const bool fits = seal_fits();
  if (!fits) std::abort();
  const std::string bytes(reinterpret_cast<const char*>(data), size);
  read(bytes);
  read(sealed(bytes));
  return 0;
}

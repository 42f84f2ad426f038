// HOA files: refused with a FormatError, or read, and then writing and reading again accepts the same language.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>

#include "libautomata/hoa.hpp"
#include "libltl/diagnostic.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace waymark;
  if (size > 4'096) return 0;
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  try {
    const automata::Dfa dfa = automata::read_hoa(text);
    if (dfa.states() > 200 || dfa.reads().size() > 12) return 0;  // writing spells guards out
    const std::string written = automata::write_hoa(dfa);
    if (automata::write_hoa(automata::read_hoa(written)) != written) std::abort();
  } catch (const ltl::FormatError&) {
  }
  return 0;
}

// HOA files: refused with a FormatError, or read, and then writing and reading again gives the same automaton, be it
// one on finite words or on infinite ones.
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>

#include "libautomata/hoa/finite.hpp"
#include "libautomata/hoa/omega.hpp"
#include "libltl/diagnostic.hpp"

namespace {

using namespace waymark;

void read_as_dfa(std::string_view text) {
  const automata::Dfa dfa = automata::read_hoa(text);
  if (dfa.states() > 200 || dfa.reads().size() > 12) return;  // writing spells guards out
  const std::string written = automata::write_hoa(dfa);
  if (automata::write_hoa(automata::read_hoa(written)) != written) std::abort();
}

void read_as_omega(automata::HoaAutomaton file) {
  automata::Budget budget(100'000, 200, {});
  try {
    const automata::Automaton automaton = automata::to_automaton(std::move(file), "", budget);
    const auto written = automata::write_hoa_within(automaton, 1'000);
    if (written && automata::write_hoa(automata::read_omega_hoa(*written)) != *written) std::abort();
  } catch (const automata::Budget::Exceeded&) {
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size > 4'096) return 0;
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  try {
    read_as_dfa(text);
  } catch (const ltl::FormatError&) {
  }
  try {
    automata::HoaReader reader(text, "");
    while (std::optional<automata::HoaAutomaton> file = reader.next()) {
      if (file->aborted) continue;
      if (file->propositions.size() > 12) return 0;
      read_as_omega(*std::move(file));
    }
  } catch (const ltl::FormatError&) {
  }
  return 0;
}

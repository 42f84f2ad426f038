// Readers of commands: rows, folds, domains, landmarks, grammars, word vectors, lifted formulas, lines of a batch, and
// English said of formulas. The first byte names the reader. Each refuses its input with a FormatError or reads it; the
// grammar then says something, and what English read back denotes is said and read back as itself.
#include <unistd.h>

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>
#include <vector>

#include "libltl/diagnostic.hpp"
#include "libltl/english/read_english.hpp"
#include "libltl/english/verbalise.hpp"
#include "libparser/domain/commands/command.hpp"
#include "libparser/domain/commands/command_domain.hpp"
#include "libparser/domain/commands/landmark.hpp"
#include "libparser/grounding/instruction.hpp"
#include "libparser/language/synchronous_grammar.hpp"
#include "libparser/lexicon/word_vectors.hpp"
#include "libparser/lifted/lifted_symbol.hpp"

namespace {

using namespace waymark;

// A file of these bytes, for readers that take a path.
std::filesystem::path file_of(std::string_view bytes) {
  static const std::filesystem::path file =
      std::filesystem::temp_directory_path() / ("waymark_fuzz_" + std::to_string(::getpid()));
  std::ofstream(file, std::ios::binary | std::ios::trunc)
      .write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  return file;
}

void say(const std::filesystem::path& file) {
  const parser::SynchronousGrammar grammar(file);
  ltl::Random random(1);
  grammar.say("COMMAND", random);
}

void read_vectors(std::string_view said) {
  std::vector<std::uint32_t> aligned(said.size() / 4 + 1);  // as in a mapped file
  std::memcpy(aligned.data(), said.data(), said.size());
  const std::string_view bytes(reinterpret_cast<const char*>(aligned.data()), said.size());
  const parser::WordVectors vectors(bytes);
  for (std::size_t row = 0; row < vectors.size(); ++row)
    if (vectors.word(row).size() > bytes.size()) std::abort();
  vectors.find("lamp");
}

void read_back(const std::string& text) {
  ltl::Arena arena(ltl::Vocabulary({"chair", "lamp", "blue"}));
  const ltl::VerbaliseOptions english{
      ltl::Semantics::Finite, [&](ltl::Proposition p) { return ltl::place("the " + arena.vocabulary().name(p)); }};
  const auto formula = ltl::read_english(text, arena, english);
  if (formula && ltl::read_english(ltl::verbalise(*formula, english), arena, english) != formula) std::abort();
}

void read(std::uint8_t reader, std::string_view text) {
  switch (reader % 9) {
    case 0: parser::read_commands(file_of(text)); break;
    case 1: parser::read_fold(file_of(text)); break;
    case 2: parser::read_landmarks(file_of(text)); break;
    case 3: parser::CommandDomains(file_of(text), ".").of("cleanup"); break;
    case 4: say(file_of(text)); break;
    case 5: read_vectors(text); break;
    case 6: parser::parse_lifted(text); break;
    case 7: parser::parse_instruction(std::string(text), "batch", 1); break;
    default: read_back(std::string(text)); break;
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size < 1 || size > 4'096) return 0;
  try {
    read(data[0], {reinterpret_cast<const char*>(data) + 1, size - 1});
  } catch (const waymark::ltl::FormatError&) {
  }
  return 0;
}

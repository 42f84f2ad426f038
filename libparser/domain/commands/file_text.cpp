#include "libparser/domain/commands/file_text.hpp"

#include <fstream>
#include <iterator>

#include "libltl/diagnostic.hpp"

namespace waymark::parser {

std::string text_of(const std::filesystem::path& file) {
  std::ifstream in(file);
  if (!in) throw ltl::FormatError(file.string(), 0, 0, "cannot be read");
  std::string text{std::istreambuf_iterator<char>(in), {}};
  if (in.bad()) throw ltl::FormatError(file.string(), 0, 0, "cannot be read");
  return text;
}

}  // namespace waymark::parser

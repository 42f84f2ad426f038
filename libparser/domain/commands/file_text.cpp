#include "libparser/domain/commands/file_text.hpp"

#include "libltl/text/read_text.hpp"

namespace waymark::parser {

std::string text_of(const std::filesystem::path& file) { return ltl::read_text(file); }

}  // namespace waymark::parser

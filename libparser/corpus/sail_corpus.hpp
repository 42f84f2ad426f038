// The SAIL corpus in JSON Lines: one paragraph a line, sentences aligned with trajectories. Format: docs/formats/.
#pragma once
#include <filesystem>
#include <string_view>

#include "libparser/corpus/corpus.hpp"

namespace waymark::parser {

// Throws ltl::FormatError with line (and column for malformed JSON). `source` names the file in messages.
std::vector<Paragraph> parse_sail_corpus(std::string_view json_lines, std::string_view source = "");

// directory/instructions.jsonl, and directory/maps/*.json when there are any. Throws ltl::FormatError.
Corpus read_sail_corpus(const std::filesystem::path& directory);

}  // namespace waymark::parser

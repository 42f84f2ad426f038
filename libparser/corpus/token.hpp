// Words of an instruction: lower case; apostrophes split; punctuation marks are words of their own.
//
//   "It's the chair, isn't it?"  →  it s the chair , is n't it ?
// The convention is that of the SAIL corpus as released [CM11], so that its token lists and ours agree.
#pragma once
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace waymark::parser {

std::vector<std::string> tokenize(std::string_view text);  // O(|text|)

// The sentences of an instruction: cut after . ; ! ? (each cut mark stays with its sentence), empty ones dropped.
std::vector<std::string> split_sentences(std::string_view text);

// The clauses of a sentence, [begin, end) in its tokens: cut at "and", "then" and the marks , ; : . — the cuts are in
// none, and each has a word at least; the whole sentence when there is no other word.
struct Clause {
  std::size_t begin, end;  // tokens [begin, end)
};
std::vector<Clause> clauses_of(const std::vector<std::string>& tokens);  // the parts between joints

// The side that a word names: `left`, `lefts`, `left-hand`, `lefthand` and their like of the right.
enum class Side : std::uint8_t { Left, Right };
std::optional<Side> side_of(std::string_view word);

// Left and right exchanged, every other word kept: the mirror image of an instruction.
std::vector<std::string> mirror(std::vector<std::string> tokens);

}  // namespace waymark::parser

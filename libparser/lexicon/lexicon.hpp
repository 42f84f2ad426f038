// What a sentence mentions: the parts of literals  whose names, or other names, occur in it.
//
// The only knowledge of English that is given and not learned: a few dozen words for what the maps can show, e.g.
// "couch" for a sofa, "honeycomb" for the yellow floor, "twice" for a count of two. A mention is a feature whose
// weight starts above zero and is learned from there; other names and misspellings are learned from trajectories.
#pragma once
#include <compare>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace waymark::parser {

// What tokens of programs share: literals a direction and a thing, forward_k the moving and its count, other tokens
// that they are operators.
enum class PartKind : std::uint8_t { Mention, Operator, OperatorName, Forward, Direction, Count, Thing };
struct Part {
  PartKind kind = PartKind::Mention;
  std::string name;        // "chair", "left", "reach"; of a count its digits
  std::size_t number = 0;  // of a count
  friend auto operator<=>(const Part&, const Part&) = default;
};
Part thing(std::string name);    // the part that a name stands for
Part count(std::size_t number);  // the part that a number stands for

// Things and counts, sorted and unique. A number is both: it counts, or names a place.
std::vector<Part> mentions(const std::vector<std::string>& tokens);

// Words for a thing, one or two each; none when it is not in the lexicon.
std::vector<std::string> other_names(const std::string& thing);

// Could any sentence mention this part? A count of one counts as a word that nobody says: "a step" is one step.
bool in_lexicon(const Part& part);

// The number that a word names, 0 when it names none: "two", "twice", "2" → 2.
std::size_t number_named(const std::string& word);

}  // namespace waymark::parser

// What a sentence mentions: the parts of literals (columns of the model) whose names, or other names, occur in it.
//
// The only knowledge of English that is given and not learned: a few dozen words for what the maps can show, e.g.
// "couch" for a sofa, "honeycomb" for the yellow floor, "twice" for a count of two. A mention is a feature whose
// weight starts above zero and is learned from there; other names and misspellings are learned from trajectories.
#pragma once
#include <string>
#include <vector>

namespace waymark::parser {

// Names of columns ("thing chair", "count 2"), sorted and unique.
std::vector<std::string> mentions(const std::vector<std::string>& tokens);

// Could any sentence mention this column? "count 1" counts as a word that nobody says: "a step" is one step.
bool in_lexicon(const std::string& column);

// The number that a word names, 0 when it names none: "two", "twice", "2" → 2.
std::size_t number_named(const std::string& word);

}  // namespace waymark::parser

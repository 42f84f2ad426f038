// Words for the states and events that clauses tell of, beside those that say the same and those that say the opposite:
// "shut" is "closed", and the opposite of "open".
#pragma once
#include <string>
#include <vector>

namespace waymark::parser {

struct RelatedState {     // to another word
  std::string word;       // in base form
  bool opposite = false;  // of what the other says
};

// In the order of the table; forms of a word ("opening") are related to what it is related to. O(words of the table).
std::vector<RelatedState> related_states(const std::string& word);

}  // namespace waymark::parser

// A map in the names that a model was trained on: what a text mentions gets names of the model, of the same kind.
//
// Programs of route instructions are over the furniture, floors and paintings of the maps of the training. On a map
// with other names, "turn left at the desk" is read as "turn left at the chair", on the same hallways with a chair in
// the place of the desk, and the formula is renamed back. Names for which none is left stand nowhere on the renamed
// map.
#pragma once
#include <cstddef>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "libltl/formula.hpp"
#include "libparser/mention/mention.hpp"
#include "libplan/world/map.hpp"
#include "libplan/world/observable.hpp"

namespace waymark::parser {

class RenamedMap {
 public:
  // trained: the hallway vocabulary of the model. tokens: of the text; mentions: of `things`, propositions of the map,
  // in it. O(|S| · |AP|).
  RenamedMap(const ltl::Vocabulary& trained, const plan::Map& map, const std::vector<std::string>& tokens,
             const std::vector<Mention>& mentions, const std::vector<NamedThing>& things);

  const plan::Map& map() const { return map_; }      // over `trained`; places and poses as on the map that was given
  const std::string& text() const { return text_; }  // the text in names of the model
  // The formula over the names of the map that was given; what stands nowhere is false.
  ltl::Formula in_own_names(ltl::Formula f, ltl::Arena& arena) const;

 private:
  using Key = std::pair<plan::Kind, std::string>;
  struct Names {
    std::map<Key, std::string> trained_for, own_for;  // by own name, and back
  };
  static Names assigned(const ltl::Vocabulary& trained, const ltl::Vocabulary& own, const std::vector<Key>& mentioned);
  static plan::Map renamed(const ltl::Vocabulary& trained, const plan::Map& map, const Names& names);

  Names names_;
  std::vector<plan::Observable> observables_;  // of `trained`
  plan::Map map_;
  std::string text_;
};

}  // namespace waymark::parser

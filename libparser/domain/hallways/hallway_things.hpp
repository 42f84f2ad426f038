// What commands name on a hallway map: furniture, floors, pictures, kinds of places, numbered places.
#pragma once
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "libparser/lexicon/synonyms.hpp"
#include "libparser/lifted/lifted_formula.hpp"
#include "libparser/mention/mention.hpp"
#include "libplan/world/map.hpp"
#include "libplan/world/observable.hpp"

namespace waymark::parser {

class HallwayThings {
 public:
  // Furniture and floors are also called by their synonyms.
  explicit HallwayThings(const ltl::Vocabulary& vocabulary, const Synonyms* synonyms = nullptr);

  const std::vector<NamedThing>& things() const { return things_; }  // in a fixed order
  // Slots for what is mentioned; "the hall with the blue floor" is one mention.
  LiftedMentions lift(const std::vector<std::string>& tokens, const WordVectors* words = nullptr) const;
  // The same where some mentions are given: others are found among the other words.
  LiftedMentions lift(const std::vector<std::string>& tokens, std::vector<Mention> given,
                      const WordVectors* words = nullptr) const;
  // `slots`: things of slot 1, 2 … start: where it is said, for "come back here"; none: not known.
  Bindings bindings(ltl::Arena& arena, std::vector<std::size_t> slots, std::optional<std::size_t> start) const;

 private:
  void add(const Synonyms& synonyms);
  std::optional<ltl::Formula> literal(ltl::Arena& arena, LiftedSymbol direction, std::size_t thing) const;

  std::vector<NamedThing> things_;
  std::vector<plan::Kind> kinds_;  // by thing
};

// The number of the place where all the poses are.
std::optional<std::size_t> place_number(const plan::Map& map, std::span<const plan::PoseId> poses);

}  // namespace waymark::parser

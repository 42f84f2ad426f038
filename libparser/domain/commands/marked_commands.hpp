// Commands whose words for things are marked: lifted texts with formulas to learn from, and questions to test with.
//
// A mention becomes a slot where the mark stands; words that state the opposite become "not" and the slot. On hallway
// maps, floors, pictures and kinds of places that nobody marked are found by their names.
#pragma once
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "libparser/domain/commands/command_domain.hpp"
#include "libparser/domain/hallways/hallway_things.hpp"
#include "libparser/lifted/learn_lifted.hpp"

namespace waymark::parser {

inline constexpr const char* hallway_domain = "hallway";  // of commands whose formulas are over a hallway map

// Where commands of the domain "hallway" are said: the names of a map, and `start`, the place where one stands.
class MarkedCommands {
 public:
  // Synonyms of furniture and floors count as names of theirs.
  explicit MarkedCommands(const ltl::Vocabulary& hallways, const Synonyms* synonyms = nullptr);

  struct Marked {                     // a text by its marks
    LiftedText text;                  // its mentions are slots
    std::vector<std::string> slots;   // keys of things in lower case, outside of hallways
    std::vector<std::size_t> things;  // hallways: of slot 1, 2 …
  };
  Marked lift(const Command& command) const;  // a command that has marks
  // The command with its first formula that has a spelling; none where no formula has one over what the text names.
  std::optional<LiftedExample> example(const Command& command) const;

  const HallwayThings& hallways() const { return things_; }          // what hallway texts name
  const ltl::Vocabulary& vocabulary() const { return vocabulary_; }  // of the map, and `start`

 private:
  std::optional<Lifted> label(const Command& command, const Marked& marked, const std::string& formula) const;

  ltl::Vocabulary vocabulary_;
  HallwayThings things_;
};

// All that can be learned from; how many could not.
struct MarkedExamples {
  std::vector<LiftedExample> examples;  // of weight 1
  std::size_t left_out = 0;             // without a formula that can be spelled
};
// O(texts · what hallways may name).
MarkedExamples marked_examples(std::span<const Command> commands, const MarkedCommands& marked);

}  // namespace waymark::parser

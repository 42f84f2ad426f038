// What commands of one domain speak of: its propositions, the phrases that name them, and what no phrase names.
//
//   lifted, properties   propositions stand in the text as they are
//   a small domain       phrases come from the names of the propositions ("first_floor": "first floor", "1st floor",
//                        "floor 1"); what a text does not name is a constant, whose words are learned
//   landmarks            phrases come from names, other names and tags: landmark_mentions.hpp
#pragma once
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "libparser/domain/commands/city_words.hpp"
#include "libparser/domain/commands/command.hpp"
#include "libparser/lifted/lifted_formula.hpp"
#include "libparser/lifted/mention_weights.hpp"
#include "libparser/mention/mention.hpp"

namespace waymark::parser {

class CommandDomain {
 public:
  static constexpr std::size_t most_constants = 16;  // propositions without phrases that a domain may have

  // A text with its propositions in it: `names` are those that may occur; none: any word of one letter, or x1, x2 …
  static CommandDomain with_letters(std::string name, std::vector<std::string> names = {});
  static CommandDomain small(std::string name, const std::vector<std::string>& propositions);
  static CommandDomain city(std::string name, const std::vector<Landmark>& landmarks);
  // What one command may name: propositions are the keys of its things in lower case.
  static CommandDomain of_things(const Command& command);

  struct Lift {                      // a text with slots
    LiftedText text;                 // its mentions are slots
    std::vector<std::string> slots;  // propositions of slot 1, 2 …
    double probability = 1;          // that the words name just these
  };
  // The readings of the mentions, likeliest first; one at least. `model` finds landmarks.
  std::vector<Lift> lift(const std::string& text, const MentionModel& model = {}) const;

  // What texts may name, for what is said of names that are not there.
  std::vector<NamedThing> named_things() const;
  const CityWords* city_words() const { return city_.get(); }  // null where no landmarks are
  std::optional<std::size_t> landmark(const std::string& proposition) const;

  const std::string& name() const { return name_; }  // of the domain
  const std::vector<std::string>& constants() const { return constants_; }
  Bindings bindings(ltl::Arena& arena, std::vector<std::string> slots) const;  // what slots and constants denote
  // The lifted formula of a label, where a text names its propositions or constants do. [spell]
  std::optional<Lifted> label(const Lift& lift, const std::string& formula) const;

 private:
  std::string name_, network_domain_;
  bool letters_ = false;
  std::vector<std::string> propositions_, constants_;  // of things_; sorted
  std::vector<NamedThing> things_;
  std::vector<std::string> landmarks_;  // their propositions
  std::shared_ptr<const CityWords> city_;
};

// All domains of a file domains.json, and cities of a directory of maps, read when they are first asked for.
class CommandDomains {
 public:
  CommandDomains() = default;  // none: of commands that say themselves what they may name
  CommandDomains(const std::filesystem::path& domains, std::filesystem::path maps);
  // "lifted", "cleanup", "osm:boston" … Throws ltl::FormatError when there is none of the name.
  const CommandDomain& of(const std::string& name);
  CommandDomain of(const Command& command);  // its own things, or the domain that it names

 private:
  std::string file_;  // of the domains
  std::map<std::string, CommandDomain> domains_;
  std::filesystem::path maps_;
};

}  // namespace waymark::parser

// A grammar that says texts and their lifted formulas at once, for commands of our own.
//
//   # a comment
//   $go = go to | head for | walk over to           words: one of the alternatives
//   @GOAL                                           a category; its rules follow
//   (please|) $go <N> => eventually 1               a rule: what is said => what it denotes; 1 is the formula of the
//   $go <N> and then to <N> => sequence 1 2 end     first <…>, 2 of the second …
//   3: … => …                                       drawn three times as often
// <N> is a place, each one another; <#1> in a rule says once more what the first <…> denotes. (x|y|) draws an
// alternative. After [AU69]: a synchronous context-free grammar. Slots are numbered by first mention when a text is
// complete. The format in full: docs/formats/lifted.md.
#pragma once
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "libltl/structure/random.hpp"
#include "libparser/lifted/lifted_symbol.hpp"

namespace waymark::parser {

class SynchronousGrammar {
 public:
  // Throws ltl::FormatError naming the line of what is no rule, or names categories, words, parts or symbols that are
  // not there.
  explicit SynchronousGrammar(const std::filesystem::path& file);

  struct Said {                       // a text with its formula
    std::vector<std::string> tokens;  // slots as "#1", "#2" …, by first mention
    Lifted lifted;                    // over the slots
    std::size_t slots = 0;            // how many
  };
  // A text of a category. Texts of more than `most_tokens` tokens are drawn anew. Throws ltl::FormatError when there is
  // no such category, when it has no short texts, or when what was drawn has no complete formula.
  Said say(const std::string& category, ltl::Random& random, std::size_t most_tokens = 48) const;

 private:
  struct Rule {
    std::string text, lifted;
    double weight = 1;
    std::size_t line = 0;
  };
  struct Drawing {
    std::size_t places = 0, parts = 0;  // made so far
  };
  struct Draft {
    std::string text, lifted;  // slots by number of making
  };
  std::optional<Said> said_of(const Draft& draft, std::size_t most_tokens) const;  // none: too long
  Draft draw(const std::string& category, std::size_t depth, Drawing& drawing, ltl::Random& random) const;
  std::string expand(std::string text, ltl::Random& random) const;
  void check_text(const std::string& text, const std::string& source, std::size_t line) const;
  void check_rules(const std::string& source) const;
  std::vector<std::string> check_rule(const Rule& rule, const std::string& source) const;

  std::string source_;  // the file
  std::map<std::string, std::vector<std::string>> words_;
  std::map<std::string, std::vector<Rule>> rules_;
  std::map<std::string, std::size_t> lines_;  // of categories
};

}  // namespace waymark::parser

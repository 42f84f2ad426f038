// The operations and questions of `waymark automaton` about one automaton.
//
// A question is answered "yes", or "no" with a word that shows why. Two automata must both be about finite words or
// both about infinite ones.
#pragma once
#include <cstddef>
#include <map>
#include <stop_token>
#include <string>
#include <variant>
#include <vector>

#include "libautomata/budget.hpp"
#include "libautomata/finite/dfa.hpp"
#include "libautomata/hoa/finite.hpp"
#include "libautomata/omega/automaton.hpp"
#include "tools/automaton_output.hpp"
#include "tools/shell/subcommand.hpp"

namespace waymark::tools {

using AnyAutomaton = std::variant<automata::Dfa, automata::Automaton>;

// The automata of the files that a request names besides its own: a single one meets every automaton of the stream, of
// several each meets the one of its number.
class OtherAutomata {
 public:
  // Throws ltl::FormatError for a file that holds none, UsageError for two files of several, not equally many.
  explicit OtherAutomata(const std::vector<std::string>& files);
  const automata::HoaAutomaton& of(const std::string& file, std::size_t number) const;  // number: from 1 on
  bool is_stream(const std::string& file) const { return files_.at(file).automata.size() > 1; }
  std::size_t count() const { return count_; }  // in the longest file, at least 1

 private:
  struct File {
    std::string text;  // which the automata look into
    std::vector<automata::HoaAutomaton> automata;
  };
  std::map<std::string, File> files_;  // whose nodes stay where they are
  std::size_t count_ = 1;
};

struct AutomatonRequest {
  std::string source;                           // of the first automaton
  std::size_t number = 1;                       // of this one in its stream
  bool is_stream = false, json = false;         // is the first file known to hold several? are answers JSON?
  const OtherAutomata* others = nullptr;        // of the files below
  std::string product, either, difference;      // files: the other automaton
  std::string equivalent, included, satisfies;  // files, and a formula
  std::string kind;                             // of automaton to make: dfa, tgba, buchi, parity, rabin, ldba, generic
  bool complement = false, empty = false, universal = false, minimize = false, reduce = false;
  std::size_t states = 1'000'000;

  bool changes_language() const { return complement || !product.empty() || !either.empty() || !difference.empty(); }
  std::vector<std::string> files() const;  // that are named
  bool asks() const { return empty || universal || !equivalent.empty() || !included.empty(); }
};

// A DFA when the file says finite-words.
AnyAutomaton understood(automata::HoaAutomaton file, const std::string& source, automata::Budget& budget);
// All operations asked for, in a fixed order: complement, product, union, difference, reduction, change of kind.
AnyAutomaton transformed(AnyAutomaton any, const AutomatonRequest& request, automata::Budget& budget, Shown& about);
// Do all words that are accepted satisfy request.satisfies?
Reply satisfies(const AnyAutomaton& any, const AutomatonRequest& request, automata::Budget& budget,
                std::stop_token stop);
// The one question of asks() that was asked.
Reply asked_of(const AnyAutomaton& any, const AutomatonRequest& request, automata::Budget& budget);

}  // namespace waymark::tools

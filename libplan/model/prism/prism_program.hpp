// A model in the language of PRISM [KNP11], read and bound: variables, modules of guarded commands, rewards, labels.
#pragma once
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "libplan/model/prism/prism_expression.hpp"

namespace waymark::plan {

using PrismConstants = std::map<std::string, std::string, std::less<>>;  // values as they are written: 3, 0.5, true

struct PrismProgram {                               // refers to expressions of one pool
  using Id = PrismExpressions::Id;                  // of an expression
  using Type = PrismExpressions::Type;              // of a value
  static constexpr std::size_t global = 1U << 31U;  // the module of a variable that all may assign

  struct Variable {                          // of a module
    std::string name;                        // after renaming
    ltl::Span where;                         // of its declaration
    Type type = Type::Int;                   // Bool: from 0 to 1
    std::optional<Id> least, most, initial;  // as written
    double from = 0, to = 1, first = 0;      // as bound
    std::size_t module = global;             // that assigns it
    bool fixed = false;                      // `start` does not choose its value
  };
  struct Assignment {          // x' = value
    std::string name;          // of the variable
    ltl::Span where;           // of the name
    std::size_t variable = 0;  // bound
    Id value = 0;              // over the values before
    std::uint32_t round = 0;   // rounds follow one another; those of one round are made at once
  };
  struct Update {                         // p : (x'=e) & …
    std::optional<Id> probability;        // none: 1
    std::vector<Assignment> assignments;  // of different variables
  };
  struct Command {                // [action] guard -> updates
    std::string action;           // empty: of this module alone
    Id guard = 0;                 // a condition
    std::vector<Update> updates;  // their probabilities add up to 1
    ltl::Span where;              // of the command
    std::uint32_t location = 0;   // where the module has a variable for it: the value that the command needs
  };
  struct Module {                                // between module and endmodule
    std::string name;                            // of the module
    std::vector<Command> commands;               // in the order of the text
    std::optional<std::uint32_t> location = {};  // a variable from 0 that some commands need to have a value
    bool has(std::string_view action) const;     // in its alphabet
  };
  struct Reward {                       // an item of a structure
    std::optional<std::string> action;  // none: of states
    Id guard = 0, value = 0;            // expressions
  };
  struct Rewards {              // a structure
    std::string name;           // empty: none
    std::vector<Reward> items;  // that add up
    std::optional<Id> step;     // of every outcome besides: over the values after it, transient ones among them
  };
  struct Synchronisation {                                  // an action of several modules
    std::string result;                                     // its name
    std::vector<std::pair<std::size_t, std::string>> each;  // a module, and its action
  };
  struct Label {       // label "name" = condition
    std::string name;  // without quotes
    Id holds = 0;      // a condition
  };

  bool is_mdp = true;               // else a Markov chain in discrete time
  std::vector<Variable> variables;  // global ones and those of modules, in the order of the text
  std::vector<Module> modules;      // all synchronise on the actions that they share
  std::vector<Rewards> rewards;     // structures, in the order of the text
  std::vector<Label> labels;        // in the order of the text
  std::optional<Id> start;          // init … endinit
  std::vector<double> transient;    // variables of a step behind the others: the values with which each step begins
  std::optional<std::vector<Synchronisation>> synchronisations;  // none: modules meet in the actions that they share
  std::vector<std::string> given;                                // constants that took their value from outside
};

// Reads the text of `in` to its end. Formulas, constants, labels and variables are defined in `expressions`; constants
// without a value take it from `constants`. Types are checked. Throws ltl::SyntaxError with the place, also for what
// PRISM has and this reader has not.
PrismProgram read_prism_program(PrismTokens& in, PrismExpressions& expressions, const PrismConstants& constants);

// const [int|double|bool] name [= expression]; in a model or in properties, with the word const read.
// A name joins `given` when its value is from `constants`; one that has a value in the text takes no other.
void read_prism_constant(PrismTokens& in, PrismExpressions& expressions, const PrismConstants& constants,
                         std::vector<std::string>& given);

// The literal of such a value; nullopt: it is of another type. Without a type the text tells.
std::optional<PrismProgram::Id> prism_literal(PrismExpressions& expressions, const std::string& text,
                                              std::optional<PrismProgram::Type> type);

// Throws ltl::SyntaxError at the end of the text for a constant that no declaration took.
void expect_given(const PrismTokens& in, const PrismConstants& constants, const std::vector<std::string>& given);

}  // namespace waymark::plan

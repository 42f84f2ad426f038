// The declarations of a JANI document [BDH+17]: constants, variables with their ranges, functions.
#pragma once
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "libplan/model/jani/jani_expression.hpp"
#include "libplan/model/jani/jani_text.hpp"
#include "libplan/model/prism/prism_program.hpp"

namespace waymark::plan {

// What an unbounded int ranges over, on either side of 0.
inline constexpr double most_jani_int = 1e9;

class JaniDeclarations {  // adds to a program, and to names
 public:
  using Type = PrismExpressions::Type;  // of a value
  JaniDeclarations(const JaniText& text, PrismExpressions& expressions, JaniExpressions& names, PrismProgram& program)
      : text_(text), expressions_(expressions), names_(names), program_(program) {}

  struct Transient {    // a variable of a step
    std::string name;   // as the text has it
    JaniName* meaning;  // its index is not known before all variables are
    double initial;     // with which a step begins
  };

  // All throw ltl::FormatError.
  void constants(JaniText::Id document, const PrismConstants& given);                      // their values
  void variables(JaniText::Id owner, JaniNames& into, std::vector<Transient>& transient);  // of a document or automaton
  void functions(JaniText::Id owner, JaniNames& into);  // bodies are read where they are called

 private:
  struct Range {
    Type type = Type::Int;
    bool finite = true;  // not a real
    double from = 0, to = 1;
  };
  Range range(JaniText::Id type);
  JaniName& add(JaniText::Id named, JaniNames& into);
  void variable(JaniText::Id variable, JaniNames& into, std::vector<Transient>& transient);

  const JaniText& text_;
  PrismExpressions& expressions_;
  JaniExpressions& names_;
  PrismProgram& program_;
};

}  // namespace waymark::plan

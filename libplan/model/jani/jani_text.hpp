// A JANI document [BDH+17] as a table of its values: what is read from it, and what errors are about.
//
// A value is its number. The places of values are computed from the text when one is wrong. The JSON library stays in
// the source.
#pragma once
#include <cstdint>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "libplan/model/prism/prism_tokens.hpp"

namespace waymark::plan {

class JaniText final : public ModelText {
 public:
  using Id = std::uint32_t;                                                   // of a value; 0 is the document
  enum class Kind : std::uint8_t { Null, Bool, Number, Text, List, Object };  // of a value

  // Throws ltl::FormatError for what is no JSON; `text` and `source` must outlive this.
  JaniText(std::string_view text, std::string_view source);

  Kind kind(Id value) const { return values_[value].kind; }       // its kind
  bool is_whole(Id value) const { return values_[value].whole; }  // a number written without fraction and exponent
  // All throw ltl::FormatError with the place.
  const std::string& text(Id value) const;
  double number(Id value) const;
  bool truth(Id value) const;
  std::vector<Id> elements(Id value) const;                       // of a list
  std::optional<Id> find(Id object, std::string_view key) const;  // a member
  Id member(Id object, std::string_view key) const;               // one that must be there
  std::vector<Id> list(Id object, std::string_view key) const;    // elements of a member; none where it is absent
  // Other members than these are refused; comments and extensions (x-…) are not.
  void expect_keys(Id object, std::initializer_list<std::string_view> keys) const;

  static ltl::Span where(Id value) { return {value, value}; }  // of expressions that were read from it
  std::string infix(Id expression) const;                      // as people write it: x = 3 ∧ ¬b
  using ModelText::fail;
  // Throws FormatError.
  [[noreturn]] void fail(Id value, const std::string& message) const { fail(where(value), message); }
  ltl::Span end() const override { return where(0); }  // the document

 private:
  struct Value {
    Kind kind = Kind::Null;
    bool whole = false;
    double number = 0;                  // of a truth value: 1 or 0
    std::string text;                   // of a text
    std::uint32_t parent = 0;           // of the document: itself
    std::uint32_t index = 0;            // among the members or elements of its parent
    std::string key;                    // of a member
    std::uint32_t first = 0, size = 0;  // members or elements, adjacent
  };
  std::exception_ptr error(ltl::Span where, const std::string& message) const override;
  std::string path(Id value) const;
  std::string infix(Id expression, std::size_t depth) const;

  std::string_view json_, source_;
  std::vector<Value> values_;
};

}  // namespace waymark::plan

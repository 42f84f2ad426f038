// What PRISM and Storm answer about a model, and waymark does not: called by its name where it stands in a property.
#pragma once
#include <set>
#include <stdexcept>
#include <string>

#include "libplan/model/prism/prism_tokens.hpp"

namespace waymark::plan {

using PropertyNames = std::set<std::string, std::less<>>;  // of other properties

// "name": … before properties; labels of the same names are to be taken out.
inline PropertyNames property_names(const PrismTokens& in) {
  PropertyNames out;
  for (std::size_t i = 0; in.peek(i).kind != PrismToken::Kind::End; ++i)
    if (in.peek(i).kind == PrismToken::Kind::String && in.is(":", i + 1)) out.emplace(in.peek(i).text);
  return out;
}

// At the beginning of an operand of a property. Throws std::invalid_argument.
inline void refuse_unanswered(const PrismTokens& in, const PropertyNames& names) {
  if ((in.is("A") || in.is("E")) && in.is("[", 1)) throw std::invalid_argument("CTL: A [ … ] and E [ … ]");
  if (in.is("<") && in.is("<", 1)) throw std::invalid_argument("a coalition of players, <<…>>");
  const PrismToken& token = in.peek();
  if (token.kind == PrismToken::Kind::String && names.contains(token.text))
    throw std::invalid_argument("the value of another property, \"" + std::string(token.text) +
                                "\", inside of this one");
}

}  // namespace waymark::plan

#include "libplan/model/prism/prism_names.hpp"

#include "libltl/text/character.hpp"

#include <algorithm>
#include <array>

namespace waymark::plan {
using ltl::is_digit, ltl::is_letter;
namespace {

constexpr std::array<std::string_view, 58> reserved{"A",
                                                    "C",
                                                    "E",
                                                    "F",
                                                    "G",
                                                    "I",
                                                    "P",
                                                    "Pmax",
                                                    "Pmin",
                                                    "R",
                                                    "Rmax",
                                                    "Rmin",
                                                    "S",
                                                    "U",
                                                    "W",
                                                    "X",
                                                    "bool",
                                                    "clock",
                                                    "const",
                                                    "ctmc",
                                                    "double",
                                                    "dtmc",
                                                    "endinit",
                                                    "endinvariant",
                                                    "endmodule",
                                                    "endobservables",
                                                    "endrewards",
                                                    "endsystem",
                                                    "false",
                                                    "filter",
                                                    "formula",
                                                    "func",
                                                    "global",
                                                    "init",
                                                    "int",
                                                    "invariant",
                                                    "label",
                                                    "max",
                                                    "mdp",
                                                    "min",
                                                    "module",
                                                    "nondeterministic",
                                                    "observable",
                                                    "observables",
                                                    "of",
                                                    "pomdp",
                                                    "popta",
                                                    "prob",
                                                    "probabilistic",
                                                    "pta",
                                                    "rate",
                                                    "rewards",
                                                    "stochastic",
                                                    "system",
                                                    "true",
                                                    "idtmc",
                                                    "imdp",
                                                    "ctmdp"};

}  // namespace

bool is_prism_reserved(std::string_view word) {
  return std::find(reserved.begin(), reserved.end(), word) != reserved.end();
}

std::string PrismNames::add(std::string_view text) {
  std::string name(text);
  for (char& c : name)
    if (!is_letter(c) && !is_digit(c)) c = '_';
  if (name.empty() || is_digit(name[0])) name.insert(name.begin(), '_');
  if (is_prism_reserved(name)) name += '_';
  std::string different = name;
  for (std::size_t i = 2; !taken_.insert(different).second; ++i) different = name + '_' + std::to_string(i);
  return different;
}

}  // namespace waymark::plan

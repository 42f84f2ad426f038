#include "tools/translations.hpp"

#include <array>
#include <string>

#include "tools/shell/exit_code.hpp"

namespace waymark::tools {
namespace {

template <class Result>
Translated widened(Result result) {
  return std::visit([](auto&& alternative) { return Translated(std::move(alternative)); }, std::move(result));
}

Translated finite_dfa(ltl::Formula f, const ltl::Limits& limits) { return widened(automata::ltlf_to_dfa(f, limits)); }

Translated tgba(ltl::Formula f, const ltl::Limits& limits) { return widened(automata::ltl_to_tgba(f, limits)); }

Translated buchi(ltl::Formula f, const ltl::Limits& limits) { return widened(automata::ltl_to_buchi(f, limits)); }

Translated parity(ltl::Formula f, const ltl::Limits& limits) { return widened(automata::ltl_to_parity(f, limits)); }

Translated rabin(ltl::Formula f, const ltl::Limits& limits) { return widened(automata::ltl_to_rabin(f, limits)); }

Translated generic(ltl::Formula f, const ltl::Limits& limits) { return widened(automata::ltl_to_generic(f, limits)); }

Translated ldba(ltl::Formula f, const ltl::Limits& limits) { return widened(automata::ltl_to_ldba(f, limits)); }

constexpr std::array all_translations{
    Translation{"finite", "dfa", finite_dfa}, Translation{"infinite", "tgba", tgba},
    Translation{"infinite", "buchi", buchi},  Translation{"infinite", "parity", parity},
    Translation{"infinite", "rabin", rabin},  Translation{"infinite", "generic", generic},
    Translation{"infinite", "ldba", ldba},
};

}  // namespace

std::span<const Translation> translations() { return all_translations; }

const Translation& find_translation(std::string_view semantics, std::string_view target) {
  if (semantics.empty()) semantics = target == "dfa" ? "finite" : "infinite";
  if (target.empty()) target = semantics == "finite" ? "dfa" : "tgba";
  std::string there;
  for (const Translation& row : all_translations) {
    if (row.semantics == semantics && row.target == target) return row;
    if (row.semantics == semantics) there += (there.empty() ? "" : ", ") + std::string(row.target);
  }
  throw UsageError(
      "--semantics " + std::string(semantics) + " --to " + std::string(target) +
      " is not available yet: " + (there.empty() ? "only finite words are" : "over these words there is " + there));
}

}  // namespace waymark::tools

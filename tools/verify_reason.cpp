#include "tools/verify_reason.hpp"

#include <algorithm>

#include "libltl/text/print.hpp"
#include "tools/progression_product.hpp"

namespace waymark::tools {
namespace {

using Formulas = std::vector<ltl::Formula>;

constexpr std::string_view contradiction = "no finite word satisfies the formula: it contradicts itself";
constexpr std::size_t most_sets = 512;

Formulas conjuncts(ltl::Formula f) {
  if (f.op() != ltl::Op::And) return {f};
  return {f.operands().begin(), f.operands().end()};
}

bool take(std::string_view& text, std::string_view head) {
  if (!text.starts_with(head)) return false;
  text.remove_prefix(head.size());
  return true;
}

// "F a, F b and G !a": which of the formulas?
bool named(std::string_view list, const Formulas& all, Formulas& out) {
  for (const ltl::Formula f : all) {
    std::string_view rest = list;
    if (std::find(out.begin(), out.end(), f) != out.end() || !take(rest, ltl::print(f))) continue;
    out.push_back(f);
    if (rest.empty() || ((take(rest, ", ") || take(rest, " and ")) && named(rest, all, out))) return true;
    out.pop_back();
  }
  return false;
}

std::optional<bool> is_not(std::optional<bool> b) { return b ? std::optional(!*b) : std::nullopt; }

// "; never seen from there: bench, lamp" at the end of the sentence.
void unseen(Claims& claims, std::string_view& sentence, ltl::Formula f, const ReasonReferee& referee) {
  for (const std::string_view head : {"; never seen from there: ", "; never seen from the start: "}) {
    const std::size_t at = sentence.find(head);
    if (at == std::string_view::npos) continue;
    std::string_view names = sentence.substr(at + head.size());
    sentence = sentence.substr(0, at);
    const std::vector<std::string> all = referee.never_seen(f);
    const std::string what = "never seen: " + std::string(names);
    bool holds = true;
    while (holds && !names.empty()) {
      holds = std::any_of(all.begin(), all.end(), [&](const std::string& name) {
        std::string_view rest = names;
        if (!take(rest, name) || !(rest.empty() || take(rest, ", "))) return false;
        names = rest;
        return true;
      });
    }
    return claims.add(holds, what);
  }
}

std::string list_of(const Formulas& formulas) {
  std::string out;
  for (const ltl::Formula f : formulas) out += (out.empty() ? "" : ", ") + ltl::print(f);
  return out;
}

}  // namespace

void examine_reason(Claims& claims, const std::string& reason, ltl::Formula formula, const ReasonReferee& referee) {
  std::string_view rest = reason;
  if (rest == contradiction)
    return claims.add(is_not(has_finite_word(formula, referee.limits)), std::string(contradiction));
  const bool known =
      std::any_of(referee.heads.begin(), referee.heads.end(), [&](const auto& h) { return take(rest, h); });
  if (!known) return claims.add(std::nullopt, "reason");
  unseen(claims, rest, formula, referee);
  constexpr std::string_view end = " together";
  const bool together = rest.ends_with(end);
  if (together) rest.remove_suffix(end.size());
  Formulas blamed;
  if (rest == "the formula")
    blamed = {formula};
  else if (!named(rest, conjuncts(formula), blamed))
    return claims.add(false, "reason names conjuncts of the formula");
  if (together) {
    claims.add(is_not(referee.is_possible(ltl::conjunction(formula.arena(), blamed))),
               "nothing satisfies " + list_of(blamed) + " together");
    return;
  }
  for (const ltl::Formula f : blamed) claims.add(is_not(referee.is_possible(f)), "nothing satisfies " + ltl::print(f));
}

void examine_dropped(Claims& claims, const std::vector<std::string>& dropped, ltl::Formula formula,
                     const ReasonReferee& referee) {
  const Formulas all = conjuncts(formula);
  Formulas rest;
  for (const ltl::Formula f : all)
    if (std::find(dropped.begin(), dropped.end(), ltl::print(f)) == dropped.end()) rest.push_back(f);
  if (dropped.empty() || rest.empty() || rest.size() + dropped.size() != all.size())
    return claims.add(false, "dropped are conjuncts of the formula");
  claims.add(referee.is_possible(ltl::conjunction(formula.arena(), rest)), list_of(rest) + " can be met");
  std::vector<bool> chosen(all.size(), false);  // of one conjunct less: dropping more is no harder
  std::fill(chosen.begin(), chosen.begin() + static_cast<std::ptrdiff_t>(dropped.size() - 1), true);
  std::optional<bool> fewest = true;
  std::size_t asked = 0;
  do {
    Formulas kept;
    for (std::size_t i = 0; i < all.size(); ++i)
      if (!chosen[i]) kept.push_back(all[i]);
    const auto possible =
        ++asked > most_sets ? std::nullopt : referee.is_possible(ltl::conjunction(formula.arena(), kept));
    fewest = possible ? std::optional(!*possible) : std::nullopt;
  } while (fewest == true && std::prev_permutation(chosen.begin(), chosen.end()));
  claims.add(fewest, "the rest cannot be met when fewer are dropped");
}

}  // namespace waymark::tools

// The 55 property patterns. [DAC98], with the corrections of its web page: what Spot's genltl --dac-patterns prints.
#include <array>
#include <stdexcept>

#include "libltl/patterns/patterns.hpp"
#include "libltl/structure/substitute.hpp"
#include "libltl/text/parse.hpp"

namespace waymark::ltl {
namespace {

struct PropertyRow {
  const char* name;
  const char* parameters;
  const char* sentence;
  std::array<const char*, 5> formulas;  // by Scope
};

constexpr std::array<const char*, 5> scope_names{"globally", "before", "after", "between", "after-until"};
constexpr std::array<const char*, 5> scope_parameters{"", " r", " q", " q r", " q r"};
constexpr std::array<const char*, 5> scope_phrases{"Globally, ", "Before r, ", "After q, ", "Between q and r, ",
                                                   "After q until r, "};

constexpr std::array<PropertyRow, 11> property_rows{{
    {"absence",
     "p",
     "p never holds.",
     {"G !p", "F r -> (!p U r)", "G (q -> G !p)", "G ((q & !r & F r) -> (!p U r))", "G ((q & !r) -> (!p W r))"}},
    {"existence",
     "p",
     "p holds at some time.",
     {"F p", "!r W (p & !r)", "G !q | F (q & F p)", "G ((q & !r) -> (!r W (p & !r)))",
      "G ((q & !r) -> (!r U (p & !r)))"}},
    {"bounded-existence",
     "p",
     "p holds for at most two stretches of time.",
     {"!p W (p W (!p W (p W G !p)))",
      "F r -> ((!p & !r) U (r | ((p & !r) U (r | ((!p & !r) U (r | ((p & !r) U (r | (!p U r)))))))))",
      "F q -> (!q U (q & (!p W (p W (!p W (p W G !p))))))",
      "G ((q & F r) -> ((!p & !r) U (r | ((p & !r) U (r | ((!p & !r) U (r | ((p & !r) U (r | (!p U "
      "r))))))))))",
      "G (q -> ((!p & !r) U (r | ((p & !r) U (r | ((!p & !r) U (r | ((p & !r) U (r | (!p W r) | G "
      "p)))))))))"}},
    {"universality",
     "p",
     "p always holds.",
     {"G p", "F r -> (p U r)", "G (q -> G p)", "G ((q & !r & F r) -> (p U r))", "G ((q & !r) -> (p W r))"}},
    {"precedence",
     "p s",
     "s precedes p.",
     {"!p W s", "F r -> (!p U (s | r))", "G !q | F (q & (!p W s))", "G ((q & !r & F r) -> (!p U (s | r)))",
      "G ((q & !r) -> (!p W (s | r)))"}},
    {"response",
     "p s",
     "s responds to p.",
     {"G (p -> F s)", "F r -> ((p -> (!r U (s & !r))) U r)", "G (q -> G (p -> F s))",
      "G ((q & !r & F r) -> ((p -> (!r U (s & !r))) U r))", "G ((q & !r) -> ((p -> (!r U (s & !r))) W r))"}},
    {"precedence-chain-2-1",
     "p s t",
     "s and then t precede p.",
     {"F p -> (!p U (s & !p & X (!p U t)))", "F r -> (!p U (r | (s & !p & X (!p U t))))",
      "G !q | (!q U ((q & F p) -> (!p U (s & !p & X (!p U t)))))",
      "G ((q & F r) -> (!p U (r | (s & !p & X (!p U t)))))", "G (q -> (F p -> (!p U (r | (s & !p & X (!p U t))))))"}},
    {"precedence-chain-1-2",
     "p s t",
     "p precedes s and then t.",
     {"F (s & X F t) -> (!s U p)", "F r -> (!(s & !r & X (!r U (t & !r))) U (r | p))",
      "G !q | (!q U (q & (F (s & X F t) -> (!s U p))))", "G ((q & F r) -> (!(s & !r & X (!r U (t & !r))) U (r | p)))",
      "G (q -> ((!(s & !r & X (!r U (t & !r))) U (r | p)) | G !(s & X F t)))"}},
    {"response-chain-2-1",
     "p s t",
     "p responds to s and then t.",
     {"G ((s & X F t) -> X F (t & F p))", "F r -> (((s & X (!r U t)) -> X (!r U (t & F p))) U r)",
      "G (q -> G ((s & X F t) -> X (!t U (t & F p))))",
      "G ((q & F r) -> (((s & X (!r U t)) -> X (!r U (t & F p))) U r))",
      "G (q -> (((s & X (!r U t)) -> X (!r U (t & F p))) U (r | G ((s & X (!r U t)) -> X (!r U (t & F "
      "p))))))"}},
    {"response-chain-1-2",
     "p s t",
     "s and then t respond to p.",
     {"G (p -> F (s & X F t))", "F r -> ((p -> (!r U (s & !r & X (!r U t)))) U r)", "G (q -> G (p -> (s & X F t)))",
      "G ((q & F r) -> ((p -> (!r U (s & !r & X (!r U t)))) U r))",
      "G (q -> ((p -> (!r U (s & !r & X (!r U t)))) U (r | G (p -> (s & X F t)))))"}},
    {"constrained-response-chain",
     "p s t z",
     "s and then t, without z between them, respond to p.",
     {"G (p -> F (s & !z & X (!z U t)))", "F r -> ((p -> (!r U (s & !r & !z & X ((!r & !z) U t)))) U r)",
      "G (q -> G (p -> (s & !z & X (!z U t))))",
      "G ((q & F r) -> ((p -> (!r U (s & !r & !z & X ((!r & !z) U t)))) U r))",
      "G (q -> ((p -> (!r U (s & !r & !z & X ((!r & !z) U t)))) U (r | G (p -> (s & !z & X (!z U "
      "t))))))"}},
}};

std::string parameters(const PropertyRow& row, std::size_t scope) {
  return std::string(row.parameters) + scope_parameters[scope];
}

}  // namespace

Formula property(Body body, Scope scope, std::span<const Formula> arguments) {
  const PropertyRow& row = property_rows[static_cast<std::size_t>(body)];
  const auto column = static_cast<std::size_t>(scope);
  Arena letters;  // single letters with blanks between: parameter i is character 2 i
  const std::string names = parameters(row, column);
  const std::size_t count = (names.size() + 1) / 2;
  if (arguments.size() != count)
    throw std::invalid_argument(std::string(row.name) + '-' + scope_names[column] + " takes " + std::to_string(count) +
                                " arguments (" + names + "), not " + std::to_string(arguments.size()));
  for (std::size_t i = 0; i < count; ++i) letters.add_proposition(names.substr(2 * i, 1));
  const Formula text = parse(row.formulas[column], letters, {.unknown = Unknown::Reject});
  return substitute(text, arguments.front().arena(), [&](Proposition p) { return arguments[p.index]; });
}

std::vector<Pattern> property_patterns() {
  std::vector<Pattern> out;
  for (const PropertyRow& row : property_rows)
    for (std::size_t scope = 0; scope < scope_names.size(); ++scope)
      out.push_back({.name = std::string(row.name) + '-' + scope_names[scope],
                     .parameters = parameters(row, scope),
                     .sentence = std::string(scope_phrases[scope]) + row.sentence,
                     .source = "DAC98",
                     .formula = row.formulas[scope]});
  return out;
}

}  // namespace waymark::ltl

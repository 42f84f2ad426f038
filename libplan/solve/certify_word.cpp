#include "libplan/solve/certify_word.hpp"

#include <algorithm>
#include <stdexcept>
#include <vector>

#include "libltl/meaning/semantics.hpp"
#include "libltl/meaning/trace_check.hpp"
#include "libltl/structure/fragment.hpp"
#include "libltl/text/print.hpp"
#include "libplan/product/alphabet_classes.hpp"
#include "libplan/solve/task_automaton.hpp"

namespace waymark::plan {
namespace {

// A column for every proposition that occurs.
std::size_t width(const ltl::Trace& word, ltl::Formula f) {
  std::size_t out = 0;
  for (const ltl::Proposition p : ltl::propositions(f)) out = std::max<std::size_t>(out, p.index + 1);
  for (const ltl::Letter& letter : word)
    for (const ltl::Proposition p : letter.members()) out = std::max<std::size_t>(out, p.index + 1);
  return out;
}

}  // namespace

void certify_word(const ltl::Trace& word, ltl::Formula f, CaseTask::Logic logic) {
  const std::vector<ltl::Letter> letters(word.begin(), word.end());
  const bool finite = is_finite_task(f, logic) &&
                      (logic != CaseTask::Logic::Ltl || ltl::fragments(f, ltl::Semantics::Infinite).next_free);
  const auto holds_of_word = [&] {
    if (ltl::has_past(f)) return ltl::holds(word, f);
    return ltl::TraceCheck(f)(ltl::Columns(word, width(word, f)));
  };
  const bool holds = finite ? holds_of_word() : ltl::holds(ltl::Lasso(letters, {letters.back()}), f);
  if (!holds) throw std::logic_error("a route whose word does not satisfy " + ltl::print(f));
}

void certify_word(const ltl::Trace& word, const ltl::Vocabulary& vocabulary, const automata::Dfa& dfa) {
  const ltl::Trace read(as_read({word.begin(), word.end()}, vocabulary, dfa.vocabulary(), dfa.reads()));
  if (!automata::accepts(dfa, read)) throw std::logic_error("a route that the automaton does not accept");
}

}  // namespace waymark::plan

#include "tools/judged_word.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>
#include <utility>
#include <variant>

#include "libautomata/monitor/conjunction.hpp"
#include "libltl/meaning/progress.hpp"
#include "libltl/meaning/trace_check.hpp"
#include "libltl/rewriting/remainder.hpp"
#include "libltl/text/print.hpp"
#include "tools/shell/exit_code.hpp"

namespace waymark::tools {
namespace {

constexpr std::size_t most_tree = 20'000, most_states = 20'000;

std::vector<ltl::Letter> letters_of(const ltl::AnyWord& word) {
  std::vector<ltl::Letter> letters;
  std::visit(
      [&](const auto& some) {
        for (std::size_t i = 0; i < some.size(); ++i) letters.push_back(some[i]);
      },
      word);
  return letters;
}

std::vector<JudgedLetter> progressed(ltl::Formula f, const std::vector<ltl::Letter>& letters, ltl::Semantics semantics,
                                     const std::stop_token& stop) {
  ltl::Remainder remainder(f, semantics);
  std::vector<JudgedLetter> out;
  for (const ltl::Letter& letter : letters) {
    if (stop.stop_requested()) throw Interrupted();
    const ltl::Formula rest = remainder.read(letter);
    if (ltl::tree_size(rest) > most_tree) throw GaveUp("what remains of the formula is too large");
    out.push_back({rest, std::nullopt});
  }
  return out;
}

// By definition, which takes time in the square of the word; a long word by the law of expansion, 64 letters at once.
bool satisfies(const ltl::Trace& word, ltl::Formula f) {
  constexpr std::size_t long_word = 4'096;
  if (word.size() < long_word || ltl::has_past(f)) return ltl::holds(word, f);
  return ltl::TraceCheck(f)(ltl::Columns(word, f.arena().vocabulary().size()));
}

// What monitors of the conjuncts say letter by letter. Of a lasso: of u and of one round of v; a loss in a later round
// is one of the whole word, not of a letter.
struct Verdicts {
  std::vector<LetterVerdict> letters;
  bool are_known = true;  // false: of some letter, whether a continuation satisfies the formula is not known
};

LetterVerdict letter_verdict(const automata::MonitorVerdict& said) {
  if (said.now.value_or(said.foresight == automata::Foresight::True)) return LetterVerdict::Satisfied;
  return said.foresight == automata::Foresight::False ? LetterVerdict::Lost : LetterVerdict::Open;
}

// Absent when an automaton met its limit.
std::optional<Verdicts> foreseen(ltl::Formula f, const std::vector<ltl::Letter>& letters, ltl::Semantics semantics,
                                 const std::stop_token& stop) {
  const auto words = semantics == ltl::Semantics::Finite ? automata::Words::Finite : automata::Words::Infinite;
  auto made = automata::ConjunctionMonitor::of(f, words, {.states = most_states, .stop = stop});
  if (stop.stop_requested()) throw Interrupted();
  auto* monitor = std::get_if<automata::ConjunctionMonitor>(&made);
  if (monitor == nullptr) return std::nullopt;
  Verdicts out;
  try {
    for (const ltl::Letter& letter : letters) {
      if (stop.stop_requested()) throw Interrupted();
      const automata::MonitorVerdict said = monitor->read(letter);
      out.letters.push_back(letter_verdict(said));
      out.are_known = out.are_known && said.is_known_satisfiable;
    }
  } catch (const automata::Budget::Exceeded&) {  // stopped
    throw Interrupted();
  }
  return out;
}

std::optional<bool> verdict(ltl::Formula f, const ltl::AnyWord& word, ltl::Semantics semantics,
                            const std::optional<Verdicts>& verdicts) {
  if (const auto* lasso = std::get_if<ltl::Lasso>(&word)) return ltl::holds(*lasso, f);
  if (semantics == ltl::Semantics::Finite) return satisfies(std::get<ltl::Trace>(word), f);
  if (!verdicts) throw GaveUp("the automaton that foresees continuations has too many states");
  if (verdicts->letters.back() == LetterVerdict::Open) return std::nullopt;
  return verdicts->letters.back() == LetterVerdict::Satisfied;
}

}  // namespace

JudgedWord judge(ltl::Formula f, const ltl::AnyWord& word, ltl::Semantics semantics, bool each,
                 const std::stop_token& stop) {
  const std::vector<ltl::Letter> letters = letters_of(word);
  const bool finite = semantics == ltl::Semantics::Finite;
  JudgedWord judged;
  const bool goes_on = !finite && std::holds_alternative<ltl::Trace>(word);
  if (!goes_on) judged.satisfied = verdict(f, word, semantics, std::nullopt);
  if (!each && judged.satisfied.value_or(false)) return judged;

  const std::optional<Verdicts> verdicts = foreseen(f, letters, semantics, stop);
  if (goes_on) judged.satisfied = verdict(f, word, semantics, verdicts);
  if (verdicts) {
    const std::vector<LetterVerdict>& all = verdicts->letters;
    if (finite && (all.back() == LetterVerdict::Satisfied) != judged.satisfied)
      throw std::logic_error("monitor and definition disagree on " + ltl::print(f));
    judged.is_known_satisfiable = verdicts->are_known;
    judged.knows_loss = verdicts->are_known;
    const auto lost = std::find(all.begin(), all.end(), LetterVerdict::Lost);
    if (lost != all.end()) judged.lost = static_cast<std::size_t>(lost - all.begin());
  }
  if (!each) return judged;
  judged.letters = progressed(f, letters, semantics, stop);
  if (finite && ltl::accepts_empty(judged.letters.back().remains) != judged.satisfied)
    throw std::logic_error("progression and definition disagree on " + ltl::print(f));
  if (!verdicts) return judged;
  for (std::size_t i = 0; i < letters.size(); ++i) {
    judged.letters[i].verdict = verdicts->letters[i];
    if (verdicts->letters[i] == LetterVerdict::Lost) judged.letters[i].remains = f.arena().constant(false);
  }
  return judged;
}

}  // namespace waymark::tools

#include "tools/judged_word.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>
#include <utility>
#include <variant>

#include "libautomata/finite/ltlf_to_dfa.hpp"
#include "libautomata/finite/run.hpp"
#include "libltl/meaning/progress.hpp"
#include "libltl/meaning/trace_check.hpp"
#include "libltl/rewriting/simplify.hpp"
#include "libltl/text/print.hpp"
#include "libplan/solve/task_automaton.hpp"
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

std::vector<JudgedLetter> progressed(ltl::Formula rest, const std::vector<ltl::Letter>& letters,
                                     ltl::Semantics semantics, const std::stop_token& stop) {
  const auto over = semantics == ltl::Semantics::Finite ? ltl::Over::Rest : ltl::Over::Infinite;
  std::vector<JudgedLetter> out;
  for (const ltl::Letter& letter : letters) {
    if (stop.stop_requested()) throw Interrupted();
    rest = ltl::simplify(ltl::progress(rest, letter, semantics), over);
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

// Verdicts letter by letter; absent when the automaton met its limit.
using Verdicts = std::optional<std::vector<LetterVerdict>>;

Verdicts finite_verdicts(ltl::Formula f, const ltl::Trace& word, const std::stop_token& stop) {
  const auto made = automata::ltlf_to_dfa(f, {.states = most_states, .stop = stop});
  const auto* dfa = std::get_if<automata::Dfa>(&made);
  if (stop.stop_requested()) throw Interrupted();
  if (dfa == nullptr) return std::nullopt;
  const automata::Run run = automata::run(*dfa, word);
  if (run.accepted != satisfies(word, f))
    throw std::logic_error("automaton and definition disagree on " + ltl::print(f));
  std::vector<LetterVerdict> out;
  for (std::size_t i = 1; i < run.states.size(); ++i)
    out.push_back(dfa->is_accepting(run.states[i]) ? LetterVerdict::Satisfied
                  : dfa->is_trap(run.states[i])    ? LetterVerdict::Lost
                                                   : LetterVerdict::Open);
  return out;
}

// The states in which a run on the letters so far may be. The automaton is trimmed: none is left exactly when no
// continuation is accepted.
class Reached {
 public:
  explicit Reached(const automata::Automaton& automaton) : automaton_(automaton), states_{automaton.initial().index} {}

  bool read(const ltl::Letter& letter) {  // is any left?
    std::vector<std::uint32_t> next;
    for (const std::uint32_t q : states_)
      for (const automata::Branch& branch : automaton_.next(automata::StateId{q}, letter))
        next.push_back(branch.target);
    std::sort(next.begin(), next.end());
    next.erase(std::unique(next.begin(), next.end()), next.end());
    states_ = std::move(next);
    return !states_.empty();
  }
  const std::vector<std::uint32_t>& states() const { return states_; }

 private:
  const automata::Automaton& automaton_;
  std::vector<std::uint32_t> states_;
};

std::optional<automata::Automaton> trimmed(ltl::Formula f, const std::stop_token& stop) {
  auto made = plan::lasso_automaton(f, {.states = most_states, .stop = stop});
  if (stop.stop_requested()) throw Interrupted();
  return made;
}

// Of u and of one round of v; a loss in a later round is one of the whole word, not of a letter.
Verdicts infinite_verdicts(ltl::Formula f, const std::vector<ltl::Letter>& letters, const std::stop_token& stop) {
  const auto yes = trimmed(f, stop), no = trimmed(ltl::negate(f), stop);
  if (!yes || !no) return std::nullopt;
  Reached for_it(*yes), against_it(*no);
  std::vector<LetterVerdict> out;
  for (const ltl::Letter& letter : letters) {
    const bool may_hold = for_it.read(letter), may_fail = against_it.read(letter);
    out.push_back(!may_hold ? LetterVerdict::Lost : !may_fail ? LetterVerdict::Satisfied : LetterVerdict::Open);
  }
  return out;
}

std::optional<bool> verdict(ltl::Formula f, const ltl::AnyWord& word, ltl::Semantics semantics,
                            const Verdicts& verdicts) {
  if (const auto* lasso = std::get_if<ltl::Lasso>(&word)) return ltl::holds(*lasso, f);
  if (semantics == ltl::Semantics::Finite) return satisfies(std::get<ltl::Trace>(word), f);
  if (!verdicts) throw GaveUp("the automaton that foresees continuations has too many states");
  if (verdicts->back() == LetterVerdict::Open) return std::nullopt;
  return verdicts->back() == LetterVerdict::Satisfied;
}

}  // namespace

JudgedWord judge(ltl::Formula f, const ltl::AnyWord& word, ltl::Semantics semantics, bool each,
                 const std::stop_token& stop) {
  const std::vector<ltl::Letter> letters = letters_of(word);
  const bool finite = semantics == ltl::Semantics::Finite;
  const auto verdicts_of_all = [&] {
    return finite ? finite_verdicts(f, std::get<ltl::Trace>(word), stop) : infinite_verdicts(f, letters, stop);
  };
  JudgedWord judged;
  const bool goes_on = !finite && std::holds_alternative<ltl::Trace>(word);
  if (!goes_on) judged.satisfied = verdict(f, word, semantics, std::nullopt);
  if (!each && judged.satisfied.value_or(false)) return judged;

  const Verdicts verdicts = verdicts_of_all();
  if (goes_on) judged.satisfied = verdict(f, word, semantics, verdicts);
  if (verdicts) {
    judged.knows_loss = true;
    const auto lost = std::find(verdicts->begin(), verdicts->end(), LetterVerdict::Lost);
    if (lost != verdicts->end()) judged.lost = static_cast<std::size_t>(lost - verdicts->begin());
  }
  if (!each) return judged;
  judged.letters = progressed(f, letters, semantics, stop);
  if (finite && ltl::accepts_empty(judged.letters.back().remains) != judged.satisfied)
    throw std::logic_error("progression and definition disagree on " + ltl::print(f));
  if (!verdicts) return judged;
  for (std::size_t i = 0; i < letters.size(); ++i) {
    judged.letters[i].verdict = (*verdicts)[i];
    if ((*verdicts)[i] == LetterVerdict::Lost) judged.letters[i].remains = f.arena().constant(false);
  }
  return judged;
}

}  // namespace waymark::tools

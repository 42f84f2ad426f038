#include "tools/automaton_request.hpp"

#include <optional>
#include <utility>

#include "libautomata/deterministic/to_parity.hpp"
#include "libautomata/finite/ltlf_to_dfa.hpp"
#include "libautomata/finite/minimize.hpp"
#include "libautomata/finite/product.hpp"
#include "libautomata/finite/run.hpp"
#include "libautomata/hoa/exchange.hpp"
#include "libautomata/hoa/omega.hpp"
#include "libautomata/omega/lasso.hpp"
#include "libautomata/omega/operations.hpp"
#include "libautomata/omega/reduce.hpp"
#include "libautomata/omega/without_fin.hpp"
#include "libautomata/translation/ltl_to_buchi.hpp"
#include "libltl/text/parse.hpp"
#include "tools/shell/input.hpp"

namespace waymark::tools {
namespace {

bool is_finite(const automata::HoaAutomaton& file) {
  for (const automata::HoaToken& property : file.properties)
    if (property.text == "finite-words") return true;
  return false;
}

AnyAutomaton read_one(const std::string& path, automata::Budget& budget) {
  const std::string text = read_file(path), source = source_name(path);
  return understood(automata::parse_hoa(text, source), source, budget);
}

// All words that are not accepted; nondeterministic automata are determinised first.
automata::Automaton complement_of(const automata::Automaton& automaton, automata::Budget& budget) {
  return automata::complement(automata::determinized(automaton, budget)).automaton();
}

[[noreturn]] void mixed() { throw UsageError("one automaton is about finite words, the other about infinite ones"); }

// All words that are left: those of the second automaton taken away from the first.
std::optional<ltl::Lasso> word_left(const automata::Automaton& a, const automata::Automaton& b,
                                    automata::Budget& budget, ltl::Vocabulary& vocabulary) {
  const automata::Automaton rest = automata::intersection(a, complement_of(b, budget), budget);
  vocabulary = rest.vocabulary();
  return automata::find_lasso(rest);
}

template <class Word>
Reply answer(const char* yes, const std::string& no, const std::optional<Word>& word,
             const ltl::Vocabulary& vocabulary) {
  if (!word) return {ExitCode::Done, std::string(yes) + '\n'};
  return {ExitCode::No, no + ltl::show(*word, vocabulary) + '\n'};
}

std::string only(const std::string& source) { return "only " + source_name(source) + " accepts "; }

constexpr auto conjunction_of = [](bool p, bool q) { return p && q; };
constexpr auto disjunction_of = [](bool p, bool q) { return p || q; };
constexpr auto difference_of = [](bool p, bool q) { return p && !q; };
// The words that a DFA rejects: against an automaton that accepts all.
automata::Dfa all_words() {
  return automata::read_hoa("HOA: v1 Start: 0 AP: 0 Acceptance: 0 t --BODY-- State: 0 [t] 0 --END--");
}

Reply compare(const automata::Dfa& a, const automata::Dfa& b, const AutomatonRequest& request,
              automata::Budget& budget) {
  if (!request.equivalent.empty()) {
    const auto found = automata::difference(a, b, budget);
    if (!found) return {ExitCode::Done, "equivalent\n"};
    return {ExitCode::No, only(found->first_accepts ? request.source : request.equivalent) +
                              ltl::show(found->word, found->vocabulary) + '\n'};
  }
  const automata::Dfa rest = automata::product(a, b, difference_of, budget);
  return answer("included", only(request.source), automata::shortest_word(rest), rest.vocabulary());
}

Reply compare(const automata::Automaton& a, const automata::Automaton& b, const AutomatonRequest& request,
              automata::Budget& budget) {
  ltl::Vocabulary vocabulary;
  const auto more = word_left(a, b, budget, vocabulary);
  if (more || request.equivalent.empty())
    return answer(request.equivalent.empty() ? "included" : "equivalent", only(request.source), more, vocabulary);
  const auto less = word_left(b, a, budget, vocabulary);
  return answer("equivalent", only(request.equivalent), less, vocabulary);
}

// By components and simulation where marks are only asked for infinitely often; a deterministic automaton also as one
// with a parity condition, minimal when its language is an obligation. The smaller one.
automata::Automaton reduced(const automata::Automaton& automaton, automata::Budget& budget, Shown& about) {
  std::optional<automata::Automaton> best;
  if (automaton.acceptance().is_generalized_buchi()) {
    automata::Reduced result = automata::reduce(automaton.transitions(), automata::MarksOn::Edges, budget);
    if (!result.complete) about.status = "unreduced";
    best = automata::as_automaton(result.automaton, automaton.vocabulary(), automaton.reads());
  }
  if (automata::is_deterministic(automaton.transitions())) {
    const automata::Automaton parity = automata::to_parity(automaton, budget).automaton();
    if (parity.states() < (best ? best->states() : automaton.states())) best = parity;
  }
  if (!best) about.status = "unreduced";
  return best ? *best : automaton;
}

AnyAutomaton changed(automata::Dfa dfa, const AutomatonRequest& request, automata::Budget& budget) {
  if (!request.kind.empty()) throw UsageError("--to " + request.kind + " is about infinite words");
  const auto with = [&](const std::string& path, automata::Verdict verdict) {
    const AnyAutomaton other = read_one(path, budget);
    if (!std::holds_alternative<automata::Dfa>(other)) mixed();
    dfa = automata::product(dfa, std::get<automata::Dfa>(other), verdict, budget);
  };
  if (request.complement) dfa = automata::product(all_words(), dfa, difference_of, budget);
  if (!request.product.empty()) with(request.product, conjunction_of);
  if (!request.either.empty()) with(request.either, disjunction_of);
  if (!request.difference.empty()) with(request.difference, difference_of);
  if (request.minimize || request.reduce) dfa = automata::minimize(dfa, budget);
  return dfa;
}

automata::Automaton other_omega(const std::string& path, automata::Budget& budget) {
  AnyAutomaton other = read_one(path, budget);
  if (!std::holds_alternative<automata::Automaton>(other)) mixed();
  return std::get<automata::Automaton>(std::move(other));
}

automata::Automaton united(const automata::Automaton& a, const automata::Automaton& b, automata::Budget& budget) {
  const auto first = automata::Deterministic::checked(a), second = automata::Deterministic::checked(b);
  if (first && second) return automata::either(*first, *second, budget).automaton();
  return automata::sum(a, b);
}

// The kinds that `waymark translate --to` makes, from an automaton instead of a formula.
automata::Automaton converted(const automata::Automaton& a, const std::string& kind, automata::Budget& budget) {
  if (kind == "parity" || kind == "ldba") return automata::to_parity(a, budget).automaton();
  const automata::Automaton general = automata::as_automaton(
      automata::reduce(automata::without_fin(a.transitions(), budget), automata::MarksOn::Edges, budget).automaton,
      a.vocabulary(), a.reads());
  return kind == "buchi" ? *automata::make_state_based(general, budget) : general;
}

AnyAutomaton changed(automata::Automaton a, const AutomatonRequest& request, automata::Budget& budget, Shown& about) {
  if (request.complement) a = complement_of(a, budget);
  if (!request.product.empty()) a = automata::intersection(a, other_omega(request.product, budget), budget);
  if (!request.either.empty()) a = united(a, other_omega(request.either, budget), budget);
  if (!request.difference.empty())
    a = automata::intersection(a, complement_of(other_omega(request.difference, budget), budget), budget);
  if (request.minimize || request.reduce) a = reduced(a, budget, about);
  return request.kind.empty() ? a : converted(a, request.kind, budget);
}

}  // namespace

AnyAutomaton understood(automata::HoaAutomaton file, const std::string& source, automata::Budget& budget) {
  if (is_finite(file)) return automata::to_dfa(std::move(file), source);
  return automata::to_automaton(std::move(file), source, budget);
}

AnyAutomaton transformed(AnyAutomaton any, const AutomatonRequest& request, automata::Budget& budget, Shown& about) {
  if (auto* dfa = std::get_if<automata::Dfa>(&any)) return changed(std::move(*dfa), request, budget);
  return changed(std::get<automata::Automaton>(std::move(any)), request, budget, about);
}

// Against the automaton of the negation, which always exists.
Reply satisfies(const AnyAutomaton& any, const AutomatonRequest& request, automata::Budget& budget,
                std::stop_token stop) {
  ltl::Arena arena;
  const ltl::Formula no = ltl::negate(ltl::parse(request.satisfies, arena));
  const automata::TranslationLimits limits{.states = request.states, .stop = std::move(stop)};
  const auto answer_to = [&](const auto& rest, const auto& word) {
    return answer("satisfied", "not satisfied by ", word, rest.vocabulary());
  };
  const auto automaton_of = [](auto result) {
    if (std::holds_alternative<automata::Exhausted>(result))
      throw automata::Budget::Exceeded{automata::Budget::Exceeded::Reason::States};
    return std::get<0>(std::move(result));
  };
  if (const auto* dfa = std::get_if<automata::Dfa>(&any)) {
    const automata::Dfa rest =
        automata::product(*dfa, automaton_of(automata::ltlf_to_dfa(no, limits)), conjunction_of, budget);
    return answer_to(rest, automata::shortest_word(rest));
  }
  const automata::Automaton rest = automata::intersection(
      std::get<automata::Automaton>(any), automaton_of(automata::ltl_to_tgba(no, limits)).automaton, budget);
  return answer_to(rest, automata::find_lasso(rest));
}

Reply asked_of(const AnyAutomaton& any, const AutomatonRequest& request, automata::Budget& budget) {
  if (const auto* dfa = std::get_if<automata::Dfa>(&any)) {
    if (request.empty) return answer("empty", "accepts ", automata::shortest_word(*dfa), dfa->vocabulary());
    if (request.universal) {
      const automata::Dfa rest = automata::product(all_words(), *dfa, difference_of, budget);
      return answer("universal", "rejects ", automata::shortest_word(rest), rest.vocabulary());
    }
    const AnyAutomaton other = read_one(request.equivalent.empty() ? request.included : request.equivalent, budget);
    if (!std::holds_alternative<automata::Dfa>(other)) mixed();
    return compare(*dfa, std::get<automata::Dfa>(other), request, budget);
  }
  const auto& a = std::get<automata::Automaton>(any);
  if (request.empty) return answer("empty", "accepts ", automata::find_lasso(a), a.vocabulary());
  if (request.universal) {
    const automata::Automaton rest = complement_of(a, budget);
    return answer("universal", "rejects ", automata::find_lasso(rest), rest.vocabulary());
  }
  return compare(a, other_omega(request.equivalent.empty() ? request.included : request.equivalent, budget), request,
                 budget);
}

}  // namespace waymark::tools

#include "tools/automaton_request.hpp"

#include <optional>
#include <utility>

#include "libautomata/deterministic/conversions.hpp"
#include "libautomata/deterministic/to_parity.hpp"
#include "libautomata/finite/ltlf_to_dfa.hpp"
#include "libautomata/finite/minimize.hpp"
#include "libautomata/finite/product.hpp"
#include "libautomata/finite/run.hpp"
#include "libautomata/hoa/exchange.hpp"
#include "libautomata/hoa/omega.hpp"
#include "libautomata/monitor/good_prefixes.hpp"
#include "libautomata/omega/lasso.hpp"
#include "libautomata/omega/operations.hpp"
#include "libautomata/omega/reduce.hpp"
#include "libautomata/translation/ltl_to_buchi.hpp"
#include "libltl/diagnostic.hpp"
#include "libltl/limits.hpp"
#include "libltl/text/parse.hpp"
#include "tools/shell/input.hpp"
#include "tools/shell/json.hpp"

namespace waymark::tools {
namespace {

bool is_finite(const automata::HoaAutomaton& file) {
  for (const automata::HoaToken& property : file.properties)
    if (property.text == "finite-words") return true;
  return false;
}

AnyAutomaton other_of(const std::string& file, const AutomatonRequest& request, automata::Budget& budget) {
  return understood(request.others->of(file, request.number), source_name(file), budget);
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

// The answer to a question: yes, or no and a word that shows why, which one of two files alone accepts.
struct Verdict {
  std::string question, otherwise = {};  // "equivalent", "accepts "
  std::optional<std::string> word = {}, accepted_by = {};
};

template <class Word>
std::optional<std::string> text_of(const std::optional<Word>& word, const ltl::Vocabulary& vocabulary) {
  return word ? std::optional(ltl::show(*word, vocabulary)) : std::nullopt;
}

Reply reply_of(const Verdict& verdict, const AutomatonRequest& request) {
  const ExitCode code = verdict.word ? ExitCode::No : ExitCode::Done;
  if (request.json) {
    JsonObject json;
    json.add("line", request.number).add("question", verdict.question).add("answer", !verdict.word);
    if (verdict.word) json.add("word", *verdict.word);
    if (verdict.word && verdict.accepted_by) json.add("accepted_by", *verdict.accepted_by);
    return {code, json.text() + '\n'};
  }
  if (!verdict.word) return {code, verdict.question + '\n'};
  const std::string who = verdict.accepted_by ? "only " + *verdict.accepted_by + " accepts " : verdict.otherwise;
  return {code, who + *verdict.word + '\n'};
}

// The file, and the number in it where it holds several.
std::string name_of(const std::string& file, bool is_stream, const AutomatonRequest& request) {
  return source_name(file) + (is_stream ? " (automaton " + std::to_string(request.number) + ")" : "");
}
std::string first_name(const AutomatonRequest& request) { return name_of(request.source, request.is_stream, request); }
std::string other_name(const std::string& file, const AutomatonRequest& request) {
  return name_of(file, request.others->is_stream(file), request);
}

constexpr auto conjunction_of = [](bool p, bool q) { return p && q; };
constexpr auto disjunction_of = [](bool p, bool q) { return p || q; };
constexpr auto difference_of = [](bool p, bool q) { return p && !q; };
// The words that a DFA rejects: against an automaton that accepts all.
automata::Dfa all_words() {
  return automata::read_hoa("HOA: v1 Start: 0 AP: 0 Acceptance: 0 t --BODY-- State: 0 [t] 0 --END--");
}

Verdict compare(const automata::Dfa& a, const automata::Dfa& b, const AutomatonRequest& request,
                automata::Budget& budget) {
  if (!request.equivalent.empty()) {
    const auto found = automata::difference(a, b, budget);
    if (!found) return {.question = "equivalent"};
    return {.question = "equivalent",
            .word = ltl::show(found->word, found->vocabulary),
            .accepted_by = found->first_accepts ? first_name(request) : other_name(request.equivalent, request)};
  }
  const automata::Dfa rest = automata::product(a, b, difference_of, budget);
  return {.question = "included",
          .word = text_of(automata::shortest_word(rest), rest.vocabulary()),
          .accepted_by = first_name(request)};
}

Verdict compare(const automata::Automaton& a, const automata::Automaton& b, const AutomatonRequest& request,
                automata::Budget& budget) {
  ltl::Vocabulary vocabulary;
  const std::string question = request.equivalent.empty() ? "included" : "equivalent";
  const auto more = text_of(word_left(a, b, budget, vocabulary), vocabulary);
  if (more || request.equivalent.empty())
    return {.question = question, .word = more, .accepted_by = first_name(request)};
  const auto less = text_of(word_left(b, a, budget, vocabulary), vocabulary);
  return {.question = question, .word = less, .accepted_by = other_name(request.equivalent, request)};
}

// By components and simulation where marks are only asked for infinitely often; a deterministic automaton also as one
// with a parity condition, minimal when its language is an obligation. The smaller one.
automata::Automaton reduced(const automata::Automaton& automaton, automata::Budget& budget, Shown& about) {
  std::optional<automata::Automaton> best;
  if (automaton.acceptance().is_generalized_buchi()) {
    automata::Reduced result = automata::reduce(automaton.transitions(), automata::MarksOn::Edges, budget);
    if (!result.complete) about.status = "unreduced";
    best = automata::with_edges(automaton, result.automaton);
  }
  if (automata::is_deterministic(automaton.transitions())) {
    const automata::Automaton parity = automata::to_parity(automaton, budget).automaton();
    if (parity.states() < (best ? best->states() : automaton.states())) best = parity;
  }
  if (!best) about.status = "unreduced";
  return best ? *best : automaton;
}

AnyAutomaton changed(automata::Dfa dfa, const AutomatonRequest& request, automata::Budget& budget) {
  if (!request.kind.empty() && request.kind != "dfa")
    throw UsageError(
        "--to " + request.kind +
        " is about infinite words, and this automaton about finite ones: --to dfa, or translate its formula");
  const auto with = [&](const std::string& path, automata::Verdict verdict) {
    const AnyAutomaton other = other_of(path, request, budget);
    if (!std::holds_alternative<automata::Dfa>(other)) mixed();
    dfa = automata::product(dfa, std::get<automata::Dfa>(other), verdict, budget);
  };
  if (request.complement) dfa = automata::product(all_words(), dfa, difference_of, budget);
  if (!request.product.empty()) with(request.product, conjunction_of);
  if (!request.either.empty()) with(request.either, disjunction_of);
  if (!request.difference.empty()) with(request.difference, difference_of);
  if (request.minimize || request.reduce || request.kind == "dfa") dfa = automata::minimize(dfa, budget);
  return dfa;
}

automata::Automaton other_omega(const std::string& path, const AutomatonRequest& request, automata::Budget& budget) {
  AnyAutomaton other = other_of(path, request, budget);
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
  if (kind == "generic") return automata::to_generic(a, budget);
  if (kind == "rabin") return automata::to_rabin(a, budget);
  if (kind == "parity" || kind == "ldba") return automata::to_parity(a, budget).automaton();
  const automata::Automaton general = automata::to_tgba(a, budget);
  return kind == "buchi" ? *automata::make_state_based(general, budget) : general;
}

// Throws UsageError when the good prefixes do not say it all: when a word is accepted although no prefix settles that.
automata::Dfa settled(const automata::Automaton& a, automata::Budget& budget) {
  auto made = automata::good_prefixes(a, budget);
  if (const auto* unsettled = std::get_if<automata::UnsettledWord>(&made))
    throw UsageError("--to dfa: no finite prefix settles that this word is accepted: " +
                     ltl::show(unsettled->word, unsettled->vocabulary));
  return std::get<automata::Dfa>(std::move(made));
}

AnyAutomaton changed(automata::Automaton a, const AutomatonRequest& request, automata::Budget& budget, Shown& about) {
  if (request.complement) a = complement_of(a, budget);
  if (!request.product.empty()) a = automata::intersection(a, other_omega(request.product, request, budget), budget);
  if (!request.either.empty()) a = united(a, other_omega(request.either, request, budget), budget);
  if (!request.difference.empty())
    a = automata::intersection(a, complement_of(other_omega(request.difference, request, budget), budget), budget);
  if (request.minimize || request.reduce) a = reduced(a, budget, about);
  if (request.kind == "dfa") {
    about.semantics = "finite";
    return settled(a, budget);
  }
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

OtherAutomata::OtherAutomata(const std::vector<std::string>& files) {
  std::string longest;
  for (const std::string& file : files) {
    if (files_.contains(file)) continue;
    const std::string source = source_name(file);
    auto& [text, all] = files_[file];
    text = read_file(file);
    automata::HoaReader reader(text, source);
    while (auto automaton = reader.next())
      if (!automaton->aborted) all.push_back(std::move(*automaton));
    if (all.empty()) throw ltl::FormatError(source, 1, 1, "expected 'HOA: v1' at the beginning");
    if (all.size() > 1 && count_ > 1 && all.size() != count_)
      throw UsageError(source + " holds " + std::to_string(all.size()) + " automata, " + longest + ' ' +
                       std::to_string(count_));
    if (all.size() > count_) count_ = all.size(), longest = source;
  }
}

const automata::HoaAutomaton& OtherAutomata::of(const std::string& file, std::size_t number) const {
  const std::vector<automata::HoaAutomaton>& all = files_.at(file).automata;
  if (all.size() == 1) return all.front();
  if (number <= all.size()) return all[number - 1];
  throw ltl::FormatError(source_name(file), 0, 0,
                         "there is no automaton " + std::to_string(number) + " to meet the other one of its number");
}

std::vector<std::string> AutomatonRequest::files() const {
  std::vector<std::string> named;
  for (const std::string* file : {&product, &either, &difference, &equivalent, &included})
    if (!file->empty()) named.push_back(*file);
  return named;
}

// Against the automaton of the negation, which always exists.
Reply satisfies(const AnyAutomaton& any, const AutomatonRequest& request, automata::Budget& budget,
                std::stop_token stop) {
  ltl::Arena arena;
  const ltl::Formula no = ltl::negate(ltl::parse(request.satisfies, arena));
  const ltl::Limits limits{.states = request.states, .stop = std::move(stop)};
  const auto answer_to = [&](const auto& rest, const auto& word) {
    return reply_of(
        {.question = "satisfied", .otherwise = "not satisfied by ", .word = text_of(word, rest.vocabulary())}, request);
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

namespace {

Verdict asked_of(const automata::Dfa& dfa, const AutomatonRequest& request, automata::Budget& budget) {
  if (request.empty)
    return {
        .question = "empty", .otherwise = "accepts ", .word = text_of(automata::shortest_word(dfa), dfa.vocabulary())};
  if (request.universal) {
    const automata::Dfa rest = automata::product(all_words(), dfa, difference_of, budget);
    return {.question = "universal",
            .otherwise = "rejects ",
            .word = text_of(automata::shortest_word(rest), rest.vocabulary())};
  }
  const AnyAutomaton other =
      other_of(request.equivalent.empty() ? request.included : request.equivalent, request, budget);
  if (!std::holds_alternative<automata::Dfa>(other)) mixed();
  return compare(dfa, std::get<automata::Dfa>(other), request, budget);
}

Verdict asked_of(const automata::Automaton& a, const AutomatonRequest& request, automata::Budget& budget) {
  if (request.empty)
    return {.question = "empty", .otherwise = "accepts ", .word = text_of(automata::find_lasso(a), a.vocabulary())};
  if (request.universal) {
    const automata::Automaton rest = complement_of(a, budget);
    return {.question = "universal",
            .otherwise = "rejects ",
            .word = text_of(automata::find_lasso(rest), rest.vocabulary())};
  }
  const std::string& file = request.equivalent.empty() ? request.included : request.equivalent;
  return compare(a, other_omega(file, request, budget), request, budget);
}

}  // namespace

Reply asked_of(const AnyAutomaton& any, const AutomatonRequest& request, automata::Budget& budget) {
  return reply_of(std::visit([&](const auto& automaton) { return asked_of(automaton, request, budget); }, any),
                  request);
}

}  // namespace waymark::tools

// waymark automaton: HOA files → operations on their automata, questions about them, other formats.
//
// Automata that say finite-words are DFAs, all others are read as automata on infinite words. A stream is answered
// automaton by automaton. What a file claims and its body contradicts is said on standard error.
#include <CLI/App.hpp>
#include <iostream>
#include <memory>
#include <variant>

#include "libautomata/deterministic/to_parity.hpp"
#include "libautomata/hoa.hpp"
#include "libautomata/hoa_claims.hpp"
#include "libautomata/limit_deterministic/ltl_to_ldba.hpp"
#include "libautomata/minimize.hpp"
#include "libautomata/omega/exchange.hpp"
#include "libautomata/omega/hoa.hpp"
#include "libautomata/omega/lasso.hpp"
#include "libautomata/omega/ltl_to_buchi.hpp"
#include "libautomata/omega/operations.hpp"
#include "libautomata/omega/reduce.hpp"
#include "libautomata/omega/without_fin.hpp"
#include "libautomata/product.hpp"
#include "libautomata/run.hpp"
#include "libltl/diagnostic.hpp"
#include "libltl/parse.hpp"
#include "tools/automaton_output.hpp"
#include "tools/shell/deadline.hpp"
#include "tools/shell/input.hpp"
#include "tools/subcommand.hpp"

namespace waymark::tools {
namespace {

using Any = std::variant<automata::Dfa, automata::Automaton>;

struct Options {
  std::string file = "-", product, either, difference, equivalent, included, satisfies;
  std::string kind;  // of automaton to make: tgba, buchi, parity, ldba
  bool complement = false, empty = false, universal = false, minimize = false, reduce = false, strict = false;
  OutputOptions output;
  std::size_t states = 1'000'000;
  double seconds = 0;
};

bool is_finite(const automata::HoaAutomaton& file) {
  for (const automata::HoaToken& property : file.properties)
    if (property.text == "finite-words") return true;
  return false;
}

Any understood(automata::HoaAutomaton file, const std::string& source, automata::Effort& effort) {
  if (is_finite(file)) return automata::to_dfa(std::move(file), source);
  return automata::to_automaton(std::move(file), source, effort);
}

// Refused claims are an error with --strict, else a warning.
void check_claims(automata::HoaAutomaton& file, const std::string& source, bool strict) {
  for (const automata::HoaContradiction& c : automata::contradictions(file)) {
    const std::string problem = "the claim '" + std::string(c.claim.text) + "' is not true: " + c.reason;
    if (strict) throw ltl::FormatError(source, c.claim.line, c.claim.column, problem);
    complain("warning", ltl::FormatError(source, c.claim.line, c.claim.column, problem).what());
  }
}

Any read_one(const std::string& path, automata::Effort& effort) {
  const std::string text = read_file(path), source = source_name(path);
  return understood(automata::parse_hoa(text, source), source, effort);
}

// All words that are not accepted; nondeterministic automata are determinised first.
automata::Automaton complement_of(const automata::Automaton& automaton, automata::Effort& effort) {
  return automata::complement(automata::determinized(automaton, effort)).automaton();
}

[[noreturn]] void mixed() {
  throw UsageError("one automaton is about finite words, the other about infinite ones");
}

// All words that are left: those of the second automaton taken away from the first.
std::optional<ltl::Lasso> word_left(const automata::Automaton& a, const automata::Automaton& b,
                                    automata::Effort& effort, ltl::Vocabulary& vocabulary) {
  const automata::Automaton rest = automata::intersection(a, complement_of(b, effort), effort);
  vocabulary = rest.vocabulary();
  return automata::find_lasso(rest);
}

template <class Word>
Reply answer(const char* yes, const char* no, const std::optional<Word>& word,
             const ltl::Vocabulary& vocabulary) {
  if (!word) return {ExitCode::Done, std::string(yes) + '\n'};
  return {ExitCode::No, std::string(no) + ltl::show(*word, vocabulary) + '\n'};
}

constexpr auto conjunction_of = [](bool p, bool q) { return p && q; };
constexpr auto disjunction_of = [](bool p, bool q) { return p || q; };
constexpr auto difference_of = [](bool p, bool q) { return p && !q; };
// The words that a DFA rejects: against an automaton that accepts all.
automata::Dfa all_words() {
  return automata::read_hoa("HOA: v1 Start: 0 AP: 0 Acceptance: 0 t --BODY-- State: 0 [t] 0 --END--");
}

Reply compare(const automata::Dfa& a, const automata::Dfa& b, const Options& options) {
  if (!options.equivalent.empty()) {
    const auto found = automata::difference(a, b);
    if (!found) return {ExitCode::Done, "equivalent\n"};
    const char* which = found->first_accepts ? "only the first accepts " : "only the second accepts ";
    return {ExitCode::No, which + ltl::show(found->word, found->vocabulary) + '\n'};
  }
  const automata::Dfa rest = automata::product(a, b, difference_of);
  return answer("included", "only the first accepts ", automata::shortest_word(rest), rest.vocabulary());
}

Reply compare(const automata::Automaton& a, const automata::Automaton& b, const Options& options,
              automata::Effort& effort) {
  ltl::Vocabulary vocabulary;
  const auto more = word_left(a, b, effort, vocabulary);
  if (more || options.equivalent.empty())
    return answer(options.equivalent.empty() ? "included" : "equivalent", "only the first accepts ", more,
                  vocabulary);
  const auto less = word_left(b, a, effort, vocabulary);
  return answer("equivalent", "only the second accepts ", less, vocabulary);
}

// By components and simulation where marks are only asked for infinitely often; a deterministic automaton also as one
// with a parity condition, minimal when its language is an obligation. The smaller one.
automata::Automaton reduced(const automata::Automaton& automaton, automata::Effort& effort, Shown& about) {
  std::optional<automata::Automaton> best;
  if (automaton.acceptance().is_generalized_buchi()) {
    automata::Reduced result = automata::reduce(automaton.transitions(), automata::MarksOn::Edges, effort);
    if (!result.complete) about.status = "unreduced";
    best = automata::as_automaton(result.automaton, automaton.vocabulary(), automaton.reads());
  }
  if (automata::is_deterministic(automaton.transitions())) {
    const automata::Automaton parity = automata::to_parity(automaton, effort).automaton();
    if (parity.states() < (best ? best->states() : automaton.states())) best = parity;
  }
  if (!best) about.status = "unreduced";
  return best ? *best : automaton;
}

Any transformed(automata::Dfa dfa, const Options& options, automata::Effort& effort) {
  if (!options.kind.empty()) throw UsageError("--to " + options.kind + " is about infinite words");
  const auto with = [&](const std::string& path, automata::Verdict verdict) {
    const Any other = read_one(path, effort);
    if (!std::holds_alternative<automata::Dfa>(other)) mixed();
    dfa = automata::product(dfa, std::get<automata::Dfa>(other), verdict);
  };
  if (options.complement) dfa = automata::product(all_words(), dfa, difference_of);
  if (!options.product.empty()) with(options.product, conjunction_of);
  if (!options.either.empty()) with(options.either, disjunction_of);
  if (!options.difference.empty()) with(options.difference, difference_of);
  if (options.minimize || options.reduce) dfa = automata::minimize(dfa);
  return dfa;
}

automata::Automaton other_omega(const std::string& path, automata::Effort& effort) {
  Any other = read_one(path, effort);
  if (!std::holds_alternative<automata::Automaton>(other)) mixed();
  return std::get<automata::Automaton>(std::move(other));
}

automata::Automaton united(const automata::Automaton& a, const automata::Automaton& b,
                           automata::Effort& effort) {
  const auto first = automata::Deterministic::checked(a), second = automata::Deterministic::checked(b);
  if (first && second) return automata::either(*first, *second, effort).automaton();
  return automata::sum(a, b);
}

// The kinds that `waymark translate --to` makes, from an automaton instead of a formula.
automata::Automaton converted(const automata::Automaton& a, const std::string& kind,
                              automata::Effort& effort) {
  if (kind == "parity" || kind == "ldba") return automata::to_parity(a, effort).automaton();
  const automata::Automaton general = automata::as_automaton(
      automata::reduce(automata::without_fin(a.transitions(), effort), automata::MarksOn::Edges, effort)
          .automaton,
      a.vocabulary(), a.reads());
  return kind == "buchi" ? *automata::make_state_based(general, effort) : general;
}

Any transformed(automata::Automaton a, const Options& options, automata::Effort& effort, Shown& about) {
  if (options.complement) a = complement_of(a, effort);
  if (!options.product.empty()) a = automata::intersection(a, other_omega(options.product, effort), effort);
  if (!options.either.empty()) a = united(a, other_omega(options.either, effort), effort);
  if (!options.difference.empty())
    a = automata::intersection(a, complement_of(other_omega(options.difference, effort), effort), effort);
  if (options.minimize || options.reduce) a = reduced(a, effort, about);
  return options.kind.empty() ? a : converted(a, options.kind, effort);
}

// Do all words that are accepted satisfy the formula? Against the automaton of its negation, which always exists.
Reply satisfies(const Any& any, const Options& options, automata::Effort& effort, std::stop_token stop) {
  ltl::Arena arena;
  const ltl::Formula no = ltl::negate(ltl::parse(options.satisfies, arena));
  const automata::TranslationLimits limits{.states = options.states, .stop = std::move(stop)};
  const auto answer_to = [&](const auto& rest, const auto& word) {
    return answer("satisfied", "not satisfied by ", word, rest.vocabulary());
  };
  const auto automaton_of = [](auto result) {
    if (std::holds_alternative<automata::Exhausted>(result))
      throw automata::Effort::Spent{automata::Effort::Spent::Reason::States};
    return std::get<0>(std::move(result));
  };
  if (const auto* dfa = std::get_if<automata::Dfa>(&any)) {
    const automata::Dfa rest =
        automata::product(*dfa, automaton_of(automata::ltlf_to_dfa(no, limits)), conjunction_of);
    return answer_to(rest, automata::shortest_word(rest));
  }
  const automata::Automaton rest = automata::intersection(
      std::get<automata::Automaton>(any), automaton_of(automata::ltl_to_tgba(no, limits)).automaton, effort);
  return answer_to(rest, automata::find_lasso(rest));
}

Reply asked_of(const Any& any, const Options& options, automata::Effort& effort) {
  if (const auto* dfa = std::get_if<automata::Dfa>(&any)) {
    if (options.empty) return answer("empty", "accepts ", automata::shortest_word(*dfa), dfa->vocabulary());
    if (options.universal) {
      const automata::Dfa rest = automata::product(all_words(), *dfa, difference_of);
      return answer("universal", "rejects ", automata::shortest_word(rest), rest.vocabulary());
    }
    const Any other = read_one(options.equivalent.empty() ? options.included : options.equivalent, effort);
    if (!std::holds_alternative<automata::Dfa>(other)) mixed();
    return compare(*dfa, std::get<automata::Dfa>(other), options);
  }
  const auto& a = std::get<automata::Automaton>(any);
  if (options.empty) return answer("empty", "accepts ", automata::find_lasso(a), a.vocabulary());
  if (options.universal) {
    const automata::Automaton rest = complement_of(a, effort);
    return answer("universal", "rejects ", automata::find_lasso(rest), rest.vocabulary());
  }
  return compare(a, other_omega(options.equivalent.empty() ? options.included : options.equivalent, effort),
                 options, effort);
}

Reply reply_to(automata::HoaAutomaton file, const std::string& source, std::size_t number,
               const Options& options, automata::Effort& effort, const std::stop_token& stop) {
  check_claims(file, source, options.strict);
  Shown about{.line = number, .name = file.name, .unicode_name = file.name};
  Any any = understood(std::move(file), source, effort);
  about.semantics = std::holds_alternative<automata::Dfa>(any) ? "finite" : "infinite";
  any = std::holds_alternative<automata::Dfa>(any)
            ? transformed(std::get<automata::Dfa>(std::move(any)), options, effort)
            : transformed(std::get<automata::Automaton>(std::move(any)), options, effort, about);
  const bool changed = options.complement || !options.product.empty() || !options.either.empty() ||
                       !options.difference.empty();
  if (changed) about.name = about.unicode_name = "";
  if (!options.satisfies.empty()) return satisfies(any, options, effort, stop);
  if (options.empty || options.universal || !options.equivalent.empty() || !options.included.empty())
    return asked_of(any, options, effort);
  if (options.kind == "ldba" && std::holds_alternative<automata::Automaton>(any))
    return show(automata::limit_deterministic(*automata::Dpa::checked(std::get<automata::Automaton>(any))),
                about, options.output);
  return std::visit([&](const auto& automaton) { return show(automaton, about, options.output); }, any);
}

// A limit ends one automaton of the stream; a wrong one ends all.
Reply limited_reply(automata::HoaAutomaton file, const std::string& source, std::size_t number,
                    const Options& options, const Session& session) {
  const Deadline deadline(options.seconds, session.stop);
  automata::Effort effort(SIZE_MAX, options.states, deadline.token());
  try {
    return reply_to(std::move(file), source, number, options, effort, deadline.token());
  } catch (const automata::Effort::Spent& spent) {
    if (session.stop.stop_requested()) throw Interrupted();
    const std::string reason = spent.reason == automata::Effort::Spent::Reason::Stopped
                                   ? "gave up: the time is over"
                                   : "gave up: too many states or acceptance sets";
    return {ExitCode::GaveUp, show_none(number, 0, "limit", reason, options.output), reason};
  }
}

ExitCode run_automaton(const Options& options, const Session& session) {
  const std::string text = read_file(options.file), source = source_name(options.file);
  automata::HoaReader reader(text, source);
  ExitCode worst = ExitCode::Done;
  std::size_t number = 0;
  while (std::optional<automata::HoaAutomaton> file = reader.next()) {
    ++number;
    if (file->aborted) {
      complain("warning", "automaton " + std::to_string(number) + " was aborted by its writer");
      continue;
    }
    const Reply reply = limited_reply(*std::move(file), source, number, options, session);
    if (!reply.problem.empty()) complain("error", reply.problem);
    std::cout << reply.text << std::flush;
    worst = worse(worst, reply.code);
  }
  if (number == 0) throw ltl::FormatError(source, 1, 1, "expected 'HOA: v1' at the beginning");
  return worst;
}

}  // namespace

Runner setup_automaton(CLI::App& command) {
  const auto options = std::make_shared<Options>();
  command.add_option("file", options->file, "HOA, a stream of automata (-: standard input)")
      ->type_name("FILE");
  const auto file_option = [&](const char* name, std::string& path, const char* help) {
    command.add_option(name, path, help)->type_name("FILE");
  };
  command.add_flag("--complement", options->complement, "the words that are rejected");
  file_option("--product", options->product, "the words that both accept");
  file_option("--union", options->either, "the words that one of them accepts");
  file_option("--difference", options->difference, "without the words of that one");
  command.add_flag("--minimize", options->minimize, "DFAs: the minimal one; others: reduced");
  command.add_flag("--reduce", options->reduce, "smaller, without a promise");
  command.add_flag("--empty", options->empty, "is no word accepted? 10 and a word if one is");
  command.add_flag("--universal", options->universal, "is every word accepted? 10 and a word if one is not");
  file_option("--equivalent", options->equivalent, "do both accept the same words? 10 and a word if not");
  file_option("--included", options->included,
              "does that one accept all words of this one? 10 and a word if not");
  command
      .add_option("--satisfies", options->satisfies,
                  "do all words accepted satisfy this formula? 10 and a word if not")
      ->type_name("FORMULA");
  command.add_flag("--strict", options->strict, "a claim of the file that its body contradicts is an error");
  add_output_options(command, options->output);
  command
      .add_option_function<std::string>(
          "--to",
          [options](const std::string& what) {
            const bool is_kind = what == "tgba" || what == "buchi" || what == "parity" || what == "ldba";
            (is_kind ? options->kind : options->output.format) = what;
          },
          "a kind of automaton on infinite words to make of it; or the same as --format")
      ->check(CLI::IsMember(
          {"tgba", "buchi", "parity", "ldba", "hoa", "dot", "stats", "json", "tsv", "never", "lbtt", "ba"}));
  command.add_option("--limit-states", options->states, "give up beyond so many states")->type_name("N");
  command.add_option("--limit-seconds", options->seconds, "give up on an automaton after so many seconds")
      ->type_name("SECONDS")
      ->check(CLI::NonNegativeNumber);
  return [options](const Session& session) { return run_automaton(*options, session); };
}

}  // namespace waymark::tools

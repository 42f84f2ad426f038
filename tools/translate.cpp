// waymark translate: formula → automaton.
#include <algorithm>
#include <iostream>
#include <memory>

#include "libautomata/bdd/mtbdd.hpp"
#include "libautomata/budget.hpp"
#include "libltl/limits.hpp"
#include "libltl/structure/shape_memo.hpp"
#include "libltl/text/print.hpp"
#include "tools/answer.hpp"
#include "tools/automaton_output.hpp"
#include "tools/certificate.hpp"
#include "tools/shell/options.hpp"
#include "tools/shell/parallel.hpp"
#include "tools/shell/subcommand.hpp"
#include "tools/translations.hpp"

namespace waymark::tools {
namespace {

struct TranslateOptions {
  TextOptions text;
  NotationOptions notation;
  OutputOptions output;
  std::string semantics, target;
  std::size_t states = ltl::Limits{}.states;
  bool certify = false;
  ParallelOptions parallel;
};

Reply gave_up(const Text& text, double seconds, const TranslateOptions& options, const std::string& reason) {
  const Shown about{.line = text.line, .text = text.text, .status = "limit", .seconds = seconds};
  return {ExitCode::GaveUp, show_none(about, reason, options.output),
          reason + (text.source.empty() ? "" : "\n  " + text.source + ':' + std::to_string(text.line))};
}

// Running out of budget leaves the automaton as it is, and says so.
std::string certificate(ltl::Formula formula, const Translated& result, const Translation& translation,
                        const ltl::Limits& limits) {
  try {
    const Certificate certificate = certify(formula, result, translation, limits);
    return certificate.proved ? "proved" : counted(certificate.words, "word");
  } catch (const automata::Budget::Exceeded&) {
    return "none";
  }
}

// What a batch has translated, by the shape of the formula.
using Memo = ltl::ShapeMemo<Translated>;
constexpr std::size_t most_shapes = 4'096, most_nodes = 1'000;

// Whatever time may have had a part in is made again, and so is what is large.
bool worth_keeping(const Translated& result) {
  struct Judge {
    bool operator()(const automata::Dfa& dfa) const { return dfa.diagram().size() <= most_nodes; }
    bool operator()(const automata::Translated& made) const {
      return made.reduced && made.automaton.diagram().size() <= most_nodes;
    }
    bool operator()(const automata::TranslatedForMdps& made) const {
      return made.reduced && made.automaton.automaton().diagram().size() <= most_nodes;
    }
    bool operator()(const automata::Exhausted&) const { return false; }
  };
  return std::visit(Judge{}, result);
}

std::shared_ptr<const Translated> renamed(Translated result, const ltl::Vocabulary& names) {
  if (auto* dfa = std::get_if<automata::Dfa>(&result)) dfa->rename(names);
  if (auto* omega = std::get_if<automata::Translated>(&result)) omega->automaton.rename(names);
  if (auto* ldba = std::get_if<automata::TranslatedForMdps>(&result)) ldba->automaton.rename(names);
  return std::make_shared<const Translated>(std::move(result));
}

Reply translate_one(const Text& text, const TranslateOptions& options, const Translation& translation, Memo& memo,
                    const TextWatch& watched) {
  ltl::Arena arena;
  StopWatch watch;
  const ltl::Formula formula = parse_formula(text, arena, parse_options(options.notation, ltl::Unknown::Add));
  const ltl::Limits limits{.states = options.states, .stop = watched.token()};
  const auto run = [&](ltl::Formula f) { return translation.run(f, limits); };
  auto [made, known] = memo(formula, run, worth_keeping);
  const bool shows_names = options.output.format != "stats" || options.certify || !options.output.svg.empty();
  if (known && shows_names) made = renamed(*made, arena.vocabulary());
  const Translated& result = *made;
  Shown about{.line = text.line,
              .text = text.text,
              .semantics = std::string(translation.semantics),
              .seconds = watch.lap(),
              .stop = watched.token()};
  if (options.certify && !std::holds_alternative<automata::Exhausted>(result))
    about.certificate = certificate(formula, result, translation, limits);
  if (options.output.format != "stats") about.name = ltl::print(formula);
  if (options.output.format == "dot" || !options.output.svg.empty())
    about.unicode_name = ltl::print(formula, ltl::Style::Unicode);
  if (const auto* dfa = std::get_if<automata::Dfa>(&result)) return show(*dfa, about, options.output);
  if (const auto* omega = std::get_if<automata::Translated>(&result)) {
    if (!omega->reduced) about.status = "unreduced";
    return show(omega->automaton, about, options.output);
  }
  if (const auto* ldba = std::get_if<automata::TranslatedForMdps>(&result)) {
    if (!ldba->reduced) about.status = "unreduced";
    return show(ldba->automaton, about, options.output);
  }
  const std::size_t states = std::get<automata::Exhausted>(result).states;
  std::string reason = "gave up: more than " + counted(options.states, "state") + " before minimisation";
  if (watched.overrun() != ltl::Overrun::None)
    reason = gave_up(watched.overrun(), options.parallel.limits, about.seconds) + ", with " + counted(states, "state");
  else if (states < options.states)
    reason = "gave up with " + counted(states, "state") + ": a part of the formula has more than " +
             counted(automata::Mtbdd::max_variables, "temporal operator") +
             " and propositions, or needs too many steps";
  return gave_up(text, about.seconds, options, reason);
}

ExitCode run_translate(const TranslateOptions& options, const Session& session) {
  const Translation& translation = find_translation(options.semantics, options.target);
  TextReader texts(options.text, "formula");
  if (texts.is_batch() && !options.output.svg.empty())
    throw UsageError("--svg is for a single formula given as an argument");
  if (has_first_share(options.parallel.deal)) std::cout << heading(options.output);
  ParallelOptions parallel = options.parallel;
  parallel.settings = [&] { return session.settings({}); };
  Memo memo(texts.is_batch() ? most_shapes : 0);
  return answer_in_parallel(
      texts, session.stop, parallel,
      [&](const Text& text, const TextWatch& watched) {
        try {
          return translate_one(text, options, translation, memo, watched);
        } catch (const GaveUp&) {  // the drawing
          if (watched.overrun() == ltl::Overrun::None) throw;
          throw GaveUp(gave_up(watched.overrun(), options.parallel.limits));
        }
      },
      [&](const Text& text, const std::string& message) {
        const Shown about{.line = text.line, .text = text.text, .status = "error"};
        return show_none(about, message, options.output);
      });
}

}  // namespace

Runner setup_translate(Command command) {
  const auto options = std::make_shared<TranslateOptions>();
  add_text_options(command, options->text, "formula");
  add_notation_options(command, options->notation);
  command.add_option("--semantics", options->semantics, "what words formulas are read on (with dfa: finite)")
      .one_of({"finite", "infinite"});
  command.add_option("--to", options->target, "kind of automaton (of finite words: dfa; else tgba)")
      .one_of({"dfa", "tgba", "buchi", "parity", "rabin", "ldba", "generic"});
  add_output_options(command, options->output);
  command.add_flag("--certify", options->certify,
                   "check each automaton against that of the negation and the definition; exit 30 if one is wrong");
  command
      .add_option("--limit-states,--max-states", options->states, "give up beyond so many states before minimisation")
      .type_name("N")
      .show_default();
  add_work_limits(command, options->parallel.limits, "a formula", "--limit-seconds,--timeout");
  command.add_option("--threads", options->parallel.threads, "formulas translated at a time (0: all cores)")
      .type_name("N")
      .show_default();
  add_deal_options(command, options->parallel.deal);
  return [options](const Session& session) { return run_translate(*options, session); };
}

}  // namespace waymark::tools

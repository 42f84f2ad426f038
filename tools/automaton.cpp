// waymark automaton: HOA files → operations on their automata, questions about them, other formats.
//
// Automata that say finite-words are DFAs, all others are read as automata on infinite words. A stream is answered
// automaton by automaton.
#include <iostream>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "libautomata/limit_deterministic/ltl_to_ldba.hpp"
#include "libltl/diagnostic.hpp"
#include "tools/automaton_output.hpp"
#include "tools/automaton_request.hpp"
#include "tools/shell/input.hpp"
#include "tools/shell/subcommand.hpp"
#include "tools/shell/work_limits.hpp"

namespace waymark::tools {
namespace {

struct AutomatonOptions {
  std::string file = "-";
  AutomatonRequest request;
  OutputOptions output;
  WorkLimits limits;
};

Reply reply_to(automata::HoaAutomaton file, const std::string& source, std::size_t number,
               const AutomatonOptions& options, automata::Budget& budget, const std::stop_token& stop) {
  Shown about{.line = number, .text = file.name, .name = file.name, .unicode_name = file.name, .stop = stop};
  AnyAutomaton any = understood(std::move(file), source, budget);
  about.semantics = std::holds_alternative<automata::Dfa>(any) ? "finite" : "infinite";
  const AutomatonRequest& request = options.request;
  any = transformed(std::move(any), request, budget, about);
  if (request.changes_language()) about.name = about.unicode_name = "";
  if (!request.satisfies.empty()) return satisfies(any, request, budget, stop);
  if (request.asks()) return asked_of(any, request, budget);
  if (request.kind == "ldba" && std::holds_alternative<automata::Automaton>(any))
    return show(automata::limit_deterministic(*automata::Dpa::checked(std::get<automata::Automaton>(any))), about,
                options.output);
  return std::visit([&](const auto& automaton) { return show(automaton, about, options.output); }, any);
}

// A limit ends one automaton of the stream; a wrong one ends all.
Reply limited_reply(automata::HoaAutomaton file, const std::string& source, std::size_t number,
                    const AutomatonOptions& options, const Session& session) {
  const ltl::Watch watch(granted(options.limits), session.stop);
  automata::Budget budget(SIZE_MAX, options.request.states, watch.token());
  try {
    return reply_to(std::move(file), source, number, options, budget, watch.token());
  } catch (const GaveUp&) {  // the drawing
    if (watch.overrun() == ltl::Overrun::None) throw;
    throw GaveUp(gave_up(watch.overrun(), options.limits));
  } catch (const automata::Budget::Exceeded& spent) {
    if (session.stop.stop_requested()) throw Interrupted();
    const std::string reason = spent.reason == automata::Budget::Exceeded::Reason::Stopped
                                   ? gave_up(watch.overrun(), options.limits)
                                   : "gave up: too many states or acceptance sets";
    return {ExitCode::GaveUp, show_none({.line = number, .status = "limit"}, reason, options.output), reason};
  }
}

// Automata as they stand in the file; a single one as often as the other files want it.
class Stream {
 public:
  Stream(const std::string& text, const std::string& source, std::size_t others)
      : reader_(text, source), others_(others) {
    ahead_ = reader_.next();
    if (others_ > 1 && ahead_) {
      auto second = reader_.next();
      if (!second) return;
      waiting_.push_back(std::move(*second));
      is_stream_ = true;
    }
  }

  bool is_stream() const { return is_stream_; }
  std::optional<automata::HoaAutomaton> next() {
    if (others_ > 1 && !is_stream_) return ++given_ <= others_ ? ahead_ : std::nullopt;
    if (ahead_) return std::exchange(ahead_, std::nullopt);
    if (!waiting_.empty()) {
      automata::HoaAutomaton second = std::move(waiting_.back());
      waiting_.pop_back();
      return second;
    }
    auto next = reader_.next();
    if (next) is_stream_ = true;
    return next;
  }

 private:
  automata::HoaReader reader_;
  std::size_t others_, given_ = 0;
  std::optional<automata::HoaAutomaton> ahead_;
  std::vector<automata::HoaAutomaton> waiting_;
  bool is_stream_ = false;
};

ExitCode run_automaton(AutomatonOptions options, const Session& session) {
  const std::string text = read_file(options.file), source = source_name(options.file);
  const OtherAutomata others(options.request.files());
  options.request.others = &others;
  options.request.json = options.output.format == "json";
  Stream stream(text, source, others.count());
  ExitCode worst = ExitCode::Done;
  std::size_t number = 0;
  std::string headed = options.request.asks() || !options.request.satisfies.empty() ? "" : heading(options.output);
  while (std::optional<automata::HoaAutomaton> file = stream.next()) {
    options.request.number = ++number;
    options.request.is_stream = stream.is_stream();
    if (number > 1 && !options.output.svg.empty()) throw UsageError("--svg is for a single automaton");
    if (file->aborted) {
      complain("warning", "automaton " + std::to_string(number) + " was aborted by its writer");
      continue;
    }
    const Reply reply = limited_reply(*std::move(file), source, number, options, session);
    if (!reply.problem.empty()) complain("error", reply.problem);
    if (!reply.text.empty()) std::cout << std::exchange(headed, "");
    std::cout << reply.text << std::flush;
    worst = worse(worst, reply.code);
  }
  if (number == 0) throw ltl::FormatError(source, 1, 1, "expected 'HOA: v1' at the beginning");
  if (others.count() > number)
    throw ltl::FormatError(source, 0, 0,
                           "holds " + std::to_string(number) + " automata, another file " +
                               std::to_string(others.count()) + ": one of them must hold one, or both as many");
  return worst;
}

}  // namespace

Runner setup_automaton(Command command) {
  const auto options = std::make_shared<AutomatonOptions>();
  AutomatonRequest& request = options->request;
  command.add_option("file", options->file, "HOA, a stream of automata (-: standard input)").type_name("FILE");
  const auto file_option = [&](const char* name, std::string& path, const char* help) {
    command.add_option(name, path, help).type_name("FILE");
  };
  command.add_flag("--complement", request.complement, "the words that are rejected");
  file_option("--product", request.product, "the words that both accept");
  file_option("--union", request.either, "the words that one of them accepts");
  file_option("--difference", request.difference, "without the words of that one");
  command.add_flag("--minimize", request.minimize, "DFAs: the minimal one; others: reduced");
  command.add_flag("--reduce", request.reduce, "smaller, without a promise");
  command.add_flag("--empty", request.empty, "is no word accepted? 10 and a word if one is");
  command.add_flag("--universal", request.universal, "is every word accepted? 10 and a word if one is not");
  file_option("--equivalent", request.equivalent, "do both accept the same words? 10 and a word if not");
  file_option("--included", request.included, "does that one accept all words of this one? 10 and a word if not");
  command
      .add_option("--satisfies", request.satisfies, "do all words accepted satisfy this formula? 10 and a word if not")
      .type_name("FORMULA");
  add_output_options(command, options->output);
  command
      .add_option_function(
          "--to",
          [options](const std::string& what) {
            const bool is_kind = what == "dfa" || what == "tgba" || what == "buchi" || what == "parity" ||
                                 what == "rabin" || what == "ldba" || what == "generic";
            (is_kind ? options->request.kind : options->output.format) = what;
          },
          "the kind of automaton to make of it (dfa: of infinite words the good prefixes); or the same as --format")
      .one_of({"dfa", "tgba", "buchi", "parity", "rabin", "ldba", "generic", "hoa", "dot", "stats", "json", "tsv",
               "never", "lbtt", "ba"});
  command.add_option("--limit-states", request.states, "give up beyond so many states").type_name("N");
  add_work_limits(command, options->limits, "an automaton");
  return [options](const Session& session) {
    options->request.source = options->file;
    return run_automaton(*options, session);
  };
}

}  // namespace waymark::tools

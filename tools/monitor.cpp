// waymark monitor: verdicts about formulas while the letters of a word come in.
#include <cstdint>
#include <fstream>
#include <iostream>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <tuple>
#include <unordered_map>
#include <utility>
#include <variant>
#include <vector>

#include "libautomata/monitor/conjunction.hpp"
#include "libltl/diagnostic.hpp"
#include "libltl/english/verbalise.hpp"
#include "libltl/limits.hpp"
#include "libltl/meaning/progress.hpp"
#include "libltl/rewriting/simplify.hpp"
#include "libltl/text/print.hpp"
#include "libltl/text/read_text.hpp"
#include "libplan/world/letter_source.hpp"
#include "tools/answer.hpp"
#include "tools/shell/input.hpp"
#include "tools/shell/options.hpp"
#include "tools/shell/subcommand.hpp"

namespace waymark::tools {
namespace {

struct MonitorOptions {
  TextOptions text;
  NotationOptions notation;
  std::string letters = "-", format = "auto", semantics = "infinite";
  double time_unit = 0;  // 0: rows are steps
  std::size_t states = ltl::Limits{}.states;
  bool quiet = false, json = false;
};

const char* word_for(automata::Foresight foresight) {
  if (foresight == automata::Foresight::Open) return "open";
  return foresight == automata::Foresight::True ? "yes" : "no";
}

template <class Value>
Value within(std::variant<Value, automata::Exhausted> made, const Session& session) {
  if (auto* value = std::get_if<Value>(&made)) return std::move(*value);
  if (session.stop.stop_requested()) throw Interrupted();
  throw GaveUp("the monitor has more states than the limit");
}

class Watched {
 public:
  Watched(ltl::Formula f, std::string typed, const MonitorOptions& options, const Session& session)
      : typed_(std::move(typed)),
        words_(options.semantics == "infinite" ? automata::Words::Infinite : automata::Words::Finite),
        formula_(f),
        rest_(f),
        rests_(automata::conjuncts(f)),
        monitor_(monitor(options, session)) {}

  // Another word.
  void begin(const MonitorOptions& options, const Session& session) {
    last = {};
    rest_ = formula_;
    rests_ = automata::conjuncts(formula_);
    monitor_ = monitor(options, session);
  }

  automata::MonitorVerdict read(const ltl::Letter& letter) { return monitor_.read(letter); }

  // What remains. Steps are remembered by the place of the letter, until `forget`.
  ltl::Formula progressed(const ltl::Letter& letter) {
    const std::pair<std::uint32_t, const ltl::Letter*> step{rest_.id(), &letter};
    if (rests_.size() <= few_parts)
      if (const auto known = steps_.find(step); known != steps_.end()) return rest_ = known->second;
    rest_ = simplified(letter);
    constexpr std::size_t most = 100'000;
    if (steps_.size() >= most) forget();
    steps_.insert_or_assign(step, rest_);
    return rest_;
  }
  void forget() {
    steps_.clear();
    steps_of_parts_.clear();
    lines_.clear();
  }

  // What is printed behind the number of letters. Remembered until `forget`: few rests come again and again.
  template <class Line>
  const std::string& line(std::optional<ltl::Formula> rest, Line&& of) {
    const Key key(rest ? std::optional(rest->id()) : std::nullopt, last.foresight, last.now, last.is_known_satisfiable);
    const auto known = lines_.find(key);
    return known != lines_.end() ? known->second : lines_.emplace(key, of()).first->second;
  }
  ltl::Semantics semantics() const {
    return words_ == automata::Words::Infinite ? ltl::Semantics::Infinite : ltl::Semantics::Finite;
  }

  void move_to(ltl::Arena& arena) {
    forget();
    formula_ = ltl::transfer(formula_, arena);
    rest_ = ltl::transfer(rest_, arena);
    for (ltl::Formula& part : rests_) part = ltl::transfer(part, arena);
  }
  const std::string& typed() const { return typed_; }
  automata::MonitorVerdict last = {};

 private:
  using Key = std::tuple<std::optional<std::uint32_t>, automata::Foresight, std::optional<bool>, bool>;
  automata::ConjunctionMonitor monitor(const MonitorOptions& options, const Session& session) const {
    return within(automata::ConjunctionMonitor::of(formula_, words_, {.states = options.states, .stop = session.stop}),
                  session);
  }

  static constexpr std::size_t few_parts = 8;  // that are simplified together

  ltl::Formula simplified(const ltl::Letter& letter) {
    if (rests_.size() <= few_parts) return simplified(rest_, letter);
    for (ltl::Formula& part : rests_) part = step(part, letter);
    return ltl::conjunction(formula_.arena(), rests_);
  }
  ltl::Formula step(ltl::Formula part, const ltl::Letter& letter) {
    const std::pair<std::uint32_t, const ltl::Letter*> key{part.id(), &letter};
    const auto known = steps_of_parts_.find(key);
    return known != steps_of_parts_.end() ? known->second
                                          : steps_of_parts_.emplace(key, simplified(part, letter)).first->second;
  }
  ltl::Formula simplified(ltl::Formula f, const ltl::Letter& letter) const {
    const bool infinite = semantics() == ltl::Semantics::Infinite;
    return ltl::simplify(ltl::progress(f, letter, semantics()), infinite ? ltl::Over::Infinite : ltl::Over::Rest);
  }

  std::string typed_;  // the formula
  automata::Words words_;
  ltl::Formula formula_, rest_;
  std::vector<ltl::Formula> rests_;  // of the conjuncts, where they are many
  automata::ConjunctionMonitor monitor_;
  std::map<std::pair<std::uint32_t, const ltl::Letter*>, ltl::Formula> steps_, steps_of_parts_;
  std::map<Key, std::string> lines_;
};

class Monitoring {
 public:
  Monitoring(const MonitorOptions& options, const Session& session) : options_(options), session_(session) {
    TextReader texts(options.text, "formula");
    std::vector<std::pair<ltl::Formula, std::string>> formulas;
    while (const std::optional<Text> text = texts.next()) {
      const ltl::Formula f = parse_formula(*text, *arena_, parse_options(options.notation, ltl::Unknown::Add));
      formulas.emplace_back(f, as_typed(*text, f, options.notation));
    }
    if (formulas.empty()) throw ltl::FormatError(texts.source(), 0, 0, "there is no formula");
    for (const auto& [f, typed] : formulas) watched_.emplace_back(f, typed, options, session);
  }

  ExitCode run() {
    std::ifstream file;
    if (options_.letters != "-") {
      file.open(options_.letters);
      if (!file) throw ltl::FormatError(options_.letters, 0, 0, "cannot read the file");
    }
    std::istream& in = options_.letters == "-" ? std::cin : file;
    const std::string source = source_name(options_.letters);
    const plan::LetterFormat format = letter_format(options_.format);
    plan::LetterOptions read_as{.format = format, .wanted = arena_->vocabulary()};
    if (options_.time_unit > 0) read_as.time_unit = options_.time_unit;
    plan::LetterLines lines(plan::LetterLines::Forgetful{std::move(read_as)}, source);
    ltl::LineReader texts(in, source);
    plan::LetterSource from(lines, format, source, [&](std::string& line) { return texts.next(line); });
    for (std::string line; from.next(line);) {
      if (session_.stop.stop_requested()) throw Interrupted();
      if (plan::LetterLines::separates(line)) {
        end_trace();
        begin_trace(lines);
        continue;
      }
      for (const ltl::Letter& letter : letters_of(line, lines)) read(letter);
      if (in.rdbuf()->in_avail() <= 0) std::cout.flush();  // nothing more is there yet
    }
    if (position_ > 0 || trace_ == 1) end_trace();
    const auto condition = lines.uncompared();
    if (condition && !seen_.contains(*arena_->vocabulary().find(*condition)))
      throw ltl::FormatError(source, 0, 0, "no letter has a value to compare in \"" + *condition + '"');
    if (lines.has_time() && options_.time_unit == 0) std::cerr << note_of_time;
    return worst_;
  }

 private:
  // Lines come again and again: some thousands are remembered, once the format is settled.
  const std::vector<ltl::Letter>& letters_of(const std::string& line, plan::LetterLines& lines) {
    constexpr std::size_t most = 4096;
    if (const auto known = known_.find(line); known != known_.end()) {
      lines.pass_over();
      return known->second;
    }
    if (known_.size() >= most) {
      known_.clear();
      for (Watched& watched : watched_) watched.forget();
    }
    std::vector<ltl::Letter> letters = lines.read(line);
    for (const ltl::Letter& letter : letters) seen_.insert_all(letter);
    if (options_.time_unit > 0) return timed_ = std::move(letters);  // how many depends on the row before
    if (!letters.empty()) return known_.insert_or_assign(line, std::move(letters)).first->second;
    return no_letters_;
  }

  // Formulas that nothing needs any more are left behind.
  void renew_arena() {
    auto fresh = std::make_unique<ltl::Arena>(arena_->vocabulary());
    for (Watched& watched : watched_) watched.move_to(*fresh);
    arena_ = std::move(fresh);
  }

  void read(const ltl::Letter& letter) {
    constexpr std::size_t most_formulas = 200'000;
    if (arena_->size() > most_formulas) renew_arena();
    if (++position_ == 1 && trace_ > 1 && !options_.json) std::cout << "-- trace " << trace_ << '\n';
    for (Watched& watched : watched_) {
      const automata::MonitorVerdict verdict = watched.read(letter);
      const bool changed = verdict.foresight != watched.last.foresight ||
                           verdict.is_known_satisfiable != watched.last.is_known_satisfiable;
      watched.last = verdict;
      if (!options_.quiet)
        show(watched, watched.progressed(letter));
      else if (changed)
        show(watched, std::nullopt);
    }
  }

  void begin_trace(plan::LetterLines& lines) {
    lines.begin_trace();
    known_.clear();  // what was a row may be the header, which is repeated
    ++trace_;
    position_ = 0;
    for (Watched& watched : watched_) watched.begin(options_, session_);
  }

  void end_trace() {
    if (position_ == 0)
      throw ltl::FormatError(source_name(options_.letters), 0, 0, "there are no letters; the empty letter is {}");
    if (options_.quiet) show_all();
    worst_ = worse(worst_, verdict());
  }

  void show_all() {
    for (Watched& watched : watched_)
      if (watched.last.foresight == automata::Foresight::Open) show(watched, std::nullopt);
  }

  void show(Watched& watched, std::optional<ltl::Formula> rest) const {
    const std::string& line =
        watched.line(rest, [&] { return options_.json ? json(watched, rest) : text(watched, rest); });
    if (options_.json && trace_ > 1) std::cout << "{\"trace\":" << trace_ << ",\"letters\":" << position_ << line;
    if (options_.json && trace_ == 1) std::cout << "{\"letters\":" << position_ << line;
    if (!options_.json) std::cout << position_ << line;
  }

  static std::string english(const Watched& watched, ltl::Formula rest) {
    if (rest.op() == ltl::Op::True) return "nothing more is asked";
    if (rest.op() == ltl::Op::False) return "nothing can satisfy it any more";
    return ltl::verbalise(rest, {watched.semantics()});
  }

  // Without the beginning of the object, which has the number of letters.
  static std::string json(const Watched& watched, std::optional<ltl::Formula> rest) {
    JsonObject json;
    json.add("formula", watched.typed()).add("verdict", word_for(watched.last.foresight));
    if (watched.last.now) json.add("now", *watched.last.now);
    if (!watched.last.is_known_satisfiable) json.add("known_satisfiable", false);
    if (rest) json.add("remains", ltl::print(*rest)).add("english", english(watched, *rest));
    return ',' + json.text().substr(1) + '\n';
  }

  std::string text(const Watched& watched, std::optional<ltl::Formula> rest) const {
    const automata::MonitorVerdict& verdict = watched.last;
    std::string out = std::string("\t") + word_for(verdict.foresight);
    if (verdict.foresight == automata::Foresight::Open && verdict.now)
      out += *verdict.now ? ", holds now" : ", fails now";
    if (!verdict.is_known_satisfiable) out += ", not known to be satisfiable";
    if (watched_.size() > 1) out += '\t' + watched.typed();
    if (rest) out += '\t' + shown(*rest, session_.out) + '\t' + english(watched, *rest);
    return out + '\n';
  }

  // As of check: 10 when a formula is violated; over finite words when one does not hold at the end.
  ExitCode verdict() const {
    for (const Watched& watched : watched_)
      if (watched.last.foresight == automata::Foresight::False || watched.last.now == false) return ExitCode::No;
    return ExitCode::Done;
  }

  const MonitorOptions& options_;
  const Session& session_;
  std::unique_ptr<ltl::Arena> arena_ = std::make_unique<ltl::Arena>();
  std::vector<Watched> watched_;
  std::unordered_map<std::string, std::vector<ltl::Letter>> known_;
  const std::vector<ltl::Letter> no_letters_;
  std::vector<ltl::Letter> timed_;
  ltl::Letter seen_;  // what some letter had
  std::size_t position_ = 0, trace_ = 1;
  ExitCode worst_ = ExitCode::Done;
};

ExitCode run_monitor(const MonitorOptions& options, const Session& session) {
  const bool formulas_from_stdin = options.text.arguments.empty()
                                       ? options.text.file.empty() || options.text.file == "-"
                                       : options.text.arguments[0] == "-";
  if (formulas_from_stdin && options.letters == "-")
    throw UsageError("formulas and letters cannot both come from standard input");
  if (options.time_unit < 0) throw UsageError("--time-unit is a positive number");
  return Monitoring(options, session).run();
}

}  // namespace

Runner setup_monitor(Command command) {
  const auto options = std::make_shared<MonitorOptions>();
  add_text_options(command, options->text, "formula");
  add_notation_options(command, options->notation);
  command.add_option("--letters", options->letters, "the letters, line by line; - is standard input")
      .type_name("FILE")
      .show_default();
  add_letter_format_option(command, options->format);
  add_time_unit_option(command, options->time_unit);
  command.add_option("--semantics", options->semantics, "what words the formulas are read on")
      .one_of({"finite", "infinite"})
      .show_default();
  command.add_option("--limit-states", options->states, "give up beyond so many states of a monitor")
      .type_name("N")
      .show_default();
  command.add_flag("--quiet", options->quiet, "print changes of a verdict alone, and what is open in the end");
  command.add_flag("--json", options->json, "one JSON object a line");
  return [options](const Session& session) { return run_monitor(*options, session); };
}

}  // namespace waymark::tools

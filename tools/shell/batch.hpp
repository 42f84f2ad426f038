// A batch of texts, each answered in order: an error in one text is reported, and the others are still answered.
#pragma once
#include <functional>
#include <iosfwd>
#include <stop_token>
#include <string>

#include "tools/shell/exit_code.hpp"
#include "tools/shell/input.hpp"
#include "tools/shell/json.hpp"
#include "tools/shell/parallel.hpp"
#include "tools/shell/subcommand.hpp"

namespace waymark::tools {

// One line of a batch of JSON answers for a text that is not well formed.
JsonObject json_error(std::size_t line, const std::string& message);

// Answers every text in order and flushes standard output after each. When there are several (or they come from a
// file), ltl::SyntaxError and ltl::FormatError end one text only: the message goes to standard error, with `json`
// json_error to standard output, and the batch ends with ExitCode::BadInput. Otherwise the worst verdict.
// Throws Interrupted between texts when a stop was requested, ltl::FormatError when there was no text at all.
ExitCode answer_each(TextReader& texts, const std::stop_token& stop, const std::function<ExitCode(const Text&)>& answer,
                     bool json = false);

// What the answer to a text is written to: standard output and standard error, or what stands for them until it is the
// text's turn.
struct TextStreams {
  std::ostream& out;
  std::ostream& notes;
};
// Runs the work; where it gives up because a limit was met, GaveUp says which one.
template <class Work>
ExitCode within(const TextWatch& watch, const WorkLimits& limits, const Work& work) {
  try {
    return work();
  } catch (const GaveUp&) {
    if (watch.overrun() == ltl::Overrun::None) throw;
    throw GaveUp(gave_up(watch.overrun(), limits));
  }
}

using TextAnswer = std::function<ExitCode(const Text&, const Session&, const TextStreams&)>;
// The same by several threads, in the order of the texts; `answer` gets a session that also ends when a limit is met.
// In a batch GaveUp ends one text only, too. The answer to a single text is written as it comes.
ExitCode answer_each(TextReader& texts, const Session& session, const ParallelOptions& options,
                     const TextAnswer& answer, bool json = false);

}  // namespace waymark::tools

#include "tools/shell/batch.hpp"

#include <iostream>
#include <optional>
#include <sstream>

#include "libltl/diagnostic.hpp"
#include "tools/shell/terminal.hpp"

namespace waymark::tools {
namespace {

// The message when the text was bad.
std::optional<std::string> attempt(const std::function<ExitCode(const Text&)>& answer, const Text& text,
                                   ExitCode& code) {
  try {
    code = answer(text);
    return std::nullopt;
  } catch (const ltl::SyntaxError& error) {
    return error.what();
  } catch (const ltl::FormatError& error) {
    return error.what();
  }
}

// The answer to one text of a batch, kept until it is its turn.
Reply kept(const Text& text, const TextWatch& watch, const Session& session, const WorkLimits& limits,
           const TextAnswer& answer, bool json) {
  std::ostringstream out, notes;
  try {
    const auto answered = [&] { return answer(text, {watch.token(), session.out}, {out, notes}); };
    const ExitCode code = within(watch, limits, answered);
    return {code, out.str(), "", notes.str()};
  } catch (const GaveUp& error) {
    const JsonObject told = JsonObject().add("line", text.line).add("status", "exhausted").add("message", error.what());
    return {ExitCode::GaveUp, json ? told.text() + '\n' : "", std::to_string(text.line) + ": " + error.what(),
            notes.str()};
  }
}

}  // namespace

JsonObject json_error(std::size_t line, const std::string& message) {
  return JsonObject().add("line", line).add("status", "error").add("message", message);
}

ExitCode answer_each(TextReader& texts, const std::stop_token& stop, const std::function<ExitCode(const Text&)>& answer,
                     bool json) {
  ExitCode worst = ExitCode::Done;
  bool any = false;
  while (const std::optional<Text> text = texts.next()) {
    if (stop.stop_requested()) throw Interrupted();
    any = true;
    ExitCode code = ExitCode::BadInput;
    if (!texts.is_batch()) {
      code = answer(*text);
    } else if (const auto message = attempt(answer, *text, code)) {
      complain("error", *message);
      if (json) std::cout << json_error(text->line, *message).text() << '\n';
    }
    worst = worse(worst, code);
    std::cout.flush();
  }
  if (!any) throw ltl::FormatError(texts.source(), 0, 0, "there is nothing to read");
  return worst;
}

ExitCode answer_each(TextReader& texts, const Session& session, const ParallelOptions& options,
                     const TextAnswer& answer, bool json) {
  const auto alone = [&](const Text& text, const TextWatch& watch) -> Reply {
    return {within(watch, options.limits, [&] {
      return answer(text, {watch.token(), session.out}, {std::cout, std::cerr});
    })};
  };
  const auto of_batch = [&](const Text& text, const TextWatch& watch) {
    return kept(text, watch, session, options.limits, answer, json);
  };
  return answer_in_parallel(texts, session.stop, options, texts.is_batch() ? Replier(of_batch) : Replier(alone),
                            [&](const Text& text, const std::string& message) {
                              return json ? json_error(text.line, message).text() + '\n' : std::string();
                            });
}

}  // namespace waymark::tools

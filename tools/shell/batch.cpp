#include "tools/shell/batch.hpp"

#include <iostream>
#include <optional>

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

}  // namespace waymark::tools

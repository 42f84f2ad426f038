// A batch of texts, each answered in order: an error in one text is reported, and the others are still answered.
#pragma once
#include <functional>
#include <stop_token>
#include <string>

#include "tools/shell/exit_code.hpp"
#include "tools/shell/input.hpp"
#include "tools/shell/json.hpp"

namespace waymark::tools {

// One line of a batch of JSON answers for a text that is not well formed.
JsonObject json_error(std::size_t line, const std::string& message);

// Answers every text in order and flushes standard output after each. When there are several (or they come from a
// file), ltl::SyntaxError and ltl::FormatError end one text only: the message goes to standard error, with `json`
// json_error to standard output, and the batch ends with ExitCode::BadInput. Otherwise the worst verdict.
// Throws Interrupted between texts when a stop was requested, ltl::FormatError when there was no text at all.
ExitCode answer_each(TextReader& texts, const std::stop_token& stop, const std::function<ExitCode(const Text&)>& answer,
                     bool json = false);

}  // namespace waymark::tools

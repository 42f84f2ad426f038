// What is said of the answer to a task of a planning case: in words, as JSON, as an exit code.
#pragma once
#include <string>

#include "libplan/solve/case_task.hpp"
#include "tools/shell/exit_code.hpp"
#include "tools/shell/json.hpp"
#include "tools/shell/reply.hpp"

namespace waymark::tools {

ExitCode exit_code(plan::CaseAnswer::Status status);
// A line with its exit code. `model`: as below.
Reply told(const std::string& model, const plan::CaseTask& task, const plan::CaseAnswer& answer, bool json);
// `model`: the name of the case or model.
JsonObject case_json(const std::string& model, const plan::CaseTask& task, const plan::CaseAnswer& answer);
// A row of a table, or two lines for a task without a name.
std::string in_words(const plan::CaseTask& task, const plan::CaseAnswer& answer);

}  // namespace waymark::tools

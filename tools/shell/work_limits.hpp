// --limit-seconds and --limit-memory: what a command may take for each piece of its work.
#pragma once
#include <cstddef>
#include <string>

#include "libltl/watch.hpp"
#include "tools/shell/command.hpp"

namespace waymark::tools {

struct WorkLimits {
  double seconds = 0;         // 0: any
  std::size_t mebibytes = 0;  // that the process holds, all its threads together; 0: any
};

// What a piece of work that begins now may take. Gives freed memory back to the system where memory is limited: what
// an earlier piece held is not held against it.
ltl::Allowance granted(const WorkLimits& limits);

// `what` is limited, in words: "a formula". `seconds` is the option's name, others behind commas.
void add_work_limits(Command command, WorkLimits& limits, const std::string& what,
                     const std::string& seconds = "--limit-seconds");

std::string amount(ltl::Overrun overrun, const WorkLimits& limits);  // of what was met: "1.0 s", "100 MiB"

// "gave up after 1.0 s", "gave up: the process held more than 100 MiB"; `took`: seconds, of work that was late.
std::string gave_up(ltl::Overrun overrun, const WorkLimits& limits, double took = 0);

}  // namespace waymark::tools

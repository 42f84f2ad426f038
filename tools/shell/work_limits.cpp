#include "tools/shell/work_limits.hpp"

#include <malloc.h>

#include <algorithm>
#include <stdexcept>

#include "tools/shell/terminal.hpp"

namespace waymark::tools {

void add_work_limits(Command command, WorkLimits& limits, const std::string& what, const std::string& seconds) {
  command.add_option(seconds, limits.seconds, "give up on " + what + " after so many seconds (0: never)")
      .type_name("SECONDS")
      .not_negative()
      .show_default();
  command
      .add_option("--limit-memory", limits.mebibytes,
                  "give up on " + what + " when the process holds so many MiB (0: never)")
      .type_name("MIB")
      .between(0, 1 << 30)
      .show_default();
}

ltl::Allowance granted(const WorkLimits& limits) {
  if (limits.mebibytes > 0) ::malloc_trim(0);
  return {.seconds = limits.seconds, .bytes = limits.mebibytes << 20U};
}

std::string amount(ltl::Overrun overrun, const WorkLimits& limits) {
  switch (overrun) {
    case ltl::Overrun::None: break;
    case ltl::Overrun::Time: return fixed(limits.seconds, 1) + " s";
    case ltl::Overrun::Memory: return std::to_string(limits.mebibytes) + " MiB";
  }
  throw std::logic_error("no limit was met");
}

std::string gave_up(ltl::Overrun overrun, const WorkLimits& limits, double took) {
  if (overrun == ltl::Overrun::Time) return "gave up after " + fixed(std::max(took, limits.seconds), 1) + " s";
  return "gave up: the process held more than " + amount(overrun, limits);
}

}  // namespace waymark::tools

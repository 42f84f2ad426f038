// The exit codes of waymark: one verdict per block, the same for every subcommand (docs/cli.md).
#pragma once
#include <stdexcept>

namespace waymark::tools {

enum class ExitCode : int {
  Done = 0,
  No = 10,              // the answer is no: infeasible, not satisfied, unsatisfiable (proved)
  GaveUp = 11,          // nothing proved: a limit was met, or Ctrl-C
  NotUnderstood = 12,   // words that ask for nothing that could be read
  PartlyVerified = 13,  // `verify`: no claim is false, and one or more were not examined
  Usage = 20,           // the command line is wrong
  BadInput = 21,        // a formula, map, pose, file … is wrong; a batch with some bad lines ends with this
  OurBug = 30,
};

// The worse of two verdicts of one batch: what the batch as a whole ends with.
// The greater code, but a "no" is worse than what was not examined.
inline ExitCode worse(ExitCode a, ExitCode b) {
  const auto rank = [](ExitCode code) { return code == ExitCode::PartlyVerified ? 1 : static_cast<int>(code); };
  return rank(a) < rank(b) ? b : a;
}

class UsageError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

// A limit was met before anything was proved.
class GaveUp : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

// Thrown where work noticed that a stop was requested and has nothing to show for it.
class Interrupted : public GaveUp {
 public:
  Interrupted() : GaveUp("interrupted") {}
};

}  // namespace waymark::tools

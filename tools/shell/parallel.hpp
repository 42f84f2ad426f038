// A batch of texts answered in parallel: replies are printed in the order of the texts, each one as soon as all before
// it are printed. An error in one text is reported, and the others are still answered.
#pragma once
#include <cstddef>
#include <functional>
#include <stop_token>
#include <string>

#include "tools/shell/exit_code.hpp"
#include "tools/shell/input.hpp"
#include "tools/shell/work_limits.hpp"

namespace waymark::tools {

struct Reply {
  ExitCode code = ExitCode::Done;
  std::string text = {};     // for standard output
  std::string problem = {};  // for standard error, before the text; none when empty
  std::string notes = {};    // for standard error as they are, before both
};

class TextWatch {  // over what one text may take; as ltl::Watch
 public:
  virtual ~TextWatch() = default;
  virtual std::stop_token token() const = 0;
  virtual ltl::Overrun overrun() const = 0;
};

using Replier = std::function<Reply(const Text&, const TextWatch&)>;
// What stands in the place of the answer to a bad text, on standard output.
using BadTextReply = std::function<std::string(const Text&, const std::string& message)>;

struct ParallelOptions {
  std::size_t threads = 0;  // 0: one for each core
  WorkLimits limits = {};   // of each text; memory: of the text that was begun first gives up first
};

// The worst code of all replies, BadInput when a text of a batch was bad: ltl::SyntaxError and ltl::FormatError end one
// text of a batch only. Any other exception ends everything, and is thrown here. Throws Interrupted when a stop was
// requested, ltl::FormatError when there was no text at all. At most `threads` · 256 replies wait for their worker.
ExitCode answer_in_parallel(TextReader& texts, const std::stop_token& stop, const ParallelOptions& options,
                            const Replier& answer, const BadTextReply& bad);

using JobReplier = std::function<Reply(std::size_t job, const TextWatch&)>;
// The same of jobs 0, 1, …: the worst code of their replies, Done without any. Every exception ends everything.
ExitCode answer_in_parallel(std::size_t jobs, const std::stop_token& stop, const ParallelOptions& options,
                            const JobReplier& answer);

}  // namespace waymark::tools

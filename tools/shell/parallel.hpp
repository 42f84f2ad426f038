// A batch of texts answered in parallel: replies are printed in the order of the texts, each one as soon as all before
// it are printed. An error in one text is reported, and the others are still answered.
#pragma once
#include <cstddef>
#include <functional>
#include <stop_token>
#include <string>

#include "tools/shell/dealt_texts.hpp"
#include "tools/shell/input.hpp"
#include "tools/shell/reply.hpp"
#include "tools/shell/work_limits.hpp"

namespace waymark::tools {

class TextWatch {  // over what one text may take; as ltl::Watch
 public:
  virtual ~TextWatch() = default;
  virtual std::stop_token token() const = 0;
  virtual ltl::Overrun overrun() const = 0;
};

using Replier = std::function<Reply(const Text&, const TextWatch&)>;

struct ParallelOptions {
  std::size_t threads = 0;  // 0: one for each core; of a rank: one
  WorkLimits limits = {};   // of each text; memory: of the text that was begun first gives up first
  DealOptions deal = {};
  std::function<std::string()> settings = {};  // what replies depend on beside their texts, asked for to keep them
};

// The worst code of all replies, BadInput when a text of a batch was bad: ltl::SyntaxError and ltl::FormatError end one
// text of a batch only. Any other exception ends everything, and is thrown here. Throws Interrupted when a stop was
// requested, ltl::FormatError when there was no text at all. At most `threads` · 256 replies wait for their worker.
//
// A process that has a seat in a farm (seat.hpp) gives the texts of a batch out to others, or answers what it is given:
// who calls this need not know.
ExitCode answer_in_parallel(TextReader& texts, const std::stop_token& stop, const ParallelOptions& options,
                            const Replier& answer, const BadTextReply& bad);

using JobReplier = std::function<Reply(std::size_t job, const TextWatch&)>;
// The same of jobs 0, 1, …: the worst code of their replies, Done without any. Every exception ends everything.
ExitCode answer_in_parallel(std::size_t jobs, const std::stop_token& stop, const ParallelOptions& options,
                            const JobReplier& answer);

}  // namespace waymark::tools

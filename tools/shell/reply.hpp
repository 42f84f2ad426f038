// The answer to one text of a batch.
#pragma once
#include <functional>
#include <string>

#include "tools/shell/exit_code.hpp"
#include "tools/shell/input.hpp"
#include "tools/shell/packed.hpp"

namespace waymark::tools {

struct Reply {
  ExitCode code = ExitCode::Done;
  std::string text = {};     // for standard output
  std::string problem = {};  // for standard error, before the text; none when empty
  std::string notes = {};    // for standard error as they are, before both
};

void pack(Packed& message, const Reply& reply);
Reply unpack_reply(Unpacked& message);

// What stands in the place of the answer to a bad text, on standard output.
using BadTextReply = std::function<std::string(const Text&, const std::string& message)>;

// Prints replies in the order in which they are put.
class ReplyOutput {
 public:
  void put(const Reply& reply);
  static void flush();                       // so that all that was put can be read
  ExitCode worst() const { return worst_; }  // of all that were put

 private:
  ExitCode worst_ = ExitCode::Done;
};

}  // namespace waymark::tools

#include "tools/shell/reply.hpp"

#include <iostream>

#include "tools/shell/terminal.hpp"

namespace waymark::tools {

void pack(Packed& message, const Reply& reply) {
  message.number(static_cast<std::uint64_t>(reply.code)).text(reply.text).text(reply.problem).text(reply.notes);
}

Reply unpack_reply(Unpacked& message) {
  Reply reply{.code = static_cast<ExitCode>(message.number())};
  reply.text = message.text();
  reply.problem = message.text();
  reply.notes = message.text();
  return reply;
}

void ReplyOutput::put(const Reply& reply) {
  if (!reply.problem.empty() || !reply.notes.empty()) flush();
  std::cerr << reply.notes;
  if (!reply.problem.empty()) complain("error", reply.problem);
  std::cout << reply.text;
  worst_ = worse(worst_, reply.code);
}

void ReplyOutput::flush() { std::cout.flush(); }

}  // namespace waymark::tools

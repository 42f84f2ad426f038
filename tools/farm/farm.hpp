// A farm of ranks: what each rank does until the work is done.
//
// Two kinds of work are shared. Of a batch of texts, rank 0 starts a giver, and every rank a hand; rank 0 carries
// chunks from the giver to the hands and replies back. Of an experiment, every rank starts the same command, and the
// commands share the work out in their folder of checkpoints; rank 0 shows what its own prints, when it has ended.
//
// Ranks say every second that they are there. Who is not heard of for five seconds is taken for killed; a rank that was
// only slow is taken back when it is heard of again.
#pragma once
#include <csignal>
#include <string>
#include <vector>

#include "tools/farm/post.hpp"

namespace waymark::tools {

struct FarmCommand {
  std::string program;                 // waymark
  std::vector<std::string> arguments;  // its subcommand, and so on
};

// Exit codes of this rank: of rank 0, that of the command. `stopped`: the signal that asks for an end; 0: none.
int share_texts(const FarmCommand& command, const boost::mpi::communicator& ranks,
                const volatile std::sig_atomic_t& stopped);
int share_checkpoints(const FarmCommand& command, const boost::mpi::communicator& ranks,
                      const volatile std::sig_atomic_t& stopped);

}  // namespace waymark::tools

// The seat of a process in a farm: waymark-farm starts processes of `waymark` and tells them in $WAYMARK_FARM what they
// are and by which pipes they speak to it.
//
// The giver reads the texts of the batch, gives them out in chunks and prints the replies in order. A hand answers what
// it is given. Messages are frames (packed.hpp) that begin with the number of the hand where several are meant:
//
//   giver → hand    chunk: its number, microseconds it may take, how many texts; of each line, source, text
//   hand → giver    replies: number of the chunk, is it over?, microseconds so far, how many replies, the replies. A
//                   chunk is over when it was answered, or when its time was: the rest is given anew
//   farm → giver    ready: a hand waits; lost: the hand at work on a chunk is no more; ended: a hand ended by itself
#pragma once
#include <cstdint>
#include <optional>

namespace waymark::tools {

struct Seat {
  enum class Role { Giver, Hand };
  Role role = Role::Giver;
  int in = -1, out = -1;  // pipes
};

enum class FarmNews : std::uint64_t {
  Ready,    // hand
  Replies,  // hand, then what the hand said
  Lost,     // hand, number of the chunk, signal (0: not heard of for a while)
  Ended,    // hand, exit code, standard error
  Gone,     // hand: it will not come back
};

// nullopt: none. Throws UsageError when the variable is not as waymark-farm sets it.
std::optional<Seat> taken_seat();

inline constexpr const char* seat_variable = "WAYMARK_FARM";  // "giver IN OUT", "hand IN OUT", "together"

}  // namespace waymark::tools

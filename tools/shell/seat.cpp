#include "tools/shell/seat.hpp"

#include <cstdlib>
#include <sstream>
#include <string>

#include "tools/shell/exit_code.hpp"

namespace waymark::tools {

std::optional<Seat> taken_seat() {
  const char* variable = std::getenv(seat_variable);
  if (variable == nullptr || *variable == '\0' || std::string(variable) == "together") return std::nullopt;
  std::istringstream words(variable);
  std::string role;
  Seat seat;
  if (!(words >> role >> seat.in >> seat.out) || (role != "giver" && role != "hand"))
    throw UsageError("the environment variable " + std::string(seat_variable) +
                     " is for waymark-farm to set, not for people: unset it");
  seat.role = role == "giver" ? Seat::Role::Giver : Seat::Role::Hand;
  return seat;
}

}  // namespace waymark::tools

// A request of the studio: a JSON object, whose members are asked for by name and checked when they are.
//
// A member of the wrong type, a text that is too long and a number out of bounds are errors of the request, and say
// which member is wrong.
#pragma once
#include <cstddef>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "libltl/formula.hpp"
#include "libplan/world/trajectory.hpp"

namespace waymark::studio {

// What is wrong with a request as such, and the HTTP status that says so.
class RequestError : public std::runtime_error {
 public:
  RequestError(int status, std::string kind, const std::string& message)
      : std::runtime_error(message), status_(status), kind_(std::move(kind)) {}
  int status() const { return status_; }
  const std::string& kind() const { return kind_; }

 private:
  int status_;
  std::string kind_;
};

inline constexpr std::size_t most_body = 1'048'576;  // bytes of a request
inline constexpr std::size_t most_values = 100'000;  // of its JSON: objects, arrays and what they hold
inline constexpr std::size_t most_levels = 100;      // of objects and arrays in one another
inline constexpr std::size_t most_text = 4'000;      // bytes of a formula or an instruction
inline constexpr std::size_t most_poses = 2'000;     // of a trajectory

// Throws RequestError where a text is beyond these bounds, before a tree is built: its nodes take up to a hundred times
// the memory of their text. What is no JSON passes.
void check_json_bounds(std::string_view json);

class Request {
 public:
  explicit Request(std::string_view body);  // throws RequestError

  bool has(const std::string& name) const;
  std::string text(const std::string& name) const;  // must be there
  std::string text_or(const std::string& name, const std::string& otherwise) const;
  std::string one_of(const std::string& name,
                     const std::vector<std::string>& values) const;  // else the first
  bool flag(const std::string& name) const;                          // else false
  double number_or(const std::string& name, double otherwise, double least, double most) const;
  std::size_t count_or(const std::string& name, std::size_t otherwise, std::size_t least, std::size_t most) const;
  // Poses [x, y, heading], each one action after the one before.
  plan::Trajectory trajectory(const std::string& name, const plan::Map& map) const;

 private:
  std::shared_ptr<const nlohmann::json> members_;
};

// The member "formula", over the propositions of the arena and no others. Throws ltl::SyntaxError, and RequestError
// where the formula is too large once its bounds are spelled out.
inline constexpr std::size_t most_formula = 20'000;  // nodes of its tree
ltl::Formula formula_of(const Request& request, ltl::Arena& arena);

}  // namespace waymark::studio

#include "libparser/domain/streets/street_directions.hpp"

#include <cmath>
#include <cstdlib>
#include <map>

#include "libparser/domain/streets/mentions.hpp"

namespace waymark::streets {
namespace {

struct Word {
  DirectionKind kind;
  double right, up;
};

const std::map<std::string, Word, std::less<>>& words() {
  using K = DirectionKind;
  static const std::map<std::string, Word, std::less<>> table = [] {
    std::map<std::string, Word, std::less<>> t;
    struct Half {
      const char* vertical;
      const char* letter;
      double up;
    };
    for (const Half& v : {Half{"north", "n", 1}, Half{"south", "s", -1}}) {
      for (const char* ending : {"", "ern", "ward", "wards", "erly", "bound"})
        t[v.vertical + std::string(ending)] = {K::Compass, 0, v.up};
      for (const auto& [side, letter, right] : {std::tuple{"east", "e", 1.0}, std::tuple{"west", "w", -1.0}}) {
        for (const char* ending : {"", "ern", "ward", "wards", "erly", "bound"}) {
          t[side + std::string(ending)] = {K::Compass, right, 0};
          t[v.vertical + std::string(side) + ending] = {K::Compass, right, v.up};
        }
        t[v.letter + std::string(letter)] = {K::Compass, right, v.up};
      }
    }
    for (const char* w : {"up", "upward", "upwards", "upper", "top"}) t[w] = {K::Vertical, 0, 1};
    for (const char* w : {"down", "downward", "downwards", "lower", "bottom"}) t[w] = {K::Vertical, 0, -1};
    t["right"] = t["rightward"] = {K::Side, 1, 0};
    t["left"] = t["leftward"] = {K::Side, -1, 0};
    return t;
  }();
  return table;
}

constexpr double degrees = 57.29577951308232;

std::optional<Direction> clock(const std::vector<std::string>& letters, std::size_t at) {
  // "2 oclock", "2 o clock", "2oclock"
  const auto says_clock = [&](std::size_t i) {
    return i < letters.size() && (letters[i] == "oclock" || letters[i] == "clock" ||
                                  (letters[i] == "o" && i + 1 < letters.size() && letters[i + 1] == "clock"));
  };
  const std::string& word = letters[at];
  std::size_t digits = 0;
  while (digits < word.size() && word[digits] >= '0' && word[digits] <= '9') ++digits;
  if (digits == 0 || digits > 2) return std::nullopt;
  const std::string rest = word.substr(digits);
  if (!(rest.empty() ? says_clock(at + 1) : rest == "oclock" || rest == "o")) return std::nullopt;
  const int hour = std::atoi(word.substr(0, digits).c_str());
  if (hour < 1 || hour > 12) return std::nullopt;
  return Direction{DirectionKind::Clock, 90.0 - 30.0 * hour};
}

}  // namespace

std::optional<Direction> last_direction(const std::vector<std::string>& tokens, std::size_t begin, std::size_t end) {
  constexpr std::size_t apart = 4;  // words between "up" and "left" that still make one direction
  std::vector<std::string> letters;
  for (std::size_t i = begin; i < end; ++i) letters.push_back(letters_of(tokens[i]));
  std::optional<Direction> found;
  double right = 0, up = 0;
  std::size_t last = 0;
  bool ended = false;  // "north, then east" are two directions
  for (std::size_t i = 0; i < letters.size(); ++i) {
    if (const auto hour = clock(letters, i)) {
      found = hour;
      right = up = 0;
      continue;
    }
    ended = ended || letters[i] == "then" || tokens[begin + i] == ".";
    const auto at = words().find(letters[i]);
    if (at == words().end()) continue;
    const Word& word = at->second;
    const bool joins = found && !ended && found->kind != DirectionKind::Clock && i - last <= apart &&
                       ((right == 0 && word.up == 0) || (up == 0 && word.right == 0));
    if (!joins) right = up = 0;
    right += word.right, up += word.up;
    found = Direction{word.kind, std::atan2(up, right) * degrees};
    last = i;
    ended = false;
  }
  return found;
}

double angle_between(double a, double b) { return std::abs(std::remainder(a - b, 360.0)); }

}  // namespace waymark::streets

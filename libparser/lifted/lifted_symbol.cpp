#include "libparser/lifted/lifted_symbol.hpp"

#include <array>
#include <sstream>
#include <stdexcept>

#include "libltl/diagnostic.hpp"

namespace waymark::parser {
namespace {

using enum LiftedSymbol;

constexpr std::array<std::string_view, static_cast<std::size_t>(Number1)> names{
    "end",       "route",      "nothing",    "true",      "not",         "and",          "or",      "implies",
    "iff",       "next",       "eventually", "always",    "until",       "weakly",       "release", "visit",
    "patrol",    "never",      "sequence",   "ordered",   "strict",      "exactly",      "atmost",  "atleast",
    "react",     "follow",     "after",      "alternate", "stayon",      "ifelse",       "ahead",   "right",
    "behind",    "left",       "beside",     "along",     "turned_left", "turned_right", "moved",   "start",
    "open_left", "open_right", "turnleft",   "turnright", "turnaround",  "steps",        "nth"};

constexpr std::size_t list = any_number;

}  // namespace

std::size_t operands_of(LiftedSymbol s) {
  switch (s) {
    case Not:
    case Next:
    case Eventually:
    case Always:
    case StayOn:
    case Ahead:
    case Right:
    case Behind:
    case Left:
    case Beside:
    case Along:
    case Steps: return 1;
    case Implies:
    case Iff:
    case Until:
    case WeakUntil:
    case Release:
    case Exactly:
    case AtMost:
    case AtLeast:
    case Nth:
    case React:
    case Follow:
    case After: return 2;
    case IfElse: return 3;
    case And:
    case Or:
    case Visit:
    case Patrol:
    case Never:
    case Sequence:
    case Ordered:
    case Strict:
    case Alternate: return list;
    default: return 0;
  }
}

namespace {

std::size_t least_operands(LiftedSymbol s) {
  switch (s) {
    case Never:
    case Patrol:
    case Sequence: return 1;
    default: return 2;
  }
}

bool is_spatial(LiftedSymbol s) { return is_direction(s) || is_event(s) || is_action(s) || s == StayOn; }

LiftedSymbol nth(LiftedSymbol first, LiftedSymbol last, std::size_t number) {
  const std::size_t at = static_cast<std::size_t>(first) + number - 1;
  if (number == 0 || at > static_cast<std::size_t>(last)) throw std::out_of_range("no lifted symbol of that number");
  return static_cast<LiftedSymbol>(at);
}

}  // namespace

LiftedSymbol slot(std::size_t number) { return nth(Slot1, Slot12, number); }
LiftedSymbol constant(std::size_t number) { return nth(Constant1, Constant16, number); }
LiftedSymbol number(std::size_t number) { return nth(Number1, Number9, number); }

std::size_t number_of(LiftedSymbol s) {
  const LiftedSymbol first = is_constant(s) ? Constant1 : is_slot(s) ? Slot1 : Number1;
  return static_cast<std::size_t>(s) - static_cast<std::size_t>(first) + 1;
}

std::string name(LiftedSymbol s) {
  if (s < Number1) return std::string(names[static_cast<std::size_t>(s)]);
  return (is_constant(s) ? "@" : is_slot(s) ? "#" : "") + std::to_string(number_of(s));
}

std::optional<LiftedSymbol> lifted_symbol(std::string_view wanted) {
  for (std::size_t i = 0; i < lifted_symbols; ++i)
    if (const auto s = static_cast<LiftedSymbol>(i); name(s) == wanted) return s;
  return std::nullopt;
}

std::string print(std::span<const LiftedSymbol> lifted) {
  std::string text;
  for (const LiftedSymbol s : lifted) text += (text.empty() ? "" : " ") + name(s);
  return text;
}

Lifted parse_lifted(std::string_view text) {
  std::istringstream words{std::string(text)};
  Lifted lifted;
  for (std::string word; words >> word;) {
    const auto s = lifted_symbol(word);
    if (!s) throw ltl::FormatError("", 0, 0, "'" + word + "' is no symbol of a lifted formula");
    lifted.push_back(*s);
  }
  return lifted;
}

Lifted mirrored(Lifted lifted) {
  for (LiftedSymbol& s : lifted) switch (s) {
      case Left: s = Right; break;
      case Right: s = Left; break;
      case TurnedLeft: s = TurnedRight; break;
      case TurnedRight: s = TurnedLeft; break;
      case TurnLeft: s = TurnRight; break;
      case TurnRight: s = TurnLeft; break;
      case OpenLeft: s = OpenRight; break;
      case OpenRight: s = OpenLeft; break;
      default: break;
    }
  return lifted;
}

bool LiftedPrefix::allows(LiftedSymbol s, const LiftedScope& scope) const {
  if (ended()) return false;
  if (is_spatial(s) && !scope.spatial) return false;
  if (is_slot(s) && number_of(s) > scope.slots) return false;
  if (is_constant(s) && number_of(s) > scope.constants) return false;
  if (frames_.empty()) return s != End && !is_number(s) && !is_action(s);
  if (s == Route || s == Nothing) return false;
  const auto [parent, operands] = frames_.back();
  const bool counts = parent == Exactly || parent == AtMost || parent == AtLeast || parent == Nth;
  if ((counts && operands == 0) || parent == Steps) return is_number(s);
  if (is_number(s)) return false;
  if (s == End) return operands_of(parent) == list && operands >= least_operands(parent);
  if (is_direction(parent)) return is_thing(s);
  if (parent == StayOn || counts)
    return is_thing(s) || is_direction(s) || is_event(s) || s == Or || s == And || s == Not;
  const bool deep = frames_.size() + 1 >= most_levels, is_long = length_ + frames_.size() + 4 > most_symbols;
  if (is_long && operands_of(parent) == list && operands >= least_operands(parent)) return false;
  if (is_action(s)) return parent == Sequence;
  if (is_long || deep) return is_thing(s);
  if (parent == Not && s == Not) return false;
  return !(parent == s && (s == And || s == Or));
}

void LiftedPrefix::append(LiftedSymbol s) {
  ++length_;
  if (is_slot(s)) slots_used_ |= 1U << (number_of(s) - 1);
  if (s == End) {
    frames_.pop_back();
    close();
  } else if (operands_of(s) > 0) {
    frames_.push_back({s, 0});
  } else {
    close();
  }
}

void LiftedPrefix::close() {
  while (!frames_.empty()) {
    Frame& top = frames_.back();
    ++top.operands;
    if (operands_of(top.symbol) == list || top.operands < operands_of(top.symbol)) return;
    frames_.pop_back();
  }
}

bool is_spelled_in(std::span<const LiftedSymbol> lifted, const LiftedScope& scope) {
  LiftedPrefix prefix;
  for (const LiftedSymbol s : lifted) {
    if (prefix.ended() || !prefix.allows(s, scope)) return false;
    prefix.append(s);
  }
  return prefix.ended();
}

}  // namespace waymark::parser

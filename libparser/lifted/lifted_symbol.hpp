// Lifted formulas in typed prefix form: LTL whose propositions are the places that a text mentions, in order of
// mention.
//
//   "go to a, then b, but avoid c"   =   and  sequence 1 2 end  never 3  end
// A slot is the number of a mention: a text means the same whatever its places are called. Macros name what people say
// (visit, patrol, never, ordered, exactly twice …) and take any number of places. The operators of LTL stand beside the
// macros: every formula has a spelling.
// Sources: the mission patterns of [MTP+21], the templates of [LYIL23]; what each symbol denotes: lifted_formula.hpp.
#pragma once
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace waymark::parser {

enum class LiftedSymbol : std::uint8_t {
  End,
  // whole answers: route instructions are read by the reader of programs; of other texts nothing is understood
  Route,
  Nothing,
  // operators of LTL
  True,
  Not,
  And,
  Or,
  Implies,
  Iff,
  Next,
  Eventually,
  Always,
  Until,
  WeakUntil,
  Release,
  // macros over any number of places, closed by End
  Visit,
  Patrol,
  Never,
  Sequence,
  Ordered,
  Strict,
  // macros over a number and a place: how often it is visited
  Exactly,
  AtMost,
  AtLeast,
  // macros over two operands
  React,
  Follow,
  After,
  Alternate,
  // over a place: moving along it only; and over a condition and two formulas
  StayOn,
  IfElse,
  // where a place is seen from where one stands, and moving along it
  Ahead,
  Right,
  Behind,
  Left,
  Beside,
  Along,
  // propositions that no mention names: of the action that led here, the start, hallways that branch off, and of a
  // small domain
  TurnedLeft,
  TurnedRight,
  Moved,
  Start,
  OpenLeft,
  OpenRight,
  // actions, in a sequence; the last two take a number, and Nth a place: straight on to the nth one
  TurnLeft,
  TurnRight,
  TurnAround,
  Steps,
  Nth,
  Number1,
  Number9 = Number1 + 8,
  Slot1,
  Slot12 = Slot1 + 11,
  Constant1,
  Constant16 = Constant1 + 15,
};
inline constexpr std::size_t lifted_symbols = static_cast<std::size_t>(LiftedSymbol::Constant16) + 1;  // how many

using Lifted = std::vector<LiftedSymbol>;  // a sequence in prefix form

// Kinds of symbols.
constexpr bool is_number(LiftedSymbol s) { return s >= LiftedSymbol::Number1 && s <= LiftedSymbol::Number9; }
constexpr bool is_slot(LiftedSymbol s) { return s >= LiftedSymbol::Slot1 && s <= LiftedSymbol::Slot12; }
constexpr bool is_constant(LiftedSymbol s) { return s >= LiftedSymbol::Constant1; }
constexpr bool is_thing(LiftedSymbol s) { return s >= LiftedSymbol::Slot1; }  // a slot or a constant
constexpr bool is_direction(LiftedSymbol s) { return s >= LiftedSymbol::Ahead && s <= LiftedSymbol::Along; }
constexpr bool is_event(LiftedSymbol s) { return s >= LiftedSymbol::TurnedLeft && s <= LiftedSymbol::OpenRight; }
constexpr bool is_action(LiftedSymbol s) { return s >= LiftedSymbol::TurnLeft && s <= LiftedSymbol::Nth; }
LiftedSymbol slot(std::size_t number);      // from 1; throws std::out_of_range above 12
LiftedSymbol constant(std::size_t number);  // from 1; … above 16
LiftedSymbol number(std::size_t number);    // from 1; … above 9
std::size_t number_of(LiftedSymbol s);      // of a slot, a constant or a number, from 1

inline constexpr std::size_t any_number = 255;  // operands: as many as one likes
std::size_t operands_of(LiftedSymbol s);        // how many it takes; `any_number`: as many as there are up to End

std::string name(LiftedSymbol s);  // "visit", "3" for Number3, "#3" for Slot3, "@3" for Constant3
std::optional<LiftedSymbol> lifted_symbol(std::string_view name);  // nothing when there is none
std::string print(std::span<const LiftedSymbol> lifted);           // names with blanks between them
// Throws ltl::FormatError naming the word that is no symbol.
Lifted parse_lifted(std::string_view text);

// Conjunctions and disjunctions flattened, operands without an order sorted, lists of one place as what they say of it.
// Throws std::invalid_argument when it is no complete lifted formula.
Lifted canonical(std::span<const LiftedSymbol> lifted);

Lifted mirrored(Lifted lifted);  // left and right exchanged

// What may be said: how many slots and constants there are, and whether the domain is one where one turns and sees.
struct LiftedScope {
  std::size_t slots = 0, constants = 0;  // how many of each
  bool spatial = false;                  // directions may be used
};

// A prefix of a lifted formula while it is spelled: which operators wait for how many operands.
class LiftedPrefix {
 public:
  struct Frame {                              // an operator that is open
    LiftedSymbol symbol = LiftedSymbol::End;  // the operator
    std::uint8_t operands = 0;                // so far
  };
  static constexpr std::size_t most_levels = 12, most_symbols = 48;  // of one formula

  bool allows(LiftedSymbol s, const LiftedScope& scope) const;   // may the symbol stand here?
  void append(LiftedSymbol s);                                   // an allowed one
  bool ended() const { return length_ > 0 && frames_.empty(); }  // is the formula complete?
  std::span<const Frame> open() const { return frames_; }        // the outermost first
  std::size_t length() const { return length_; }                 // symbols so far
  std::uint32_t slots_used() const { return slots_used_; }       // bit n − 1: slot n

 private:
  void close();  // an operand is complete: what has all its operands is complete too

  std::vector<Frame> frames_;
  std::size_t length_ = 0;
  std::uint32_t slots_used_ = 0;
};

// Is it one complete formula that may be said in the scope?
bool is_spelled_in(std::span<const LiftedSymbol> lifted, const LiftedScope& scope);

}  // namespace waymark::parser

#include "libautomata/omega/acceptance.hpp"

#include <utility>

namespace waymark::automata {
namespace {

Acceptance of_pairs(std::uint32_t pairs, bool rabin) {
  std::vector<Condition> all;
  for (std::uint32_t i = 0; i < pairs; ++i) {
    std::vector<Condition> pair{Condition::fin(2 * i), Condition::inf(2 * i + 1)};
    all.push_back(rabin ? Condition::all_of(std::move(pair)) : Condition::any_of(std::move(pair)));
  }
  return {2 * pairs, rabin ? Condition::any_of(std::move(all)) : Condition::all_of(std::move(all))};
}

std::string print(const Condition& condition, bool inside_and) {
  const auto joined = [&](const char* sign, bool bracket, bool is_and) {
    std::string out;
    for (const Condition& operand : condition.operands()) out += (out.empty() ? "" : sign) + print(operand, is_and);
    return bracket ? '(' + out + ')' : out;
  };
  switch (condition.op()) {
    case Condition::Op::True: return "t";
    case Condition::Op::False: return "f";
    case Condition::Op::Inf: return "Inf(" + std::to_string(condition.mark()) + ')';
    case Condition::Op::Fin: return "Fin(" + std::to_string(condition.mark()) + ')';
    case Condition::Op::And: return joined(" & ", false, true);
    case Condition::Op::Or: return joined(" | ", inside_and, false);
  }
  return {};  // unreachable: -Werror=switch
}

}  // namespace

std::vector<std::uint32_t> Marks::members() const {
  std::vector<std::uint32_t> out;
  for (std::uint64_t rest = bits_; rest != 0; rest &= rest - 1)
    out.push_back(static_cast<std::uint32_t>(std::countr_zero(rest)));
  return out;
}

Condition Condition::constant(bool value) {
  Condition out;
  out.op_ = value ? Condition::Op::True : Condition::Op::False;
  return out;
}

Condition Condition::inf(std::uint32_t mark) {
  Condition out;
  out.op_ = Condition::Op::Inf;
  out.mark_ = mark;
  return out;
}

Condition Condition::fin(std::uint32_t mark) {
  Condition out = inf(mark);
  out.op_ = Condition::Op::Fin;
  return out;
}

Condition Condition::junction(Condition::Op op, std::vector<Condition> operands) {
  const Condition::Op unit = op == Condition::Op::And ? Condition::Op::True : Condition::Op::False,
                      absorbing = op == Condition::Op::And ? Condition::Op::False : Condition::Op::True;
  Condition out;
  out.op_ = op;
  for (Condition& operand : operands) {
    if (operand.op_ == absorbing) return std::move(operand);
    if (operand.op_ == unit) continue;
    if (operand.op_ == op)
      out.operands_.insert(out.operands_.end(), operand.operands_.begin(), operand.operands_.end());
    else
      out.operands_.push_back(std::move(operand));
  }
  if (out.operands_.empty()) return constant(op == Condition::Op::And);
  if (out.operands_.size() == 1) return Condition(out.operands_.front());
  return out;
}

Condition Condition::all_of(std::vector<Condition> operands) {
  return junction(Condition::Op::And, std::move(operands));
}
Condition Condition::any_of(std::vector<Condition> operands) {
  return junction(Condition::Op::Or, std::move(operands));
}

bool Condition::holds(Marks infinitely_often) const {
  switch (op_) {
    case Condition::Op::True: return true;
    case Condition::Op::False: return false;
    case Condition::Op::Inf: return infinitely_often.contains(mark_);
    case Condition::Op::Fin: return !infinitely_often.contains(mark_);
    case Condition::Op::And:
      for (const Condition& operand : operands_)
        if (!operand.holds(infinitely_often)) return false;
      return true;
    case Condition::Op::Or:
      for (const Condition& operand : operands_)
        if (operand.holds(infinitely_often)) return true;
      return false;
  }
  return false;  // unreachable: -Werror=switch
}

Marks Condition::marks() const {
  Marks out = op_ == Condition::Op::Inf || op_ == Condition::Op::Fin ? Marks::of(mark_) : Marks();
  for (const Condition& operand : operands_) out = out | operand.marks();
  return out;
}

Marks Condition::fin_marks() const {
  Marks out = op_ == Condition::Op::Fin ? Marks::of(mark_) : Marks();
  for (const Condition& operand : operands_) out = out | operand.fin_marks();
  return out;
}

template <class Leaf>
Condition Condition::mapped(const Leaf& leaf, bool exchange) const {
  if (op_ != Condition::Op::And && op_ != Condition::Op::Or) return leaf(*this);
  std::vector<Condition> operands;
  for (const Condition& operand : operands_) operands.push_back(operand.mapped(leaf, exchange));
  return junction((op_ == Condition::Op::And) != exchange ? Condition::Op::And : Condition::Op::Or,
                  std::move(operands));
}

Condition Condition::negated() const {
  const auto leaf = [](const Condition& c) {
    if (c.op_ == Condition::Op::Inf) return fin(c.mark_);
    if (c.op_ == Condition::Op::Fin) return inf(c.mark_);
    return constant(c.op_ == Condition::Op::False);
  };
  return mapped(leaf, true);
}

Condition Condition::replaced(std::uint32_t mark, bool seen) const {
  const auto leaf = [&](const Condition& c) {
    if ((c.op_ != Condition::Op::Inf && c.op_ != Condition::Op::Fin) || c.mark_ != mark) return c;
    return constant((c.op_ == Condition::Op::Inf) == seen);
  };
  return mapped(leaf, false);
}

Condition Condition::without_fin(std::uint32_t mark) const {
  const auto leaf = [&](const Condition& c) {
    return c.op_ == Condition::Op::Fin && c.mark_ == mark ? constant(false) : c;
  };
  return mapped(leaf, false);
}

Condition Condition::shifted(std::uint32_t by) const {
  const auto leaf = [&](const Condition& c) {
    Condition out = c;
    if (c.op_ == Condition::Op::Inf || c.op_ == Condition::Op::Fin) out.mark_ += by;
    return out;
  };
  return mapped(leaf, false);
}

Acceptance Acceptance::generalized_buchi(std::uint32_t n) {
  std::vector<Condition> all;
  for (std::uint32_t i = 0; i < n; ++i) all.push_back(Condition::inf(i));
  return {n, Condition::all_of(std::move(all))};
}

Acceptance Acceptance::rabin(std::uint32_t pairs) { return of_pairs(pairs, true); }
Acceptance Acceptance::streett(std::uint32_t pairs) { return of_pairs(pairs, false); }

// From the least important colour inwards: an accepting colour c gives Inf(c) | rest, the others Fin(c) & rest.
Acceptance Acceptance::parity(Extreme extreme, Parity parity, std::uint32_t colours) {
  Condition condition = Condition::constant(false);
  for (std::uint32_t i = 0; i < colours; ++i) {
    const std::uint32_t colour = extreme == Extreme::Max ? i : colours - 1 - i;
    const bool accepting = (colour % 2 == 0) == (parity == Parity::Even);
    if (i == 0)
      condition = accepting ? Condition::inf(colour) : Condition::fin(colour);
    else if (accepting)
      condition = Condition::any_of({Condition::inf(colour), condition});
    else
      condition = Condition::all_of({Condition::fin(colour), condition});
  }
  if (colours == 0) condition = Condition::constant((parity == Parity::Even) == (extreme == Extreme::Min));
  return {colours, condition};
}

bool Acceptance::is_generalized_buchi() const { return *this == generalized_buchi(sets); }

std::optional<std::string> Acceptance::name() const {
  if (is_all()) return "all";
  if (*this == none()) return "none";
  if (is_buchi()) return "Buchi";
  if (*this == co_buchi()) return "co-Buchi";
  if (is_generalized_buchi()) return "generalized-Buchi " + std::to_string(sets);
  if (sets % 2 == 0 && *this == rabin(sets / 2)) return "Rabin " + std::to_string(sets / 2);
  if (sets % 2 == 0 && *this == streett(sets / 2)) return "Streett " + std::to_string(sets / 2);
  for (const Extreme extreme : {Extreme::Max, Extreme::Min})
    for (const Parity parity : {Parity::Even, Parity::Odd})
      if (*this == Acceptance::parity(extreme, parity, sets))
        return std::string("parity ") + (extreme == Extreme::Max ? "max " : "min ") +
               (parity == Parity::Even ? "even " : "odd ") + std::to_string(sets);
  return std::nullopt;
}

std::string print(const Condition& condition) { return print(condition, false); }

}  // namespace waymark::automata

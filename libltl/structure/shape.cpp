#include "libltl/structure/shape.hpp"

#include <cstdint>

namespace waymark::ltl {
namespace {

// Seven bits a byte, the last one below 128: no number is the beginning of another.
void append(std::string& out, std::size_t number) {
  for (; number >= 128; number /= 128) out += static_cast<char>(128 + number % 128);
  out += static_cast<char>(number);
}

}  // namespace

std::string shape(Formula f) {
  const Arena& arena = f.arena();
  std::string out;
  append(out, arena.vocabulary().size());
  append(out, f.id());
  for (std::uint32_t id = 0; id < arena.size(); ++id) {
    const Formula g = arena.formula(id);
    append(out, static_cast<std::size_t>(g.op()));
    if (g.op() == Op::Atom) append(out, g.proposition().index);
    append(out, g.operands().size());
    for (const Formula h : g.operands()) append(out, h.id());
  }
  return out;
}

}  // namespace waymark::ltl

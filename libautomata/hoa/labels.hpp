// The labels of HOA edges: Boolean expressions over numbered propositions and aliases, as decision diagrams.
#pragma once
#include <optional>
#include <string_view>
#include <unordered_map>

#include "libautomata/bdd/boolean.hpp"
#include "libautomata/hoa/cursor.hpp"

namespace waymark::automata {

class HoaLabels {  // knows the aliases that were read
 public:
  static constexpr std::size_t deepest = 1000;  // nesting of labels and acceptance conditions
  HoaLabels(HoaCursor& cursor, Mtbdd& diagram) : cursor_(cursor), diagram_(diagram), logic_(diagram) {}

  void set_propositions(std::size_t count) { propositions_ = count; }  // of the header AP
  // The expression at the cursor becomes the meaning of the alias; it may use earlier ones.
  void define(const HoaToken& alias);
  std::optional<Mtbdd::Node> label();  // `[…]`, when one stands at the cursor
  // The one letter whose members are the bits of i: what edge i is taken on where labels are implied.
  Mtbdd::Node letter(std::size_t i);

 private:
  Mtbdd::Node disjunction(std::size_t depth);
  Mtbdd::Node conjunction(std::size_t depth);
  Mtbdd::Node literal(std::size_t depth);

  HoaCursor& cursor_;
  Mtbdd& diagram_;
  Boolean logic_;
  std::size_t propositions_ = 0;
  std::unordered_map<std::string_view, Mtbdd::Node> meaning_;
};

}  // namespace waymark::automata

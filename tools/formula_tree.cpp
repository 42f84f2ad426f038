#include "tools/formula_tree.hpp"

#include <string>
#include <vector>

#include "libltl/text/print.hpp"
#include "tools/answer.hpp"
#include "tools/picture.hpp"
#include "tools/shell/exit_code.hpp"
#include "tools/shell/json.hpp"

namespace waymark::tools {
namespace {

struct Shape {  // of a node: its text, and what stands below
  std::string text;
  std::vector<ltl::Formula> below;
};

Shape shape_of(ltl::Formula f) {
  if (ltl::is_eventually(f)) return {"F", {f[1]}};
  if (ltl::is_always(f)) return {"G", {f[1]}};
  const auto with = [&](const char* text) { return Shape{text, {f.operands().begin(), f.operands().end()}}; };
  switch (f.op()) {
    case ltl::Op::False: return {"false", {}};
    case ltl::Op::True: return {"true", {}};
    case ltl::Op::Atom: return {ltl::print(f), {}};
    case ltl::Op::Not: return with("¬");
    case ltl::Op::And: return with("∧");
    case ltl::Op::Or: return with("∨");
    case ltl::Op::Iff: return with("↔");
    case ltl::Op::Next: return with("X");
    case ltl::Op::WeakNext: return with("N");
    case ltl::Op::Until: return with("U");
    case ltl::Op::Release: return with("R");
  }
  return {};
}

class Tree {
 public:
  std::size_t add(ltl::Formula f) {
    const std::size_t number = nodes_++;
    if (nodes_ > most_drawn_states)
      throw GaveUp("not drawn: the syntax tree has more than " + counted(most_drawn_states, "node"));
    const Shape shape = shape_of(f);
    const bool leaf = shape.below.empty();
    text_ += "  " + std::to_string(number) + " [label=" + Json(shape.text).text() +
             (leaf ? ", shape=box, style=\"rounded,filled\", fillcolor=\"#e8eef7\"" : "") + "];\n";
    for (const ltl::Formula operand : shape.below) {
      const std::size_t below = add(operand);
      text_ += "  " + std::to_string(number) + " -> " + std::to_string(below) + ";\n";
    }
    return number;
  }
  const std::string& text() const { return text_; }

 private:
  std::size_t nodes_ = 0;
  std::string text_;
};

}  // namespace

std::string dot_of_tree(ltl::Formula formula) {
  Tree tree;
  tree.add(formula);
  return "digraph formula {\n  ordering=out; labelloc=t; fontname=\"Helvetica\"; fontsize=13; label=" +
         Json(ltl::print(formula, ltl::Style::Unicode) + "\n ").text() +
         ";\n  node [shape=circle, fontname=\"Helvetica\", fontsize=13, height=0.4, margin=0.06];\n"
         "  edge [arrowhead=none];\n" +
         tree.text() + "}\n";
}

}  // namespace waymark::tools

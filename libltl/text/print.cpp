// One loop over a stack of things still to be written: text, or a formula.
#include "libltl/text/print.hpp"

#include <utility>
#include <vector>

#include "libltl/text/lexer.hpp"
#include "libltl/text/symbol.hpp"
#include "libltl/text/view.hpp"

namespace waymark::ltl {
namespace {

struct Row {
  Symbol symbol;
  std::string_view ascii, unicode, latex, lbt;
};

constexpr Row rows[] = {
    {Symbol::Not, "!", "¬", "\\lnot ", "!"},
    {Symbol::Next, "X", "○", "\\mathsf{X}\\,", "X"},
    {Symbol::WeakNext, "N", "●", "\\mathsf{N}\\,", "N"},
    {Symbol::Eventually, "F", "◇", "\\mathsf{F}", "F"},
    {Symbol::Always, "G", "□", "\\mathsf{G}", "G"},
    {Symbol::Yesterday, "Y", "⊖", "\\mathsf{Y}\\,", "Y"},
    {Symbol::WeakYesterday, "Z", "⊝", "\\mathsf{Z}\\,", "Z"},
    {Symbol::Once, "O", "◆", "\\mathsf{O}\\,", "O"},
    {Symbol::Historically, "H", "■", "\\mathsf{H}\\,", "H"},
    {Symbol::And, "&", "∧", "\\land", "&"},
    {Symbol::Or, "|", "∨", "\\lor", "|"},
    {Symbol::ExclusiveOr, "^", "⊕", "\\oplus", "^"},
    {Symbol::Implies, "->", "→", "\\rightarrow", "i"},
    {Symbol::Iff, "<->", "↔", "\\leftrightarrow", "e"},
    {Symbol::Until, "U", "𝒰", "\\mathbin{\\mathsf{U}}", "U"},
    {Symbol::Release, "R", "ℛ", "\\mathbin{\\mathsf{R}}", "V"},
    {Symbol::WeakUntil, "W", "𝒲", "\\mathbin{\\mathsf{W}}", "W"},
    {Symbol::StrongRelease, "M", "ℳ", "\\mathbin{\\mathsf{M}}", "M"},
    {Symbol::Since, "S", "𝒮", "\\mathbin{\\mathsf{S}}", "S"},
    {Symbol::Triggered, "T", "𝒯", "\\mathbin{\\mathsf{T}}", "T"},
};

std::string_view spell(Symbol symbol, Style style) {
  const Row& row = rows[static_cast<std::size_t>(symbol)];
  switch (style) {
    case Style::Ascii:
    case Style::Postfix: return row.ascii;
    case Style::Unicode: return row.unicode;
    case Style::Latex: return row.latex;
    case Style::Lbt: return row.lbt;
  }
  return row.ascii;  // unreachable: -Werror=switch
}

std::string_view spell(bool value, Style style) {
  switch (style) {
    case Style::Ascii:
    case Style::Postfix: return value ? "true" : "false";
    case Style::Unicode: return value ? "⊤" : "⊥";
    case Style::Latex: return value ? "\\top" : "\\bot";
    case Style::Lbt: return value ? "t" : "f";
  }
  return "";  // unreachable: -Werror=switch
}

std::string latex_name(std::string_view name) {
  std::string out = "\\mathit{";
  for (char c : name) {
    if (std::string_view("#$%&_{}").find(c) != std::string_view::npos)
      (out += '\\') += c;
    else if (c == '\\')
      out += "\\backslash{}";
    else if (c == '^')
      out += "\\wedge{}";
    else if (c == '~')
      out += "\\sim{}";
    else if (c == ' ' || c == '\n' || c == '\t')
      out += "\\ ";
    else
      out += c;
  }
  return out + "}";
}

bool is_binary(const View& v) { return !is_unary(v.symbol); }

class Printer {
 public:
  explicit Printer(Style style)
      : style_(style),
        options_{.bounds = style != Style::Lbt && style != Style::Postfix, .delays = true, .implications = true} {}

  std::string print(Formula f) {
    push(ViewOperand{{f}});
    while (!stack_.empty()) {
      Piece piece = std::move(stack_.back());
      stack_.pop_back();
      if (piece.operand.parts.empty())
        out_ += piece.text;
      else
        write(piece.operand);
    }
    return std::move(out_);
  }

 private:
  struct Piece {
    std::string text;  // or, when there are parts:
    ViewOperand operand;
  };

  void push(std::string text) { stack_.push_back({std::move(text), {}}); }
  void push(ViewOperand operand) { stack_.push_back({"", std::move(operand)}); }
  void write(const ViewOperand& operand);
  void write_prefix(View v);
  void write_postfix(View v);
  void write_unary(View v);
  void write_binary(View v);

  Style style_;
  ViewOptions options_;
  std::string out_;
  std::vector<Piece> stack_;
};

bool is_leaf(const ViewOperand& operand) {
  if (operand.parts.size() > 1) return false;
  const Op op = operand.parts.front().op();
  return op == Op::Atom || op == Op::True || op == Op::False;
}

void Printer::write(const ViewOperand& operand) {
  if (is_leaf(operand)) {
    const Formula f = operand.parts.front();
    if (f.op() == Op::Atom)
      out_ += print_name(f.arena().vocabulary().name(f.proposition()), style_);
    else
      out_ += spell(f.op() == Op::True, style_);
    return;
  }
  View v = view(operand, options_);
  if (style_ == Style::Lbt) return write_prefix(std::move(v));
  if (style_ == Style::Postfix) return write_postfix(std::move(v));
  if (is_unary(v.symbol)) return write_unary(std::move(v));
  write_binary(std::move(v));
}

// n operands need n − 1 binary operators: & & a b c in front, a b & c & behind.
void Printer::write_prefix(View v) {
  const std::string sign(spell(v.symbol, style_));
  const std::size_t signs = is_unary(v.symbol) ? 1 : v.operands.size() - 1;
  for (std::size_t i = 0; i < signs; ++i) out_ += sign + " ";
  for (std::size_t i = v.operands.size(); i-- > 0;) {
    push(std::move(v.operands[i]));
    if (i > 0) push(" ");
  }
}

void Printer::write_postfix(View v) {
  const std::string sign(spell(v.symbol, style_));
  for (std::size_t i = v.operands.size(); i-- > 0;) {
    if (i > 0 || is_unary(v.symbol)) push(" " + sign);
    push(std::move(v.operands[i]));
    if (i > 0) push(" ");
  }
}

void Printer::write_unary(View v) {
  out_ += spell(v.symbol, style_);
  if (v.bound) {
    const std::string k = std::to_string(v.from + *v.bound), from = std::to_string(v.from);
    if (v.from > 0)
      out_ += style_ == Style::Latex ? "_{[" + from + "," + k + "]}" : '[' + from + ':' + k + ']';
    else
      out_ += style_ == Style::Latex ? "_{\\leq " + k + "}" : (style_ == Style::Unicode ? "≤" : "<=") + k;
  }
  ViewOperand& operand = v.operands.front();
  const bool parenthesised = !is_leaf(operand) && is_binary(view(operand, options_));
  if (style_ == Style::Latex && (v.symbol == Symbol::Eventually || v.symbol == Symbol::Always)) out_ += "\\,";
  const bool worded = style_ == Style::Ascii && v.symbol != Symbol::Not;
  if (v.bound ? style_ != Style::Latex : worded && !parenthesised) out_ += " ";
  if (parenthesised) push(")");
  push(std::move(operand));
  if (parenthesised) push("(");
}

void Printer::write_binary(View v) {
  const std::string sign = " " + std::string(spell(v.symbol, style_)) + " ";
  for (std::size_t i = v.operands.size(); i-- > 0;) {
    ViewOperand& operand = v.operands[i];
    const bool leaf = is_leaf(operand);
    const View inner = leaf ? View{} : view(operand, options_);
    // F a U b would parse as (F a) U b; a reader should not have to know.
    const bool temporal = precedence(v.symbol) == precedence(Symbol::Until) && inner.symbol != Symbol::Not;
    const bool parenthesised = !leaf && (is_binary(inner) || temporal);
    if (parenthesised) push(")");
    push(std::move(operand));
    if (parenthesised) push("(");
    if (i > 0) push(sign);
  }
}

}  // namespace

std::string print_name(std::string_view name, Style style) {
  if (style == Style::Latex) return latex_name(name);
  if (is_bare_name(name, style == Style::Lbt ? Notation::Lbt : Notation::Infix)) return std::string(name);
  std::string out = "\"";
  for (char c : name) {
    if (c == '"' || c == '\\') out += '\\';
    if (c == '\n')
      out += "\\n";
    else
      out += c;
  }
  return out + "\"";
}

std::string print(Formula f, Style style) { return Printer(style).print(f); }

}  // namespace waymark::ltl

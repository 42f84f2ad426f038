// Parsing by a stack machine, so that depth of input is never depth of the call stack.
//
// All three notations feed one Builder, which applies operators to the formulas on its stack. Chains of one
// associative operator stay open until something else needs them: a & b & c … makes one node, not one per prefix.
#include "libltl/text/parse.hpp"

#include <algorithm>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "libltl/diagnostic.hpp"
#include "libltl/text/lexer.hpp"

namespace waymark::ltl {
namespace {

// The operator without its lower bound: what must hold after so many steps.
Formula from_step(std::size_t i, Formula f, Formula (*one_step)(Formula)) {
  while (i-- > 0) f = one_step(f);
  return f;
}

// φ U[i:j] ψ = φ ∧ X(φ U[i−1:j−1] ψ), i strong nexts.
Formula until_from(std::size_t i, Formula left, Formula until) {
  while (i-- > 0) until = conjunction(left, next(until));
  return until;
}

// φ U<=k ψ = ψ ∨ (φ ∧ X(ψ ∨ (φ ∧ X …))), k strong nexts.
Formula until_within(std::size_t k, Formula left, Formula right) {
  Formula out = right;
  for (std::size_t i = 0; i < k; ++i) out = disjunction(right, conjunction(left, next(out)));
  return out;
}

class Builder {
 public:
  Builder(std::string_view text, Arena& arena, const ParseOptions& options)
      : text_(text), arena_(arena), options_(options) {}

  void push(const Token& token) {  // a Name or a Constant
    stack_.push_back({{token.kind == Token::Kind::Name ? atom(token) : arena_.constant(token.value)}, Op::Atom, 1});
  }
  void apply(const Token& token);  // an Operator, on the last one or two formulas
  void settle(Symbol next);        // makes the last formula now unless `next` continues its chain
  std::size_t size() const { return stack_.size(); }
  Formula result() { return close(std::move(stack_.back())); }

 private:
  struct Term {  // one formula, or the operands of an And or Or not made yet
    std::vector<Formula> parts;
    Op junction;        // And, Or: how to join the parts; Atom: there is one part
    std::size_t depth;  // levels of the formula
  };

  Formula atom(const Token& token);
  std::optional<std::string> name_beginning_with(const Token& token) const;
  std::string known() const;  // the first propositions, for messages
  Formula close(Term&& term);
  Term pop();
  void push(Formula f, std::size_t depth, const Token& token);
  void join(Op op, Term left, Term right, const Token& token);
  void apply_unary(const Token& token);
  void check(std::size_t depth, const Token& token) const;

  std::string_view text_;
  Arena& arena_;
  const ParseOptions& options_;
  std::vector<Term> stack_;
};

// Of several words, the first of which is this one: a name that stands here without its quotes, or the only one.
std::optional<std::string> Builder::name_beginning_with(const Token& token) const {
  std::optional<std::string> found;
  bool alone = true;
  for (const std::string& name : arena_.vocabulary().names()) {
    if (!name.starts_with(token.name + ' ')) continue;
    if (text_.substr(token.where.begin).starts_with(name)) return name;
    alone = !found;
    found = name;
  }
  return alone ? found : std::nullopt;
}

std::string Builder::known() const {
  constexpr std::size_t most = 8;
  const std::vector<std::string>& names = arena_.vocabulary().names();
  std::string list;
  for (std::size_t i = 0; i < std::min(most, names.size()); ++i) list += (i == 0 ? "" : ", ") + names[i];
  if (list.empty()) return "";
  return " (known: " + list + (names.size() > most ? ", …)" : ")");
}

Formula Builder::atom(const Token& token) {
  if (const auto p = arena_.vocabulary().find(token.name)) return arena_.atom(*p);
  const bool bare = !token.quoted && options_.notation == Notation::Infix;
  const std::string_view meant = bare ? meant_by(token.name, options_.dialect) : "";
  if (options_.unknown == Unknown::Add && meant.empty()) return arena_.atom(token.name);
  std::string message = "unknown proposition '" + token.name + "'";
  if (!meant.empty())
    throw SyntaxError(text_, token.where,
                      options_.unknown == Unknown::Reject
                          ? message + " (did you mean " + std::string(meant) + "?)"
                          : "'" + token.name + "' means nothing here (did you mean " + std::string(meant) +
                                "? a proposition of that name stands in double quotes)");
  if (const auto whole = name_beginning_with(token))
    message += " (did you mean \"" + *whole + "\", in quotes?)";
  else if (const auto near = arena_.vocabulary().nearest(token.name))
    message += !is_bare_name(*near, Notation::Infix) ? " (did you mean \"" + *near + "\", in quotes?)"
                                                     : " (did you mean '" + *near + "'?)";
  else
    message += known();
  throw SyntaxError(text_, token.where, message);
}

Formula Builder::close(Term&& term) {
  if (term.junction == Op::And) return conjunction(arena_, term.parts);
  if (term.junction == Op::Or) return disjunction(arena_, term.parts);
  return term.parts.front();
}

Builder::Term Builder::pop() {
  Term term = std::move(stack_.back());
  stack_.pop_back();
  return term;
}

void Builder::check(std::size_t depth, const Token& token) const {
  if (depth > most_levels)
    throw SyntaxError(text_, token.where, "expected at most 10,000 levels of nesting (bounds count k times)");
}

void Builder::push(Formula f, std::size_t depth, const Token& token) {
  check(depth, token);
  stack_.push_back({{f}, Op::Atom, depth});
}

// The smaller list joins the larger: a chain of n costs O(n log n) however it is bracketed.
void Builder::join(Op op, Term left, Term right, const Token& token) {
  for (Term* term : {&left, &right}) {
    if (term->junction == op) continue;
    const std::size_t depth = term->depth + 1;
    *term = {{close(std::move(*term))}, op, depth};
  }
  if (left.parts.size() < right.parts.size()) std::swap(left, right);
  left.parts.insert(left.parts.end(), right.parts.begin(), right.parts.end());
  left.depth = std::max(left.depth, right.depth);
  check(left.depth, token);
  stack_.push_back(std::move(left));
}

void Builder::apply_unary(const Token& token) {
  const std::size_t k = token.bound.value_or(token.from) - token.from;
  const std::size_t depth = stack_.back().depth + (token.bound ? 2 * k : 1) + token.from;
  check(depth, token);
  const Formula f = close(pop());
  switch (token.symbol) {
    case Symbol::Not: return push(negate(f), depth, token);
    case Symbol::Next: return push(from_step(token.from, next(f), next), depth, token);
    case Symbol::WeakNext: return push(from_step(token.from, weak_next(f), weak_next), depth, token);
    case Symbol::Eventually:
      return push(from_step(token.from, token.bound ? eventually_within(k, f) : eventually(f), next), depth, token);
    case Symbol::Always:
      return push(from_step(token.from, token.bound ? always_within(k, f) : always(f), weak_next), depth, token);
    case Symbol::Yesterday: return push(yesterday(f), depth, token);
    case Symbol::WeakYesterday: return push(weak_yesterday(f), depth + 2, token);
    case Symbol::Once: return push(once(f), depth, token);
    case Symbol::Historically: return push(historically(f), depth + 2, token);
    case Symbol::And:
    case Symbol::Or:
    case Symbol::ExclusiveOr:
    case Symbol::Implies:
    case Symbol::Iff:
    case Symbol::Until:
    case Symbol::Release:
    case Symbol::WeakUntil:
    case Symbol::StrongRelease:
    case Symbol::Since:
    case Symbol::Triggered: break;  // binary: see apply
  }
}

void Builder::apply(const Token& token) {
  if (is_unary(token.symbol)) return apply_unary(token);
  Term right = pop(), left = pop();
  if (token.symbol == Symbol::And) return join(Op::And, std::move(left), std::move(right), token);
  if (token.symbol == Symbol::Or) return join(Op::Or, std::move(left), std::move(right), token);
  if (token.symbol == Symbol::Implies) {
    const std::size_t depth = left.depth + 1;
    return join(Op::Or, {{negate(close(std::move(left)))}, Op::Atom, depth}, std::move(right), token);
  }
  const std::size_t k = token.bound.value_or(token.from) - token.from;
  const std::size_t depth = std::max(left.depth, right.depth) + (token.bound ? 3 * k : 1) + 2 * token.from;
  check(depth, token);
  const Formula a = close(std::move(left)), b = close(std::move(right));
  switch (token.symbol) {
    case Symbol::ExclusiveOr: return push(exclusive_or(a, b), depth, token);
    case Symbol::Iff: return push(iff(a, b), depth, token);
    case Symbol::Until:
      return push(until_from(token.from, a, token.bound ? until_within(k, a, b) : until(a, b)), depth, token);
    case Symbol::Release: return push(release(a, b), depth, token);
    case Symbol::WeakUntil: return push(weak_until(a, b), depth + 1, token);
    case Symbol::StrongRelease: return push(strong_release(a, b), depth + 1, token);
    case Symbol::Since: return push(since(a, b), depth, token);
    case Symbol::Triggered: return push(triggered(a, b), depth + 2, token);
    case Symbol::And:
    case Symbol::Or:
    case Symbol::Implies:
    case Symbol::Not:
    case Symbol::Next:
    case Symbol::WeakNext:
    case Symbol::Eventually:
    case Symbol::Always:
    case Symbol::Yesterday:
    case Symbol::WeakYesterday:
    case Symbol::Once:
    case Symbol::Historically: break;  // done above
  }
}

// Made now rather than later, a left operand comes before the right one in creation order, and in print.
void Builder::settle(Symbol next) {
  Term& last = stack_.back();
  if (next == (last.junction == Op::And ? Symbol::And : Symbol::Or)) return;
  if (last.junction == Op::Atom) return;
  const auto depth = last.depth;
  last = {{close(std::move(last))}, Op::Atom, depth};
}

class Parser {
 public:
  Parser(std::string_view text, Arena& arena, const ParseOptions& options)
      : options_(options), lexer_(text, options.dialect, options.notation), builder_(text, arena, options) {}

  Formula infix();
  Formula prefix();
  Formula postfix();

 private:
  [[noreturn]] void fail(const Token& token, std::string_view message) const {
    throw SyntaxError(lexer_.text(), token.where, message);
  }
  std::string quote(const Token& token) const {
    return "'" + std::string(lexer_.text().substr(token.where.begin, token.where.end - token.where.begin)) + "'";
  }
  [[noreturn]] void fail_for_operator(const Token& token, const Token& before) const {
    if (before.kind == Token::Kind::Name && !before.quoted && is_branching(before.name))
      fail(before, "'" + before.name + "' is an operator of CTL, which is not read; a formula of LTL speaks of every " +
                       "path already (did you mean " + (before.name.size() == 1 ? "it without" : "G, F, X or U for") +
                       " '" + before.name + "'?)");
    std::string message = "expected an operator or the end of the formula before " + quote(token);
    if (const auto meant = token.quoted ? "" : meant_by(token.name, options_.dialect); !meant.empty())
      message += " (did you mean " + std::string(meant) + "?)";
    fail(token, message);
  }
  [[noreturn]] void fail_for_operand(const Token& token, const std::optional<Token>& before) const {
    fail(token, before ? "expected a formula after " + quote(*before) : "expected a formula");
  }
  void reduce(int level, bool strictly);
  void close_parenthesis(const Token& token);
  void finish(const Token& end);

  const ParseOptions& options_;
  Lexer lexer_;
  Builder builder_;
  std::vector<Token> waiting_;  // operators and open parentheses, innermost last
};

// Applies the waiting operators, back to the last open parenthesis, that bind tighter than `level` or, unless
// `strictly`, as tight.
void Parser::reduce(int level, bool strictly) {
  while (!waiting_.empty() && waiting_.back().kind == Token::Kind::Operator) {
    const int top = waiting_.back().binding.level;
    if (top < level || (strictly && top == level)) break;
    builder_.apply(waiting_.back());
    waiting_.pop_back();
  }
}

void Parser::close_parenthesis(const Token& token) {
  reduce(0, false);
  if (waiting_.empty()) fail(token, "expected the end of the formula or an operator: no '(' is open for this ')'");
  waiting_.pop_back();
}

void Parser::finish(const Token& end) {
  reduce(0, false);
  if (waiting_.empty()) return;
  const std::size_t column = SyntaxError(lexer_.text(), waiting_.back().where, "").column();
  fail(end, "expected ')' for the '(' in column " + std::to_string(column));
}

Formula Parser::infix() {
  std::optional<Token> before;
  bool complete = false;  // the tokens so far end with a whole formula
  while (true) {
    Token token = lexer_.next();
    const bool binary = token.kind == Token::Kind::Operator && !is_unary(token.symbol);
    const bool ends = binary || token.kind == Token::Kind::Close || token.kind == Token::Kind::End;
    if (complete && !ends) fail_for_operator(token, *before);
    if (!complete && ends) fail_for_operand(token, before);
    switch (token.kind) {
      case Token::Kind::Name:
      case Token::Kind::Constant: builder_.push(token); break;
      case Token::Kind::Close: close_parenthesis(token); break;
      case Token::Kind::End: finish(token); return builder_.result();
      case Token::Kind::Operator:
        if (binary) {
          reduce(token.binding.level, token.binding.right);
          builder_.settle(token.symbol);
        }
        waiting_.push_back(token);
        break;
      case Token::Kind::Open: waiting_.push_back(token); break;
    }
    complete =
        token.kind == Token::Kind::Name || token.kind == Token::Kind::Constant || token.kind == Token::Kind::Close;
    before = std::move(token);
  }
}

Formula Parser::prefix() {
  std::vector<std::size_t> missing;  // operands still to come, for each waiting operator
  std::optional<Token> before;
  do {
    Token token = lexer_.next();
    if (token.kind == Token::Kind::Open || token.kind == Token::Kind::Close)
      fail(token, "expected no parentheses: the prefix form needs none");
    if (token.kind == Token::Kind::End) fail_for_operand(token, before);
    if (token.kind == Token::Kind::Operator) {
      missing.push_back(is_unary(token.symbol) ? 1 : 2);
      waiting_.push_back(token);
    } else {
      builder_.push(token);
      while (!missing.empty() && --missing.back() == 0) {
        builder_.apply(waiting_.back());
        waiting_.pop_back();
        missing.pop_back();
      }
    }
    before = std::move(token);
  } while (!missing.empty());
  const Token token = lexer_.next();
  if (token.kind != Token::Kind::End) fail(token, "expected the end of the formula before " + quote(token));
  return builder_.result();
}

Formula Parser::postfix() {
  while (true) {
    const Token token = lexer_.next();
    switch (token.kind) {
      case Token::Kind::Open:
      case Token::Kind::Close: fail(token, "expected no parentheses: the postfix form needs none");
      case Token::Kind::Name:
      case Token::Kind::Constant: builder_.push(token); break;
      case Token::Kind::Operator:
        if (builder_.size() < (is_unary(token.symbol) ? 1 : 2))
          fail(token, std::string(is_unary(token.symbol) ? "expected a formula" : "expected two formulas") +
                          " before " + quote(token));
        builder_.apply(token);
        break;
      case Token::Kind::End:
        if (builder_.size() == 0) fail(token, "expected a formula");
        if (builder_.size() > 1)
          fail(token, "expected an operator: " + std::to_string(builder_.size()) + " formulas stand unconnected");
        return builder_.result();
    }
  }
}

}  // namespace

Formula parse(std::string_view text, Arena& arena, const ParseOptions& options) {
  Parser parser(text, arena, options);
  switch (options.notation) {
    case Notation::Infix: return parser.infix();
    case Notation::Lbt: return parser.prefix();
    case Notation::Postfix: return parser.postfix();
  }
  return parser.infix();  // unreachable: -Werror=switch
}

}  // namespace waymark::ltl

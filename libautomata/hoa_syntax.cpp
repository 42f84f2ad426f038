#include "libautomata/hoa_syntax.hpp"

#include <algorithm>
#include <unordered_map>
#include <unordered_set>

#include "libltl/diagnostic.hpp"

namespace waymark::automata {
namespace {

using Kind = HoaToken::Kind;
using Node = Mtbdd::Node;

class Parser {
 public:
  Parser(std::string_view text, std::string_view source)
      : source_(source), tokens_(hoa_tokens(text, source)), logic_(out_.labels) {}

  HoaAutomaton parse() {
    headers();
    resolve_aliases();
    while (peek().kind == Kind::Header && peek().text == "State") state();
    if (peek().kind == Kind::Abort) fail(peek(), "the automaton was aborted by its writer");
    if (peek().kind != Kind::End) expected("'State:', an edge or --END--");
    ++at_;
    if (peek().kind != Kind::Eof) fail(peek(), "expected the end of the file: one automaton is read");
    return std::move(out_);
  }

 private:
  static constexpr std::size_t deepest = 1000;  // nesting of labels and acceptance conditions

  const HoaToken& peek() const { return tokens_[at_]; }
  const HoaToken& take() { return tokens_[peek().kind == Kind::Eof ? at_ : at_++]; }
  bool punctuation(char c) const { return peek().kind == Kind::Punctuation && peek().text[0] == c; }
  bool accept(char c) {
    if (!punctuation(c)) return false;
    ++at_;
    return true;
  }
  [[noreturn]] void fail(const HoaToken& at, std::string_view message) const {
    throw ltl::FormatError(source_, at.line, at.column, message);
  }
  [[noreturn]] void expected(std::string_view what) const {
    fail(peek(), "expected " + std::string(what) + ", not " + described(peek()));
  }
  void demand(char c) {
    if (!accept(c)) expected(std::string("'") + c + "'");
  }
  const HoaToken& demand(Kind kind, std::string_view what) {
    if (peek().kind != kind) expected(what);
    return take();
  }

  void headers() {
    if (peek().kind != Kind::Header || peek().text != "HOA") expected("'HOA: v1' at the beginning");
    take();
    const HoaToken version = demand(Kind::Identifier, "the version v1");
    if (version.text != "v1") fail(version, "HOA version v1 is read, not " + described(version));
    while (peek().kind == Kind::Header) header();
    if (peek().kind != Kind::Body) expected("a header or --BODY--");
    if (!seen_.contains("Acceptance")) fail(peek(), "the header 'Acceptance:' is missing");
    take();
  }

  void header() {
    const HoaToken name = take();
    const std::string_view text = name.text;
    const bool repeatable = text == "Start" || text == "Alias" || text == "properties";
    const bool known = repeatable || text == "States" || text == "AP" || text == "Acceptance" ||
                       text == "acc-name" || text == "tool" || text == "name";
    if (!seen_.insert(std::string(text)).second && known && !repeatable)
      fail(name, "a second header " + described(name));
    if (text == "States") {
      states_ = demand(Kind::Integer, "the number of states").value;
    } else if (text == "Start") {
      if (out_.starts.size() == 1) out_.second_start_at = name;
      out_.starts.push_back(conjunction_of_states());
    } else if (text == "AP") {
      propositions();
    } else if (text == "Acceptance") {
      out_.acceptance_at = name;
      sets_ = demand(Kind::Integer, "the number of acceptance sets").value;
      out_.acceptance = condition(0);
    } else if (text == "Alias") {
      const HoaToken alias = demand(Kind::Alias, "the name of an alias, as @a");
      aliases_.emplace_back(alias, at_);
      skip_values();  // read when all headers are known
    } else if (!known && text[0] >= 'A' && text[0] <= 'Z') {
      fail(name, "unknown header " + described(name) + "; its capital says that it changes the meaning");
    } else {
      skip_values();
    }
  }

  void skip_values() {
    while (peek().kind != Kind::Header && peek().kind != Kind::Body) {
      if (peek().kind == Kind::Eof || peek().kind == Kind::End || peek().kind == Kind::Abort)
        expected("a header or --BODY--");
      take();
    }
  }

  void propositions() {
    const HoaToken count = demand(Kind::Integer, "the number of propositions");
    std::unordered_set<std::string> names;
    while (peek().kind == Kind::String) {
      const HoaToken& name = take();
      out_.propositions.push_back(unquoted(name.text));
      if (out_.propositions.back().empty()) fail(name, "a proposition without a name");
      if (!names.insert(out_.propositions.back()).second)
        fail(name, "a second proposition " + described(name));
    }
    if (out_.propositions.size() != count.value)
      fail(count, "'AP:' announces " + std::to_string(count.value) + " propositions and names " +
                      std::to_string(out_.propositions.size()));
    if (out_.propositions.size() > Mtbdd::max_variables) fail(count, "too many propositions");
  }

  // acceptance: Inf(k), Fin(k), Inf(!k), Fin(!k), t, f, parentheses, & and |. What is no Büchi condition is Other.
  HoaAutomaton::Acceptance condition(std::size_t depth) {
    using Acceptance = HoaAutomaton::Acceptance;
    if (depth > deepest) fail(peek(), "this acceptance condition is nested too deeply");
    Acceptance whole = condition_atom(depth);
    while (punctuation('&') || punctuation('|')) {
      take();
      condition_atom(depth);
      whole.kind = Acceptance::Kind::Other;
    }
    return whole;
  }
  HoaAutomaton::Acceptance condition_atom(std::size_t depth) {
    using Acceptance = HoaAutomaton::Acceptance;
    if (accept('(')) {
      const Acceptance inner = condition(depth + 1);
      demand(')');
      return inner;
    }
    const HoaToken word = demand(Kind::Identifier, "an acceptance condition");
    if (word.text == "t") return {Acceptance::Kind::All, 0};
    if (word.text == "f") return {Acceptance::Kind::None, 0};
    if (word.text != "Inf" && word.text != "Fin")
      fail(word, "expected Inf, Fin, t or f, not " + described(word));
    demand('(');
    const bool complemented = accept('!');
    const HoaToken set = demand(Kind::Integer, "the number of an acceptance set");
    check_set(set);
    demand(')');
    const bool buchi = word.text == "Inf" && !complemented;
    return {buchi ? Acceptance::Kind::Buchi : Acceptance::Kind::Other, set.value};
  }
  void check_set(const HoaToken& set) const {
    if (set.value >= sets_)
      fail(set, "acceptance set " + std::to_string(set.value) + " of " + std::to_string(sets_));
  }

  void resolve_aliases() {
    const std::size_t body = at_;
    for (const auto& [name, begin] : aliases_) {
      at_ = begin;
      const Node meaning = disjunction(0);
      if (peek().kind != Kind::Header && peek().kind != Kind::Body) expected("the end of the alias");
      if (!meaning_.emplace(name.text, meaning).second) fail(name, "a second alias " + described(name));
    }
    at_ = body;
  }

  Node disjunction(std::size_t depth) {
    Node all = conjunction(depth);
    while (accept('|')) all = logic_.disjunction(all, conjunction(depth));
    return all;
  }
  Node conjunction(std::size_t depth) {
    Node all = literal(depth);
    while (accept('&')) all = logic_.conjunction(all, literal(depth));
    return all;
  }
  Node literal(std::size_t depth) {
    if (depth > deepest) fail(peek(), "this label is nested too deeply");
    if (accept('!')) return logic_.negate(literal(depth + 1));
    if (accept('(')) {
      const Node inner = disjunction(depth + 1);
      demand(')');
      return inner;
    }
    const HoaToken token = peek();
    if (token.kind == Kind::Integer) {
      if (token.value >= out_.propositions.size())
        fail(token, "proposition " + std::to_string(token.value) + " of " +
                        std::to_string(out_.propositions.size()));
      take();
      return logic_.variable(static_cast<Mtbdd::Variable>(token.value));
    }
    if (token.kind == Kind::Alias) {
      const auto known = meaning_.find(token.text);
      if (known == meaning_.end()) fail(token, "unknown alias " + described(token));
      take();
      return known->second;
    }
    if (token.kind != Kind::Identifier || (token.text != "t" && token.text != "f"))
      expected("a proposition's number, t, f, an alias, '!' or '('");
    take();
    return Boolean::constant(token.text == "t");
  }

  std::optional<Node> label() {
    if (!accept('[')) return std::nullopt;
    const Node meaning = disjunction(0);
    demand(']');
    return meaning;
  }

  std::vector<std::uint64_t> conjunction_of_states() {
    std::vector<std::uint64_t> out;
    do {
      const HoaToken number = demand(Kind::Integer, "the number of a state");
      if (states_ && number.value >= *states_)
        fail(number, "state " + std::to_string(number.value) + " of " + std::to_string(*states_));
      out.push_back(number.value);
    } while (accept('&'));
    return out;
  }

  std::vector<std::uint64_t> marks() {
    std::vector<std::uint64_t> out;
    if (!accept('{')) return out;
    while (!accept('}')) {
      const HoaToken set = demand(Kind::Integer, "the number of an acceptance set or '}'");
      check_set(set);
      out.push_back(set.value);
    }
    return out;
  }

  void state() {
    HoaAutomaton::State state;
    state.at = take();
    const std::optional<Node> shared = label();
    const HoaToken number = peek();
    const std::vector<std::uint64_t> numbers = conjunction_of_states();
    if (numbers.size() > 1) fail(number, "expected the number of one state");
    state.number = numbers.front();
    if (!defined_.insert(state.number).second)
      fail(number, "state " + std::to_string(state.number) + " is defined a second time");
    if (peek().kind == Kind::String) take();
    state.marks = marks();
    std::size_t unlabelled = 0;
    while (punctuation('[') || peek().kind == Kind::Integer) {
      HoaAutomaton::Edge edge;
      edge.at = peek();
      const std::optional<Node> own = label();
      if (own && shared) fail(edge.at, "a label on an edge of a state that has a label itself");
      if (!own && !shared) ++unlabelled;
      edge.label = own ? *own : shared.value_or(Boolean::constant(false));
      edge.targets = conjunction_of_states();
      edge.marks = marks();
      state.edges.push_back(std::move(edge));
    }
    if (unlabelled > 0) imply_labels(state, unlabelled);
    out_.states.push_back(std::move(state));
  }

  // Without labels, edge i is taken on the letter whose members are the bits of i.
  void imply_labels(HoaAutomaton::State& state, std::size_t unlabelled) {
    const std::size_t width = out_.propositions.size();
    if (unlabelled != state.edges.size())
      fail(state.at, "some edges of this state have labels and some have none");
    if (width >= 63 || unlabelled != std::size_t{1} << width)
      fail(state.at, "a state without labels needs one edge per letter, 2^" + std::to_string(width) +
                         ", not " + std::to_string(unlabelled));
    for (std::size_t i = 0; i < unlabelled; ++i) {
      Node letter = Boolean::constant(true);
      for (std::size_t v = width; v-- > 0;) {
        const Node no = Boolean::constant(false);
        const bool member = ((i >> v) & 1U) != 0;
        letter =
            out_.labels.make(static_cast<Mtbdd::Variable>(v), member ? no : letter, member ? letter : no);
      }
      state.edges[i].label = letter;
    }
  }

  std::string_view source_;
  std::vector<HoaToken> tokens_;
  std::size_t at_ = 0;
  HoaAutomaton out_;
  Boolean logic_;
  std::optional<std::uint64_t> states_;
  std::uint64_t sets_ = 0;
  std::unordered_set<std::string> seen_;
  std::vector<std::pair<HoaToken, std::size_t>> aliases_;  // and where its meaning begins
  std::unordered_map<std::string_view, Node> meaning_;
  std::unordered_set<std::uint64_t> defined_;
};

}  // namespace

HoaAutomaton parse_hoa(std::string_view text, std::string_view source) {
  return Parser(text, source).parse();
}

}  // namespace waymark::automata

#include "libautomata/hoa/syntax.hpp"

#include <algorithm>
#include <array>
#include <unordered_set>

#include "libautomata/hoa/cursor.hpp"
#include "libautomata/hoa/labels.hpp"
#include "libltl/text/foreign.hpp"

namespace waymark::automata {
namespace {

using Kind = HoaToken::Kind;

class Parser {
 public:
  Parser(std::vector<HoaToken> tokens, std::string_view source)
      : cursor_(std::move(tokens), source), labels_(cursor_, out_.labels) {}

  HoaAutomaton parse() {
    headers();
    check_numbers();
    resolve_aliases();
    while (cursor_.peek().kind == Kind::Header && cursor_.peek().text == "State") state();
    if (cursor_.peek().kind != Kind::End) cursor_.expected("'State:', an edge or --END--");
    return std::move(out_);
  }

 private:
  void headers() {
    if (cursor_.peek().kind != Kind::Header || cursor_.peek().text != "HOA")
      cursor_.expected("'HOA: v1' at the beginning");
    cursor_.take();
    const HoaToken version = cursor_.demand(Kind::Identifier, "the version v1");
    if (version.text != "v1" && version.text != "v1.1")
      cursor_.fail(version, "HOA versions v1 and v1.1 are read, not " + described(version));
    while (cursor_.peek().kind == Kind::Header) header();
    if (cursor_.peek().kind != Kind::Body) cursor_.expected("a header or --BODY--");
    if (!seen_.contains("Acceptance")) cursor_.fail(cursor_.peek(), "the header 'Acceptance:' is missing");
    cursor_.take();
  }

  void header() {
    const HoaToken header = cursor_.take();
    const std::string_view text = header.text;
    constexpr std::array once{"States", "AP", "Acceptance", "acc-name", "tool", "name", "HOA"};
    const bool unique = std::find(once.begin(), once.end(), text) != once.end();
    if (!seen_.insert(text).second && unique) cursor_.fail(header, "a second header " + described(header));
    if (text == "HOA") cursor_.fail(header, "a second header 'HOA:' before the end of the automaton");
    if (text == "States") {
      states_ = cursor_.demand(Kind::Integer, "the number of states").value;
    } else if (text == "Start") {
      if (out_.starts.size() == 1) out_.second_start_at = header;
      out_.starts.push_back(conjunction_of_states());
    } else if (text == "AP") {
      propositions();
    } else if (text == "Acceptance") {
      out_.acceptance_at = header;
      out_.sets = cursor_.demand(Kind::Integer, "the number of acceptance sets").value;
      out_.acceptance = condition(0);
    } else if (text == "Alias") {
      alias();
    } else if (text == "name") {
      out_.name = unquoted(cursor_.demand(Kind::String, "the name of the automaton in quotes").text);
    } else if (text == "tool") {
      cursor_.demand(Kind::String, "the name of a tool in quotes");
      if (cursor_.peek().kind == Kind::String) cursor_.take();
    } else if (text == "acc-name") {
      acceptance_name();  // what it says stands under `Acceptance:` too
    } else if (text == "properties") {
      properties();
    } else if (text[0] >= 'A' && text[0] <= 'Z') {
      cursor_.fail(header, "unknown header " + described(header) + "; its capital says that it changes the meaning");
    } else {
      while (is_value(cursor_.peek())) cursor_.take();
    }
    if (cursor_.peek().kind != Kind::Header && cursor_.peek().kind != Kind::Body)
      cursor_.expected("a header or --BODY--");
  }

  // A property that is denied, `!complete` of version 1.1, claims nothing that the reader uses.
  void properties() {
    while (cursor_.peek().kind == Kind::Identifier || cursor_.punctuation('!')) {
      const bool denied = cursor_.accept('!');
      const HoaToken property = cursor_.demand(Kind::Identifier, "the name of a property");
      if (!denied) out_.properties.push_back(property);
    }
  }

  static bool is_value(const HoaToken& token) {
    return token.kind == Kind::Identifier || token.kind == Kind::Integer || token.kind == Kind::String;
  }

  void acceptance_name() {
    cursor_.demand(Kind::Identifier, "the name of an acceptance condition");
    while (cursor_.peek().kind == Kind::Identifier || cursor_.peek().kind == Kind::Integer) cursor_.take();
  }

  void alias() {  // read when all headers are known
    const HoaToken name = cursor_.demand(Kind::Alias, "the name of an alias, as @a");
    aliases_.emplace_back(name, cursor_.position());
    const auto stops = [&] {
      const Kind kind = cursor_.peek().kind;
      return kind == Kind::Header || kind == Kind::Body || kind == Kind::Eof || kind == Kind::End ||
             kind == Kind::Abort;
    };
    while (!stops()) cursor_.take();
  }

  void resolve_aliases() {
    labels_.set_propositions(out_.propositions.size());
    const std::size_t body = cursor_.position();
    for (const auto& [name, begin] : aliases_) {
      cursor_.go_back_to(begin);
      labels_.define(name);
    }
    cursor_.go_back_to(body);
  }

  void propositions() {
    const HoaToken count = cursor_.demand(Kind::Integer, "the number of propositions");
    std::unordered_set<std::string> names;
    while (cursor_.peek().kind == Kind::String) {
      const HoaToken& name = cursor_.take();
      out_.propositions.push_back(unquoted(name.text));
      if (out_.propositions.back().empty()) cursor_.fail(name, "a proposition without a name");
      if (!names.insert(out_.propositions.back()).second) cursor_.fail(name, "a second proposition " + described(name));
    }
    if (out_.propositions.size() != count.value)
      cursor_.fail(count, "'AP:' announces " + std::to_string(count.value) + " propositions and names " +
                              std::to_string(out_.propositions.size()));
    if (out_.propositions.size() > Mtbdd::max_variables) cursor_.fail(count, "too many propositions");
  }

  HoaCondition condition(std::size_t depth) { return junction(depth, HoaCondition::Op::Or); }

  // Loosest first: ∨ of ∧ of atoms.
  HoaCondition junction(std::size_t depth, HoaCondition::Op op) {
    if (depth > HoaLabels::deepest) cursor_.fail(cursor_.peek(), "this acceptance condition is nested too deeply");
    const auto part = [&] {
      return op == HoaCondition::Op::Or ? junction(depth, HoaCondition::Op::And) : condition_atom(depth);
    };
    HoaCondition first = part();
    if (!cursor_.punctuation(op == HoaCondition::Op::Or ? '|' : '&')) return first;
    HoaCondition all;
    all.op = op;
    all.operands.push_back(std::move(first));
    while (cursor_.accept(op == HoaCondition::Op::Or ? '|' : '&')) all.operands.push_back(part());
    return all;
  }

  HoaCondition condition_atom(std::size_t depth) {
    HoaCondition out;
    if (cursor_.accept('(')) {
      out = condition(depth + 1);
      cursor_.demand(')');
      return out;
    }
    const HoaToken word = cursor_.demand(Kind::Identifier, "an acceptance condition");
    out.op = word.text == "t"     ? HoaCondition::Op::True
             : word.text == "f"   ? HoaCondition::Op::False
             : word.text == "Inf" ? HoaCondition::Op::Inf
                                  : HoaCondition::Op::Fin;
    if (out.op == HoaCondition::Op::Fin && word.text != "Fin")
      cursor_.fail(word, "expected Inf, Fin, t or f, not " + described(word));
    if (out.op != HoaCondition::Op::Inf && out.op != HoaCondition::Op::Fin) return out;
    cursor_.demand('(');
    out.complemented = cursor_.accept('!');
    const HoaToken set = cursor_.demand(Kind::Integer, "the number of an acceptance set");
    check_set(set);
    out.set = set.value;
    cursor_.demand(')');
    return out;
  }
  void check_set(const HoaToken& set) const {
    if (set.value >= out_.sets)
      cursor_.fail(set, "acceptance set " + std::to_string(set.value) + " of " + std::to_string(out_.sets));
  }

  std::vector<std::uint64_t> conjunction_of_states() {
    std::vector<std::uint64_t> out;
    do {
      const HoaToken number = cursor_.demand(Kind::Integer, "the number of a state");
      if (!states_) early_.push_back(number);
      check_state(number);
      out.push_back(number.value);
    } while (cursor_.accept('&'));
    return out;
  }
  void check_state(const HoaToken& number) const {
    if (states_ && number.value >= *states_)
      cursor_.fail(number, "state " + std::to_string(number.value) + " of " + std::to_string(*states_));
  }
  void check_numbers() {  // those of Start: headers that stand before States:
    for (const HoaToken& number : early_) check_state(number);
    early_.clear();
  }

  std::vector<std::uint64_t> marks() {
    std::vector<std::uint64_t> out;
    if (!cursor_.accept('{')) return out;
    while (!cursor_.accept('}')) {
      const HoaToken set = cursor_.demand(Kind::Integer, "the number of an acceptance set or '}'");
      check_set(set);
      out.push_back(set.value);
    }
    return out;
  }

  void state() {
    HoaAutomaton::State state;
    state.at = cursor_.take();
    const std::optional<Mtbdd::Node> shared = labels_.label();
    const HoaToken number = cursor_.peek();
    const std::vector<std::uint64_t> numbers = conjunction_of_states();
    early_.clear();
    if (numbers.size() > 1) cursor_.fail(number, "expected the number of one state");
    state.number = numbers.front();
    if (!defined_.insert(state.number).second)
      cursor_.fail(number, "state " + std::to_string(state.number) + " is defined a second time");
    if (cursor_.peek().kind == Kind::String) state.name = unquoted(cursor_.take().text);
    state.marks = marks();
    while (cursor_.punctuation('[') || cursor_.peek().kind == Kind::Integer) edge(state, shared);
    if (shared) state.labels = HoaAutomaton::Labels::State;
    if (state.labels == HoaAutomaton::Labels::Implied) imply_labels(state);
    out_.states.push_back(std::move(state));
  }

  void edge(HoaAutomaton::State& state, const std::optional<Mtbdd::Node>& shared) {
    HoaAutomaton::Edge edge;
    edge.at = cursor_.peek();
    const std::optional<Mtbdd::Node> own = labels_.label();
    if (own && shared) cursor_.fail(edge.at, "a label on an edge of a state that has a label itself");
    const HoaAutomaton::Labels labels = own      ? HoaAutomaton::Labels::Edge
                                        : shared ? HoaAutomaton::Labels::State
                                                 : HoaAutomaton::Labels::Implied;
    if (!state.edges.empty() && labels != state.labels)
      cursor_.fail(state.at, "some edges of this state have labels and some have none");
    state.labels = labels;
    edge.label = own ? *own : shared.value_or(Boolean::constant(false));
    edge.targets = conjunction_of_states();
    early_.clear();
    edge.marks = marks();
    state.edges.push_back(std::move(edge));
  }

  // Without labels, edge i is taken on the letter whose members are the bits of i.
  void imply_labels(HoaAutomaton::State& state) {
    const std::size_t width = out_.propositions.size();
    if (width >= 63 || state.edges.size() != std::size_t{1} << width)
      cursor_.fail(state.at, "a state without labels needs one edge per letter, 2^" + std::to_string(width) + ", not " +
                                 std::to_string(state.edges.size()));
    for (std::size_t i = 0; i < state.edges.size(); ++i) state.edges[i].label = labels_.letter(i);
  }

  HoaAutomaton out_;
  HoaCursor cursor_;
  HoaLabels labels_;
  std::optional<std::uint64_t> states_;
  std::vector<HoaToken> early_;  // numbers of states that stand before States:
  std::unordered_set<std::string_view> seen_;
  std::vector<std::pair<HoaToken, std::size_t>> aliases_;  // and where its meaning begins
  std::unordered_set<std::uint64_t> defined_;
};

}  // namespace

HoaReader::HoaReader(std::string_view text, std::string_view source) : lexer_(text, source), source_(source) {
  ltl::refuse_foreign(text, source, "'HOA: v1' at the beginning", "an automaton in HOA");
}

std::optional<HoaAutomaton> HoaReader::next() {
  std::vector<HoaToken> tokens;
  try {
    tokens = lexer_.automaton();
  } catch (const ltl::FormatError&) {  // where the next one begins is anyone's guess
    lexer_ = HoaLexer("", source_);
    throw;
  }
  if (tokens.size() == 1 && tokens.front().kind == Kind::Eof) return std::nullopt;
  if (tokens.back().kind == Kind::Abort) {  // whatever stands before it
    HoaAutomaton aborted;
    aborted.aborted = true;
    aborted.acceptance_at = tokens.back();
    return aborted;
  }
  return Parser(std::move(tokens), source_).parse();
}

HoaAutomaton parse_hoa(std::string_view text, std::string_view source) {
  HoaReader reader(text, source);
  std::optional<HoaAutomaton> only = reader.next();
  if (!only) throw ltl::FormatError(source, 1, 1, "expected 'HOA: v1' at the beginning, not the end of the file");
  const HoaToken& end = only->acceptance_at;
  if (only->aborted) throw ltl::FormatError(source, end.line, end.column, "the automaton was aborted by its writer");
  HoaLexer rest = reader.rest();
  const HoaToken behind = rest.automaton().front();
  if (behind.kind != Kind::Eof)
    throw ltl::FormatError(source, behind.line, behind.column, "expected the end of the file: one automaton is read");
  return std::move(*only);
}

}  // namespace waymark::automata

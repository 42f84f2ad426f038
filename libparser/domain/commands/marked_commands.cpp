#include "libparser/domain/commands/marked_commands.hpp"

#include <algorithm>
#include <cctype>
#include <map>

#include "libltl/rewriting/nnf.hpp"
#include "libltl/text/parse.hpp"
#include "libparser/corpus/token.hpp"
#include "libparser/domain/commands/landmark_mentions.hpp"

namespace waymark::parser {
namespace {

using enum LiftedSymbol;

std::string in_lower_case(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

// The tokens of a text; marks begin and end where tokens do.
struct MarkedTokens {
  std::vector<std::string> tokens;
  std::vector<std::pair<std::size_t, std::size_t>> marks;  // [begin, end) of each mark, where "not" was put before some
};
MarkedTokens tokens_of(const Command& command, bool hallway) {
  MarkedTokens out;
  std::size_t at = 0;
  const auto add = [&](std::size_t begin, std::size_t end) {
    const std::string part = command.text.substr(begin, end - begin);
    for (std::string& token : hallway ? tokenize(part) : landmark_tokens(part)) out.tokens.push_back(std::move(token));
  };
  for (const MarkedMention& mark : command.mentions) {
    if (mark.begin < at) {
      out.marks.emplace_back(out.tokens.size(), out.tokens.size());
      continue;
    }
    add(at, mark.begin);
    if (mark.negated) out.tokens.emplace_back("not");
    const std::size_t begin = out.tokens.size();
    add(mark.begin, mark.end);
    out.marks.emplace_back(begin, out.tokens.size());
    at = mark.end;
  }
  add(at, command.text.size());
  return out;
}

ltl::Vocabulary with_start(const ltl::Vocabulary& vocabulary) {
  std::vector<std::string> names(vocabulary.names().begin(), vocabulary.names().end());
  if (std::find(names.begin(), names.end(), "start") == names.end()) names.emplace_back("start");
  return ltl::Vocabulary(names);
}

}  // namespace

MarkedCommands::MarkedCommands(const ltl::Vocabulary& hallways, const Synonyms* synonyms)
    : vocabulary_(with_start(hallways)), things_(hallways, synonyms) {}

MarkedCommands::Marked MarkedCommands::lift(const Command& command) const {
  const bool hallway = command.domain == hallway_domain;
  const MarkedTokens text = tokens_of(command, hallway);
  std::vector<Mention> mentions;
  std::vector<std::string> keys;
  for (std::size_t i = 0; i < text.marks.size(); ++i) {
    const auto [begin, end] = text.marks[i];
    if (begin == end) continue;
    const std::string& key = command.mentions[i].thing;
    std::size_t thing = 0;
    if (hallway) {
      const auto named = find_mentions(tokenize(command.things.at(key)), things_.things());
      if (named.empty()) continue;
      thing = named.front().thing;
    } else {
      thing = static_cast<std::size_t>(std::find(keys.begin(), keys.end(), key) - keys.begin());
      if (thing == keys.size()) keys.push_back(key);
    }
    mentions.push_back({begin, end, thing});
  }
  Marked out;
  if (hallway) {
    LiftedMentions lifted = things_.lift(text.tokens, std::move(mentions));
    out.text = std::move(lifted.text);
    out.things = std::move(lifted.things);
    return out;
  }
  LiftedMentions lifted = parser::lift(text.tokens, mentions);
  out.text = std::move(lifted.text);
  for (const std::size_t thing : lifted.things) out.slots.push_back(in_lower_case(keys[thing]));
  return out;
}

std::optional<Lifted> MarkedCommands::label(const Command& command, const Marked& marked,
                                            const std::string& formula) const {
  std::map<std::string, Lifted> literals;
  if (command.domain != hallway_domain) {
    for (std::size_t i = 0; i < marked.slots.size(); ++i) literals[marked.slots[i]] = {slot(i + 1)};
    ltl::Arena arena;
    const ltl::Formula f = ltl::parse(formula, arena);
    return spell(f, [&](ltl::Proposition p) -> std::optional<Lifted> {
      const auto at = literals.find(arena.vocabulary().name(p));
      return at == literals.end() ? std::nullopt : std::optional(at->second);
    });
  }
  ltl::Arena arena{ltl::Vocabulary(vocabulary_)};
  const Bindings bindings = things_.bindings(arena, marked.things, std::nullopt);
  const auto add = [&](const std::optional<ltl::Formula>& f, Lifted spelled) {
    if (f && f->op() == ltl::Op::Atom) literals.emplace(arena.vocabulary().name(f->proposition()), std::move(spelled));
  };
  for (const LiftedSymbol event : {TurnedLeft, TurnedRight, Moved, Start, OpenLeft, OpenRight})
    add(bindings.literal(End, event), {event});
  for (std::size_t i = 0; i < marked.things.size(); ++i) {
    add(bindings.literal(End, slot(i + 1)), {slot(i + 1)});
    for (const LiftedSymbol direction : {Ahead, Right, Behind, Left, Beside})
      add(bindings.literal(direction, slot(i + 1)), {direction, slot(i + 1)});
  }
  const ltl::Formula f = ltl::parse(formula, arena);
  const auto spelled = spell(f, [&](ltl::Proposition p) -> std::optional<Lifted> {
    const auto at = literals.find(arena.vocabulary().name(p));
    return at == literals.end() ? std::nullopt : std::optional(at->second);
  });
  if (!spelled) return std::nullopt;
  const auto denoted = formula_of(*spelled, bindings);
  return denoted && ltl::nnf(*denoted) == ltl::nnf(f) ? spelled : std::nullopt;  // N φ is spelled !X !φ
}

std::optional<LiftedExample> MarkedCommands::example(const Command& command) const {
  const Marked marked = lift(command);
  std::vector<std::string> formulas{command.formula};
  formulas.insert(formulas.end(), command.also.begin(), command.also.end());
  for (const std::string& formula : formulas)
    if (auto lifted = label(command, marked, formula); lifted && is_spelled_in(*lifted, marked.text.scope))
      return LiftedExample{marked.text, std::move(*lifted), 1};
  return std::nullopt;
}

MarkedExamples marked_examples(std::span<const Command> commands, const MarkedCommands& marked) {
  MarkedExamples out;
  for (const Command& command : commands) {
    if (auto example = marked.example(command))
      out.examples.push_back(std::move(*example));
    else
      ++out.left_out;
  }
  return out;
}

}  // namespace waymark::parser

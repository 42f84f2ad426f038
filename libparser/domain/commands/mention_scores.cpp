#include "libparser/domain/commands/mention_scores.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <string_view>

#include "libparser/domain/commands/landmark_mentions.hpp"

namespace waymark::parser {
namespace {

bool negates(const std::string& token) {
  constexpr std::array<std::string_view, 5> words{"no", "not", "n't", "non", "without"};
  return std::find(words.begin(), words.end(), token) != words.end();
}

bool is_passed_over(const std::string& token) {
  return token == "the" || token == "a" || token == "an" || token == "any" || token == "its";
}

// An odd number of negations stands before the end of the tokens.
bool ends_negated(std::span<const std::string> tokens) {
  bool negated = false;
  for (; !tokens.empty() && (negates(tokens.back()) || is_passed_over(tokens.back()));
       tokens = tokens.first(tokens.size() - 1))
    negated ^= negates(tokens.back());
  return negated;
}

std::string proposition_of(std::string thing) {
  std::transform(thing.begin(), thing.end(), thing.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return thing;
}

void add(NamedThings& things, const std::string& proposition, bool negated) {
  if (std::find(things.slots.begin(), things.slots.end(), proposition) == things.slots.end())
    things.slots.push_back(proposition);
  things.sequence.push_back((negated ? "!" : "") + proposition);
  if (!negated) return;
  const auto at = std::lower_bound(things.negated.begin(), things.negated.end(), proposition);
  if (at != things.negated.end() && *at == proposition)
    things.negated.erase(at);
  else
    things.negated.insert(at, proposition);
}

}  // namespace

NamedThings marked_things(const Command& command) {
  NamedThings out;
  for (const MarkedMention& mention : command.mentions)
    add(out, proposition_of(mention.thing),
        mention.negated != ends_negated(landmark_tokens(command.text.substr(0, mention.begin))));
  return out;
}

std::vector<Mention> marked_mentions(const Command& command) {
  std::vector<Mention> out;
  const std::size_t tokens = landmark_tokens(command.text).size();
  for (const MarkedMention& mention : command.mentions) {
    const std::size_t begin = landmark_tokens(command.text.substr(0, mention.begin)).size();
    const std::size_t end = std::min(tokens, landmark_tokens(command.text.substr(0, mention.end)).size());
    const auto thing = std::distance(command.things.begin(), command.things.find(mention.thing));
    if (begin < end && (out.empty() || begin >= out.back().end))
      out.push_back({begin, end, static_cast<std::size_t>(thing), mention.negated});
  }
  return out;
}

CommandDomain::Lift marked_lift(const Command& command) {
  std::vector<std::string> things;
  for (const auto& [key, _] : command.things) things.push_back(key);
  LiftedMentions lifted = parser::lift(landmark_tokens(command.text), marked_mentions(command));
  CommandDomain::Lift out{std::move(lifted.text), {}, 1};
  for (const std::size_t thing : lifted.things) out.slots.push_back(proposition_of(things[thing]));
  return out;
}

NamedThings found_things(const CommandDomain::Lift& lift) {
  NamedThings out;
  const std::vector<std::string>& tokens = lift.text.tokens;
  for (std::size_t i = 0; i < tokens.size(); ++i) {
    if (tokens[i].size() < 2 || tokens[i][0] != '#') continue;
    const std::size_t slot = std::stoul(tokens[i].substr(1));
    if (slot == 0 || slot > lift.slots.size()) continue;
    add(out, lift.slots[slot - 1], ends_negated(std::span(tokens).first(i)));
  }
  return out;
}

namespace {

// "no open door" and "the door isn't open" are the same text; articles are none of it.
std::vector<std::string> without_articles(const CommandDomain::Lift& lift) {
  std::vector<std::string> out;
  for (const std::string& token : lift.text.tokens)
    if (!is_passed_over(token)) out.push_back(negates(token) ? "not" : token);
  return out;
}

}  // namespace

MentionScores score_mentions(std::span<const Command> commands, const MentionModel& model,
                             std::span<const std::string> distractors) {
  MentionScores out;
  for (const Command& command : commands) {
    Command read = command;
    for (std::size_t i = 0; i < distractors.size(); ++i)
      if (std::none_of(command.things.begin(), command.things.end(),
                       [&](const auto& thing) { return thing.second == distractors[i]; }))
        read.things["other" + std::to_string(i)] = distractors[i];
    const NamedThings wanted = marked_things(command);
    const CommandDomain::Lift likeliest = CommandDomain::of_things(read).lift(command.text, model).front();
    const NamedThings found = found_things(likeliest);
    ++out.commands;
    if (found.slots != wanted.slots) continue;
    ++out.named;
    if (found.negated == wanted.negated) ++out.stated;
    if (found.sequence != wanted.sequence) continue;
    ++out.exact;
    if (without_articles(likeliest) == without_articles(marked_lift(command))) ++out.lifted;
  }
  return out;
}

}  // namespace waymark::parser

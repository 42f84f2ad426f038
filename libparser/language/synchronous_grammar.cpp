#include "libparser/language/synchronous_grammar.hpp"

#include <algorithm>
#include <cctype>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <utility>

#include "libltl/diagnostic.hpp"
#include "libltl/text/read_text.hpp"
#include "libparser/corpus/token.hpp"

namespace waymark::parser {
namespace {

constexpr std::size_t deepest = 9, longest_text = 4'000, most_attempts = 1'000;

struct TooLong {};  // a text that is drawn anew, caught in say alone

std::string trim(std::string_view text) {
  const auto begin = text.find_first_not_of(" \t"), end = text.find_last_not_of(" \t");
  return begin == std::string_view::npos ? "" : std::string(text.substr(begin, end - begin + 1));
}

// The parts between the bars that stand in no bracket.
std::vector<std::string> alternatives(std::string_view text) {
  std::vector<std::string> all;
  std::size_t begin = 0, level = 0;
  for (std::size_t i = 0; i <= text.size(); ++i) {
    if (i < text.size() && text[i] == '(') ++level;
    if (i < text.size() && text[i] == ')') --level;
    if (i == text.size() || (text[i] == '|' && level == 0)) {
      all.push_back(trim(text.substr(begin, i - begin)));
      begin = i + 1;
    }
  }
  return all;
}

std::size_t word_end(std::string_view text, std::size_t begin) {
  while (begin < text.size() && (std::isalnum(static_cast<unsigned char>(text[begin])) != 0 || text[begin] == '_'))
    ++begin;
  return begin;
}

}  // namespace

SynchronousGrammar::SynchronousGrammar(const std::filesystem::path& file) : source_(file.string()) {
  std::istringstream in(ltl::read_text(file));
  std::string category;
  std::size_t number = 0;
  const auto fail = [&](const std::string& message) { throw ltl::FormatError(file.string(), number, 0, message); };
  for (std::string line; std::getline(in, line);) {
    ++number;
    line = trim(line);
    if (line.empty() || (line[0] == '#' && (line.size() < 2 || std::isdigit(static_cast<unsigned char>(line[1])) == 0)))
      continue;
    if (line[0] == '@') {
      category = trim(line.substr(1));
      lines_.try_emplace(category, number);
      continue;
    }
    const auto arrow = line.find("=>");
    if (arrow == std::string::npos && line[0] == '$') {
      const auto equals = line.find('=');
      if (equals == std::string::npos) fail("words need a '='");
      check_text(line.substr(equals + 1), file.string(), number);
      if (line.find_first_of("<>") != std::string::npos) fail("words name no category: only a rule does");
      for (std::string& a : alternatives(std::string_view(line).substr(equals + 1)))
        words_[trim(line.substr(1, equals - 1))].push_back(std::move(a));
      continue;
    }
    if (arrow == std::string::npos || category.empty()) fail("no rule: a rule is TEXT => FORMULA, below a category");
    Rule rule{trim(line.substr(0, arrow)), trim(line.substr(arrow + 2)), 1, number};
    if (const auto colon = rule.text.find(": "); colon < 4 && rule.text.find_first_not_of("0123456789.") == colon) {
      if (rule.text.find_first_of("0123456789") > colon) fail("the weight of a rule is a number");
      rule.weight = std::stod(rule.text.substr(0, colon));
      rule.text = trim(rule.text.substr(colon + 2));
    }
    rules_[category].push_back(std::move(rule));
  }
  check_rules(file.string());
}

// Brackets are closed, and words are there: as words are checked where they stand, they are made of words above, and
// no text goes on without end.
void SynchronousGrammar::check_text(const std::string& text, const std::string& source, std::size_t line) const {
  std::size_t level = 0;
  for (std::size_t at = 0; at < text.size(); ++at) {
    if (text[at] == '(') ++level;
    if (text[at] == ')' && level-- == 0) throw ltl::FormatError(source, line, 0, "a bracket was not opened");
    if (text[at] != '$') continue;
    const std::string word = text.substr(at + 1, word_end(text, at + 1) - at - 1);
    if (!words_.contains(word)) throw ltl::FormatError(source, line, 0, "no words are called $" + word);
  }
  if (level > 0) throw ltl::FormatError(source, line, 0, "a bracket is not closed");
}

// Categories exist and have rules, references have something to refer to, and first rules lead to a text.
void SynchronousGrammar::check_rules(const std::string& source) const {
  std::map<std::string, std::vector<std::string>> first;
  for (const auto& [category, line] : lines_)
    if (!rules_.contains(category)) throw ltl::FormatError(source, line, 0, "category '" + category + "' has no rule");
  for (const auto& [category, rules] : rules_)
    for (const Rule& rule : rules) {
      const std::vector<std::string> parts = check_rule(rule, source);
      first.try_emplace(category, parts);
    }
  for (bool ended = true; ended;) {
    ended = std::erase_if(first, [&](const auto& rule) {
              return std::none_of(rule.second.begin(), rule.second.end(),
                                  [&](const std::string& part) { return first.contains(part); });
            }) > 0;
  }
  if (!first.empty())
    throw ltl::FormatError(source, lines_.at(first.begin()->first), 0,
                           "the first rule of category '" + first.begin()->first + "' leads back to itself");
}

// The categories of a rule, in order.
std::vector<std::string> SynchronousGrammar::check_rule(const Rule& rule, const std::string& source) const {
  check_text(rule.text, source, rule.line);
  std::vector<std::string> parts;
  const auto fail = [&](const std::string& message) { throw ltl::FormatError(source, rule.line, 0, message); };
  const auto refer = [&](const std::string& number) {
    const bool digits =
        !number.empty() && number.size() < 3 && number.find_first_not_of("0123456789") == std::string::npos;
    if (!digits || std::stoul(number) < 1 || std::stoul(number) > parts.size())
      fail("'" + number + "' refers to no category of the rule");
  };
  std::ptrdiff_t level = 0;
  for (std::size_t at = 0; at < rule.text.size(); ++at) {
    level += rule.text[at] == '(' ? 1 : rule.text[at] == ')' ? -1 : 0;
    if (rule.text[at] != '<') continue;
    const auto end = rule.text.find('>', at);
    const std::string name = end == std::string::npos ? "" : rule.text.substr(at + 1, end - at - 1);
    if (name.starts_with("#"))
      refer(name.substr(1));
    else if (level > 0)
      fail("'" + name + "' stands in a bracket, where it may be left out");
    else if (name == "N" || rules_.contains(name))
      parts.push_back(name);
    else
      fail("no category is called '" + name + "'");
  }
  std::istringstream words(rule.lifted);
  for (std::string word; words >> word;) {
    if (std::isdigit(static_cast<unsigned char>(word[0])) != 0)
      refer(word);
    else if (const std::string symbol = word[0] == '=' ? word.substr(1) : word; !lifted_symbol(symbol))
      fail("'" + symbol + "' is no symbol of a lifted formula");
  }
  return parts;
}

std::string SynchronousGrammar::expand(std::string text, ltl::Random& random) const {
  for (std::size_t at = 0; at < text.size();) {
    if (text.size() > longest_text) throw TooLong();
    if (text[at] == '$') {
      const std::size_t end = word_end(text, at + 1);
      const auto words = words_.find(text.substr(at + 1, end - at - 1));
      if (words == words_.end())  // "($a|b)c" may say "$ac"
        throw ltl::FormatError(source_, 0, 0, "no words are called '" + text.substr(at, end - at) + "'");
      text.replace(at, end - at, words->second[random.below(words->second.size())]);
    } else if (text[at] == '(') {
      std::size_t level = 1, end = at + 1;
      for (; end < text.size() && level > 0; ++end)
        level += text[end] == '(' ? 1 : text[end] == ')' ? std::size_t(-1) : 0;
      const auto all = alternatives(std::string_view(text).substr(at + 1, end - at - 2));
      text.replace(at, end - at, all[random.below(all.size())]);
    } else {
      ++at;
    }
  }
  return text;
}

SynchronousGrammar::Draft SynchronousGrammar::draw(const std::string& category, std::size_t depth, Drawing& drawing,
                                                   ltl::Random& random) const {
  if (++drawing.parts > longest_text) throw TooLong();
  if (category == "N") {
    const std::string place = " #" + std::to_string(++drawing.places) + " ";
    return {place, place};
  }
  const auto& rules = rules_.at(category);
  double total = 0;
  for (const Rule& rule : rules) total += rule.weight;
  double drawn = random.unit() * total;
  std::size_t chosen = 0;
  while (chosen + 1 < rules.size() && (drawn -= rules[chosen].weight) >= 0) ++chosen;
  if (depth > deepest) chosen = 0;  // the first rule of a category is its simplest
  Draft out;
  std::vector<std::string> parts;
  const std::string text = expand(rules[chosen].text, random);
  for (std::size_t at = 0; at < text.size();) {
    if (text[at] != '<') {
      out.text += text[at++];
      continue;
    }
    const std::size_t end = text.find('>', at);
    const std::string name = text.substr(at + 1, end - at - 1);
    at = end + 1;
    if (name[0] == '#') {
      out.text += parts.at(std::stoul(name.substr(1)) - 1);
      continue;
    }
    Draft part = draw(name, depth + 1, drawing, random);
    out.text += part.text;
    if (out.text.size() > longest_text) throw TooLong();
    parts.push_back(std::move(part.lifted));
  }
  std::istringstream words(rules[chosen].lifted);
  for (std::string word; words >> word;) {
    const bool refers = std::isdigit(static_cast<unsigned char>(word[0])) != 0;
    out.lifted += " " + (refers ? parts.at(std::stoul(word) - 1) : word[0] == '=' ? word.substr(1) : word);
  }
  return out;
}

SynchronousGrammar::Said SynchronousGrammar::say(const std::string& category, ltl::Random& random,
                                                 std::size_t most_tokens) const {
  if (!rules_.contains(category)) throw ltl::FormatError(source_, 0, 0, "no category is called '" + category + "'");
  for (std::size_t attempt = 0; attempt < most_attempts; ++attempt) {
    try {
      Drawing drawing;
      if (auto said = said_of(draw(category, 0, drawing, random), most_tokens)) return *std::move(said);
    } catch (const TooLong&) {
    }
  }
  throw ltl::FormatError(source_, 0, 0, "no short text of category '" + category + "' was drawn");
}

std::optional<SynchronousGrammar::Said> SynchronousGrammar::said_of(const Draft& draft, std::size_t most_tokens) const {
  Said said;
  std::map<std::string, std::string> renamed;
  std::istringstream words(draft.text);
  for (std::string word; words >> word;) {
    const std::string core = word.substr(0, word.find_first_of(",.;:!?"));
    if (core.size() > 1 && core[0] == '#') {
      const auto [it, _] = renamed.try_emplace(core, "#" + std::to_string(renamed.size() + 1));
      said.tokens.push_back(it->second);
      for (const char mark : word.substr(core.size())) said.tokens.emplace_back(1, mark);
    } else {
      for (std::string& token : tokenize(word)) said.tokens.push_back(std::move(token));
    }
  }
  said.slots = renamed.size();
  if (said.slots > 8 || said.tokens.size() > most_tokens) return std::nullopt;
  std::string lifted;
  std::istringstream symbols(draft.lifted);
  for (std::string symbol; symbols >> symbol;) {
    const auto slot = renamed.find(symbol);
    if (symbol[0] == '#' && slot == renamed.end())
      throw ltl::FormatError(source_, 0, 0, "a formula speaks of " + symbol + ", which its text does not name");
    lifted += " " + (slot == renamed.end() ? symbol : slot->second);
  }
  try {
    said.lifted = canonical(parse_lifted(lifted));
  } catch (const std::invalid_argument& error) {
    throw ltl::FormatError(source_, 0, 0, "'" + lifted + "': " + error.what());
  }
  if (said.lifted.size() >= LiftedPrefix::most_symbols - 8) return std::nullopt;
  return said;
}

}  // namespace waymark::parser

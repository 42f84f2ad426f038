#include "libparser/supervision/lexical_overlap.hpp"

#include <algorithm>
#include <map>

#include "libparser/lexicon/lexicon.hpp"

namespace waymark::parser {
namespace {

constexpr std::uint16_t no_column = UINT16_MAX;

std::uint16_t column_of(const Columns& columns, const Part& part) {
  const auto it = std::find(columns.parts.begin(), columns.parts.end(), part);
  if (it == columns.parts.end()) return no_column;
  return static_cast<std::uint16_t>(columns.tokens + static_cast<std::size_t>(it - columns.parts.begin()));
}

}  // namespace

Wording::Wording(const ProgramLanguage& language, const std::vector<Part>& mentions)
    : language_(&language), unsaid_(language.columns().size()) {
  const Columns& columns = language.columns();
  left_ = column_of(columns, thing("left"));
  right_ = column_of(columns, thing("right"));
  for (std::size_t i = 0; i < columns.parts.size(); ++i) unsaid_[columns.tokens + i] = in_lexicon(columns.parts[i]);
  std::map<std::string, std::vector<std::uint16_t>> topics;  // a number is one topic: it counts, or names a place
  for (const Part& mention : mentions) {
    const std::uint16_t column = column_of(columns, mention);
    if (column == no_column) continue;
    topics[mention.name].push_back(column);
    unsaid_[column] = false;
  }
  for (auto& [name, topic] : topics) topics_.push_back(std::move(topic));
}

std::vector<std::uint16_t> Wording::named_by(const Program& program) const {
  const Columns& columns = language_->columns();
  std::vector<std::uint16_t> named;
  for (const Step& step : program) {
    if (step.kind == StepKind::Forward) named.push_back(columns.thing[PostfixGrammar::first_forward + step.count - 1U]);
    for (std::uint16_t p : step.literals()) {
      const Token token = PostfixGrammar::literal(p);
      named.push_back(columns.thing[token]);
      const plan::Observable& observable = language_->observables()[p];
      if (observable.kind == plan::Kind::Event) continue;  // its side is its thing
      if (observable.direction == plan::Direction::Left && left_ != no_column) named.push_back(left_);
      if (observable.direction == plan::Direction::Right && right_ != no_column) named.push_back(right_);
    }
  }
  std::sort(named.begin(), named.end());
  named.erase(std::unique(named.begin(), named.end()), named.end());
  return named;
}

double Wording::lexical_overlap_penalty(const Program& program) const {
  const std::vector<std::uint16_t> named = named_by(program);
  const auto names = [&](std::uint16_t column) { return std::binary_search(named.begin(), named.end(), column); };
  double sum = 0;
  for (const auto& topic : topics_)
    if (std::none_of(topic.begin(), topic.end(), names)) sum += missing;
  for (std::uint16_t column : named)
    if (unsaid_[column]) sum += added;
  return sum;
}

}  // namespace waymark::parser

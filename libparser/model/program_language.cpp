#include "libparser/model/program_language.hpp"

#include <map>
#include <string>
#include <utility>

#include "libltl/diagnostic.hpp"
#include "libplan/world/labelling.hpp"

namespace waymark::parser {
namespace {

// A turn shares no direction with things seen to its side: the side is its thing. Nor do place numbers with `here`.
std::pair<Part, Part> parts_of(const plan::Observable& observable) {
  const auto direction = [](std::string name) { return Part{PartKind::Direction, std::move(name), 0}; };
  const std::string& side = plan::word_of(observable.direction);
  if (observable.kind == plan::Kind::Event && observable.direction != plan::Direction::Here)
    return {direction(observable.name), thing(side)};
  if (observable.kind == plan::Kind::PlaceNumber) return {direction("place"), thing(observable.name)};
  return {direction(side), thing(observable.name)};
}

}  // namespace

Columns::Columns(const PostfixGrammar& grammar, const std::vector<plan::Observable>& observables)
    : tokens(grammar.tokens()) {
  std::map<Part, std::uint16_t> index;
  const auto column = [&](const Part& part) {
    const auto [it, is_new] = index.try_emplace(part, static_cast<std::uint16_t>(size()));
    if (is_new) parts.push_back(part);
    return it->second;
  };
  mention = column({PartKind::Mention, "mention", 0});
  for (std::size_t t = 0; t < tokens; ++t) {
    const auto token = static_cast<Token>(t);
    if (grammar.is_literal(token)) {
      const auto [towards, what] = parts_of(observables[t - PostfixGrammar::first_literal]);
      direction.push_back(column(towards));
      thing.push_back(column(what));
    } else if (t >= PostfixGrammar::first_forward && t < PostfixGrammar::first_literal) {
      direction.push_back(column({PartKind::Forward, "forward", 0}));
      thing.push_back(column(count(t - PostfixGrammar::first_forward + 1)));
    } else {
      direction.push_back(column({PartKind::Operator, "operator", 0}));
      thing.push_back(column({PartKind::OperatorName, grammar.name(token), 0}));
    }
  }
}

ProgramLanguage::ProgramLanguage(const ltl::Vocabulary& vocabulary, PostfixGrammar::Limits limits)
    : vocabulary_(vocabulary),
      observables_(plan::observables_of(vocabulary)),
      grammar_(vocabulary, limits),
      columns_(grammar_, observables_) {}

void ProgramLanguage::check_vocabulary(const ltl::Vocabulary& vocabulary, std::string_view whose) const {
  if (vocabulary == vocabulary_) return;
  const std::string message = "the model was trained on other names than those of " + std::string(whose) +
                              " (waymark train makes one for these): ";
  for (const std::string& name : vocabulary_.names()) {
    if (vocabulary.find(name)) continue;
    throw ltl::FormatError("", 0, 0, message + "'" + name + "' is missing there");
  }
  for (const std::string& name : vocabulary.names()) {
    if (vocabulary_.find(name)) continue;
    throw ltl::FormatError("", 0, 0, message + "the model does not know '" + name + "'");
  }
  throw ltl::FormatError("", 0, 0, message + "the same names stand in another order");
}

}  // namespace waymark::parser

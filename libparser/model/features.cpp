#include "libparser/model/features.hpp"

#include <algorithm>

#include "libparser/corpus/token.hpp"
#include "libparser/lexicon/lexicon.hpp"

namespace waymark::parser {
namespace {

enum Template : std::uint64_t {
  Bias = 1,
  Word,
  Pair,
  SkipPair,
  ClauseWord,
  ClausePair,
  ClausesLeft,
  Length,
  Unknown,
  LastToken,
  LastTwoTokens,
  Mention
};

// template 8 bits | context 8 | a 24 | b 24
std::uint64_t key(Template which, std::uint64_t context, std::uint64_t a = 0, std::uint64_t b = 0) {
  return static_cast<std::uint64_t>(which) << 56U | (context & 0xFFU) << 48U | (a & 0xFFFFFFU) << 24U | (b & 0xFFFFFFU);
}

std::uint64_t context_of(std::size_t kind, std::size_t step) {
  return kind * choice_steps + std::min(step, choice_steps - 1);
}

class Extractor {
 public:
  Extractor(const SentenceInput& input, std::vector<WordId> ids)
      : input_(input), ids_(std::move(ids)), clauses_(clauses_of(input.tokens)) {}

  SentenceFeatures features(std::size_t steps) const {
    SentenceFeatures out;
    for (std::size_t kind = 0; kind < choice_kinds; ++kind) {
      out.by_context[kind].resize(steps);
      for (std::size_t step = 0; step < steps; ++step) add(out.by_context[kind][step], kind, step);
    }
    out.mentions = mentions(input_.tokens);
    for (const std::string& word : input_.tokens) {
      const std::size_t n = number_named(word);
      if (n >= out.places.size()) out.places.resize(n + 1, false);
      out.places[n] = n > 0;
    }
    return out;
  }

 private:
  WordId id(std::size_t i, const Clause& clause) const {  // i counts from 1, 0 is the beginning
    if (i == clause.begin) return WordTable::begin;
    return i == clause.end + 1 ? WordTable::end : ids_[i - 1];
  }

  void add_words(std::vector<std::uint64_t>& keys, const Clause& clause, std::uint64_t context, Template word,
                 Template pair, bool skips) const {
    for (std::size_t i = clause.begin; i <= clause.end; ++i) {
      const WordId a = id(i, clause), b = id(i + 1, clause);
      if (i > clause.begin && a != WordTable::unknown) keys.push_back(key(word, context, a.index));
      if (a != WordTable::unknown && b != WordTable::unknown) keys.push_back(key(pair, context, a.index, b.index));
      if (!skips || i + 1 > clause.end) continue;
      const WordId c = id(i + 2, clause);
      if (a != WordTable::unknown && c != WordTable::unknown) keys.push_back(key(SkipPair, context, a.index, c.index));
    }
  }

  void add(std::vector<std::uint64_t>& keys, std::size_t kind, std::size_t step) const {
    const std::uint64_t context = context_of(kind, step), unknown = input_.heading_unknown ? 1 : 0;
    keys.push_back(key(Bias, context));
    keys.push_back(key(Unknown, context, unknown));
    keys.push_back(key(Length, context, std::min<std::size_t>(ids_.size(), 12)));
    add_words(keys, {0, ids_.size()}, context, Word, Pair, true);
    const std::size_t clause = std::min(step, clauses_.size() - 1);
    add_words(keys, clauses_[clause], kind, ClauseWord, ClausePair, false);
    const std::size_t left = clauses_.size() > step ? std::min<std::size_t>(clauses_.size() - step, 3) : 0;
    keys.push_back(key(ClausesLeft, kind, left, std::min(step, choice_steps - 1)));
    std::sort(keys.begin(), keys.end());
    keys.erase(std::unique(keys.begin(), keys.end()), keys.end());
    if (unknown == 1)
      for (const WordId word : ids_)
        if (word != WordTable::unknown) keys.push_back(key(Unknown, kind, 2, word.index));
  }

  const SentenceInput& input_;
  std::vector<WordId> ids_;
  std::vector<Clause> clauses_;
};

}  // namespace

Choice first_choice() { return {}; }

Choice choice_after(const PrefixState& state, const Choice& choice, Token taken) {
  Choice next;
  next.kind = static_cast<std::uint8_t>(std::min<std::size_t>(state.goals, choice_kinds - 1));
  next.step = state.steps;
  next.last = static_cast<Token>(taken + 1);
  next.before_last = choice.last;
  return next;
}

SentenceFeatures sentence_features(const SentenceInput& input, WordTable& words, std::size_t steps) {
  std::vector<WordId> ids;
  for (const std::string& word : input.tokens) ids.push_back(words.add(word));
  return Extractor(input, std::move(ids)).features(steps);
}

SentenceFeatures sentence_features(const SentenceInput& input, const WordTable& words, std::size_t steps) {
  std::vector<WordId> ids;
  for (const std::string& word : input.tokens) ids.push_back(words.find(word));
  return Extractor(input, std::move(ids)).features(steps);
}

std::uint64_t last_token_feature(const Choice& c) { return key(LastToken, context_of(c.kind, c.step), c.last); }
std::uint64_t last_two_tokens_feature(const Choice& c) { return key(LastTwoTokens, c.kind, c.last, c.before_last); }

std::uint64_t mention_feature(const Choice& c) { return key(Mention, context_of(c.kind, c.step)); }

std::vector<bool> forbidden_tokens(const ProgramLanguage& language, const SentenceFeatures& features) {
  const PostfixGrammar& grammar = language.grammar();
  std::vector<bool> forbidden(grammar.tokens(), false);
  const auto propositions = static_cast<std::uint16_t>(language.vocabulary().size());
  for (std::uint16_t p = 0; p < propositions; ++p)
    if (!grammar.usable(p)) forbidden[PostfixGrammar::literal(p)] = true;
  const std::vector<std::size_t> numbers = place_numbers(language);
  for (std::uint16_t p = 0; p < propositions; ++p) {
    const std::size_t n = numbers[p];
    const bool named = n < features.places.size() && features.places[n];
    if (n > 0 && !named) forbidden[PostfixGrammar::literal(p)] = true;
  }
  return forbidden;
}

std::vector<std::size_t> place_numbers(const ProgramLanguage& language) {
  std::vector<std::size_t> numbers;
  for (const auto& [direction, kind, name] : language.observables())
    numbers.push_back(kind == plan::Kind::PlaceNumber ? number_named(name) : 0);
  return numbers;
}

}  // namespace waymark::parser

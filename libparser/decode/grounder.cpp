#include "libparser/decode/grounder.hpp"

#include <utility>

namespace waymark::parser {

template class BestFirst<Scorer>;
template class BestFirst<NetworkScorer>;

namespace {

std::vector<Candidate> read_with(const LinearModel& model, const SentenceInput& input, std::size_t beam) {
  const SentenceFeatures features = sentence_features(input, model.words, model.language.steps());
  Scorer scorer(model, features);
  return best_programs(scorer, beam);
}

std::vector<Candidate> read_with(const NetworkModel& model, const SentenceInput& input, std::size_t beam) {
  return model.masks.lend([&](ChoiceMasks& masks) {
    const NetworkSentence sentence = model.network.sentence(input);
    NetworkScorer scorer(model.network, sentence, masks);
    return best_programs(scorer, beam);
  });
}

}  // namespace

std::vector<Candidate> read(const WordModel& model, const SentenceInput& input, std::size_t beam) {
  return std::visit([&](const auto& one) { return read_with(*one, input, beam); }, model);
}

Grounder grounder_of(LinearModel model) {
  auto ranking = std::make_shared<RankingModel>(model.language.vocabulary(), model.language.dialect());
  ranking->words = model.words;
  return {std::make_shared<const LinearModel>(std::move(model)), std::move(ranking)};
}

}  // namespace waymark::parser

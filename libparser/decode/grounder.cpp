#include "libparser/decode/grounder.hpp"

#include <utility>
#include <variant>

namespace waymark::parser {

template class BestFirst<Scorer>;
template class BestFirst<NetworkScorer>;

std::vector<Candidate> read(const WordModel& model, const SentenceInput& input, std::size_t beam) {
  const auto read_with = [&](auto& scorer) { return best_programs(scorer, beam); };
  return std::visit([&](const auto& one) { return with_scorer(*one, input, read_with); }, model);
}

Grounder grounder_of(LinearModel model) {
  auto ranking = std::make_shared<RankingModel>(model.language.vocabulary(), model.language.dialect());
  ranking->words = model.words;
  return {std::make_shared<const LinearModel>(std::move(model)), std::move(ranking)};
}

}  // namespace waymark::parser

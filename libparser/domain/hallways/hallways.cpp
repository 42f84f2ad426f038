#include "libparser/domain/hallways/hallways.hpp"

#include "libparser/corpus/token.hpp"

namespace waymark::parser {

CandidateFeatures Hallways::features(const Text& text, const Candidates& candidates) const {
  SentenceInput input = text.instance->example->input;
  if (text.mirrored) input.tokens = mirror(input.tokens);
  RerankerSentence sentence(*model_, input, text.mirrored);
  for (const auto& [route, mass] : candidates)
    sentence.add_end(executors_[map_of(text)], route.start, route.plan, mass);
  return sentence.take();
}

bool Hallways::right(const RankingInstance& instance, const Route& route) {
  const GoldRoute& gold = instance.example->gold;
  return instance.asks == RankingInstance::Question::End ? route.plan.end == gold.end : route.start == gold.start;
}

}  // namespace waymark::parser

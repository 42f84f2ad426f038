#include "libparser/decode/beam.hpp"

#include <queue>
#include <stdexcept>

namespace waymark::parser {
namespace {

constexpr float least = -12.0F;  // log-probability below which a prefix is not worth keeping

struct Prefix {
  PrefixState state;
  Choice choice;
  std::int32_t parent;  // −1: the empty prefix
  Token token;          // the choice that led here
  float log_probability;
};

struct Later {
  const std::vector<Prefix>* prefixes;
  bool operator()(std::int32_t a, std::int32_t b) const {
    const float p = (*prefixes)[static_cast<std::size_t>(a)].log_probability;
    const float q = (*prefixes)[static_cast<std::size_t>(b)].log_probability;
    return p != q ? p < q : a > b;
  }
};

PrefixState take_forced(const PostfixGrammar& grammar, PrefixState state) {
  while (const auto token = grammar.forced(state)) state = grammar.after(state, *token);
  return state;
}

Program program_to(const PostfixGrammar& grammar, const std::vector<Prefix>& prefixes, std::int32_t at) {
  std::vector<Token> choices;
  for (; prefixes[static_cast<std::size_t>(at)].parent >= 0;
       at = prefixes[static_cast<std::size_t>(at)].parent)
    choices.push_back(prefixes[static_cast<std::size_t>(at)].token);
  return grammar.program_of(std::vector<Token>(choices.rbegin(), choices.rend()));
}

}  // namespace

std::vector<Candidate> best_programs(Scorer& scorer, const PostfixGrammar& grammar, std::size_t beam,
                                     std::size_t expansions) {
  std::vector<Prefix> prefixes{{PrefixState{}, first_choice(), -1, 0, 0.0F}};
  std::priority_queue<std::int32_t, std::vector<std::int32_t>, Later> open(Later{&prefixes});
  open.push(0);
  std::vector<Candidate> found;
  std::vector<float> log_p(grammar.tokens());
  while (!open.empty() && found.size() < beam) {
    const std::int32_t at = open.top();
    open.pop();
    const Prefix prefix = prefixes[static_cast<std::size_t>(at)];
    if (prefix.state.ended) {
      found.push_back({program_to(grammar, prefixes, at), prefix.log_probability});
      continue;
    }
    if (expansions-- == 0) break;
    const TokenRanges choices = grammar.choices(prefix.state);
    scorer.log_probabilities(scorer.groups(prefix.choice), choices, log_p.data());
    choices.each([&](Token token) {
      const float log_probability = prefix.log_probability + log_p[token];
      if (log_probability < least) return;
      const PrefixState state = take_forced(grammar, grammar.after(prefix.state, token));
      prefixes.push_back({state, choice_after(state, prefix.choice, token), at, token, log_probability});
      open.push(static_cast<std::int32_t>(prefixes.size() - 1));
    });
  }
  return found;
}

std::vector<Candidate> LinearReader::read(const SentenceInput& input, std::size_t beam) const {
  const SentenceFeatures features = sentence_features(input, model_->words, steps_of(*model_));
  Scorer scorer(*model_, features);
  return best_programs(scorer, model_->grammar(), beam);
}

Grounder grounder_of(LinearModel model) {
  auto shared = std::make_shared<const LinearModel>(std::move(model));
  return {std::make_shared<const LinearReader>(shared), shared};
}

LinearModel linear_model_of(const Grounder& grounder) {
  const auto* linear = dynamic_cast<const LinearReader*>(grounder.reader.get());
  if (linear == nullptr) throw std::invalid_argument("the reader is not a linear one");
  LinearModel model = linear->model();
  model.reranker = grounder.model->reranker;
  model.start_pose_model = grounder.model->start_pose_model;
  return model;
}

}  // namespace waymark::parser

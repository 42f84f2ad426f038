#include "libparser/experiment/follower.hpp"

namespace waymark::parser {

std::vector<Response> Follower::follow_all(const Executor& executor, std::span<const SentenceInput> paragraph,
                                           plan::PoseId start) const {
  std::vector<Response> answers;
  for (SentenceInput input : paragraph) {
    input.heading_unknown = input.heading_unknown && answers.empty();
    answers.push_back(follow(executor, input, start));
    start = answers.back().end;
  }
  return answers;
}

}  // namespace waymark::parser

#include "libparser/supervision/judged.hpp"

#include <algorithm>

namespace waymark::parser {

bool agrees(const Executor& executor, const Program& program, const Judged& judged) {
  const auto satisfies = [&](const plan::Trajectory& trajectory) { return executor.satisfies(trajectory, program); };
  return std::all_of(judged.good.begin(), judged.good.end(), satisfies) &&
         std::none_of(judged.refused.begin(), judged.refused.end(), satisfies);
}

}  // namespace waymark::parser

// Learning the linear reader: the objective of learn.hpp, maximised by AdaGrad, one sentence at a time.
#pragma once
#include "libparser/training/learn.hpp"

namespace waymark::parser {

LinearModel learn_linear(std::span<const Example* const> examples, std::span<const Executor> executors,
                         const TrainOptions& options, const JobProgress& progress);

}  // namespace waymark::parser

// waymark evaluate on street corpora: the experiment, and what it prints.
#pragma once
#include <string>

#include "libparser/domain/streets/streets.hpp"
#include "tools/shell/subcommand.hpp"

namespace waymark::tools {

struct StreetExperiment {
  std::string corpus, test_corpus, predictions;  // the last two may be empty
  bool train_all = false, json = false;
  int threads = 1;
  streets::StreetOptions options;
};

ExitCode evaluate_streets(const StreetExperiment& experiment, const Session& session);

}  // namespace waymark::tools

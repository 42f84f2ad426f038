// Systems side by side, one map left out, beside the published rows: table 4 of the seed paper.
#pragma once
#include <string>

#include "libparser/training/learn.hpp"
#include "tools/shell/subcommand.hpp"

namespace waymark::tools {

struct CompareSystemsOptions {
  std::string corpus, test_corpus, data, directory;
  parser::TrainOptions train;
  std::size_t ensemble = 10;
  int epochs = 0;
  bool absolute = true, relative = true, json = false;
  bool tell_place_numbers = false;
};

// Goes on from what is kept in `directory`, and prints.
ExitCode compare_systems(const CompareSystemsOptions& options, const Session& session);

}  // namespace waymark::tools

// Table 4 of the paper: systems, one map left out, beside the published rows.
#pragma once
#include <string>

#include "libparser/training/learn.hpp"
#include "tools/shell/subcommand.hpp"

namespace waymark::tools {

struct Table4Options {
  std::string corpus, test_corpus, data, directory;
  parser::TrainOptions train;
  std::size_t ensemble = 10;
  int epochs = 0;
  bool absolute = true, relative = true, json = false;
};

// Goes on from what is kept in `directory`, and prints.
ExitCode run_table4(const Table4Options& options, const Session& session);

}  // namespace waymark::tools

// Grounding models: the one that comes with waymark, or a file of one's own.
#pragma once
#include <span>
#include <string>
#include <vector>

#include "libparser/corpus.hpp"
#include "libparser/ground.hpp"
#include "libparser/learn.hpp"
#include "tools/shell/input.hpp"

namespace CLI {
class App;
}

namespace waymark::tools {

struct ModelOptions {
  std::string file;  // empty: models/linear.waymark of the data directory
};
void add_model_options(CLI::App& command, ModelOptions& options);
parser::LinearModel read_model(const ModelOptions& options, const std::string& data);

// Adds --model KIND, what train and evaluate make: linear is the only kind so far.
void add_model_kind_option(CLI::App& command, std::string& kind);

// --seed, --epochs, --threads.
void add_training_options(CLI::App& command, parser::TrainOptions& options);

// Those that came with the corpus, else those that come with waymark.
std::vector<plan::Map> maps_of(const parser::Corpus& corpus, const std::string& data);

// The readings of one instruction on a map, at least one, best first. Throws ltl::FormatError when the text says
// nothing that could be read.
std::vector<parser::Reading> read_instruction(const parser::LinearModel& model, const Text& text,
                                              const plan::Map& map, std::span<const plan::PoseId> starts,
                                              ltl::Arena& arena);

}  // namespace waymark::tools

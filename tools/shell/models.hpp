// Grounding models: the one that comes with waymark, or a file of one's own.
#pragma once
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "libparser/corpus/corpus.hpp"
#include "libparser/ground.hpp"
#include "libparser/training/learn.hpp"
#include "tools/shell/command.hpp"
#include "tools/shell/input.hpp"

namespace waymark::tools {

struct ModelOptions {
  std::string file;  // empty: models/encoder-decoder.waymark of the data directory
};
void add_model_options(Command command, ModelOptions& options);
std::string checksum_of_model(const ModelOptions& options, const std::string& data);  // "-" of standard input
parser::Grounder read_model(const ModelOptions& options, const std::string& data);

// What train and evaluate make, and how: --model KIND, --seed, --epochs, --threads, and those of the encoder-decoder.
struct TrainingOptions {
  parser::TrainOptions train;
  std::string model = "linear";
  int epochs = 0;  // 0: what is usual for the model
  bool plain = false;
  bool tell_place_numbers = false;  // of a corpus of hallways; else "position 5" is heard as "position"
  std::optional<parser::Dialect> dialect;
  // With what depends on several of them. `usual`: the programs when none are named.
  parser::TrainOptions settled(parser::Dialect usual = parser::Dialect::Plain) const;
};
void add_training_options(Command command, TrainingOptions& options, const std::vector<std::string>& models);

std::string told_or_hidden(bool tell_place_numbers);  // "told", "hidden"

// --corpus DIR, and the grid, the convention: spelled alike where corpora are learned from.
void add_corpus_option(Command command, std::string& corpus, bool required = true);
void add_convention_option(Command command, std::string& convention, const std::vector<std::string>& names);

// Maps of the data directory.
std::vector<plan::Map> shipped_maps(const std::string& data);
// Those that came with the corpus, else those that come with waymark.
std::vector<plan::Map> maps_of(const parser::Corpus& corpus, const std::string& data);

// The readings of one instruction on a map, at least one, best first. Throws ltl::FormatError when the text says
// nothing that could be read.
std::vector<parser::Reading> read_instruction(const parser::Grounder& model, const Text& text, const plan::Map& map,
                                              std::span<const plan::PoseId> starts, ltl::Arena& arena);

}  // namespace waymark::tools

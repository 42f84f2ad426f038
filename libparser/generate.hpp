// Route instructions of our own, with the trajectories that planning gives them: a corpus for tests and for training
// where no other is at hand.
#pragma once
#include <cstddef>
#include <cstdint>
#include <span>

#include "libparser/corpus.hpp"
#include "libparser/program.hpp"

namespace waymark::parser {

struct GenerateOptions {
  std::uint64_t seed = 1;
  std::size_t paragraphs = 100;  // spread over the maps
  std::size_t sentences = 4;     // of each paragraph
};

// Sentences of a small grammar (turns, counts, landmarks, floors, ends of halls, two things in one sentence), each said
// of a program that can be carried out where the speaker stands; trajectories are the programs' plans. Headings
// are known. Same seed, same corpus. The maps must share a vocabulary.
Corpus generate_corpus(std::span<const plan::Map> maps, const GenerateOptions& options = {});

}  // namespace waymark::parser

// The parts that commands of learning share: reading the corpus, and reporting errors of learning.
#pragma once
#include <stdexcept>
#include <string>

#include "libltl/diagnostic.hpp"
#include "libparser/corpus/corpus.hpp"
#include "libparser/training/learn.hpp"
#include "tools/shell/exit_code.hpp"

namespace waymark::tools {

// Of sentences on hallway maps, the numbers of places told or hidden (supervision/place_numbers.hpp).
// Throws ltl::FormatError, also for a corpus of streets, which it names.
parser::Corpus read_hallway_corpus(const std::string& directory, bool tell_place_numbers);

// step(), which learns from that corpus: Interrupted when it was stopped, ltl::FormatError when there is too little of
// it.
template <class Step>
auto learn_from(const std::string& corpus, Step step) {
  try {
    return step();
  } catch (const parser::Stopped&) {
    throw Interrupted();
  } catch (const std::invalid_argument& error) {
    throw ltl::FormatError(corpus, 0, 0, error.what());
  }
}

}  // namespace waymark::tools

// Schedulers without memory on the states of a model, as PRISM and Storm write them (docs/formats/prism.md).
//
// A scheduler with memory is one without on the product: compose it first (`waymark compose --format explicit`).
#pragma once
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "libplan/model/mdp.hpp"

namespace waymark::plan {

struct Scheduler {             // what is chosen in each state
  struct Choice {              // one that may be made
    std::uint32_t choice = 0;  // of the state
    double probability = 1;    // that it is
  };
  std::vector<std::vector<Choice>> choices;  // by state, each of them once; empty: not defined
};

// A text that begins with '[' is Storm's (--exportscheduler FILE.json), any other is PRISM's (-exportstrat FILE, with
// actions or indices). Throws ltl::FormatError, with the line where there are lines: a state or choice that the model
// does not have, a scheduler with memory, probabilities that do not add up to 1 (up to 1e-9).
Scheduler parse_scheduler(std::string_view text, std::string_view source, const Mdp& model);

enum class SchedulerFormat : std::uint8_t { Prism, Storm };  // whose files
// Defined states only. PRISM's says actions, or indices in a state two of whose choices share a name. Throws
// std::invalid_argument for PRISM's of a scheduler that draws.
std::string write_scheduler(const Scheduler& scheduler, SchedulerFormat format, const Mdp& model);

// The Markov chain of the scheduler: the model with one choice for each state. Its cost is the expected one. A state
// that is not defined keeps its only choice; with several it has none, and runs end there. O(model).
Mdp induced(const Mdp& model, const Scheduler& scheduler);

}  // namespace waymark::plan

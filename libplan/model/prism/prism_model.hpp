// The states that a program can reach, as a Markov decision process.
#pragma once
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "libltl/limits.hpp"
#include "libplan/model/mdp.hpp"
#include "libplan/model/prism/prism_program.hpp"

namespace waymark::plan {

struct ReadingStopped {};  // thrown

// What a model is wanted for.
struct PrismView {
  std::vector<PrismProgram::Label> labels;  // that become propositions
  std::optional<std::size_t> rewards;       // the structure that becomes costs; none: 1 a choice
  bool state_rewards_only = false;          // rewards of actions cost nothing
  const ModelText* labelled_by = nullptr;   // the text that errors of labels are about; none: that of the model
};

// States are numbered breadth first. The choices of a state come in the order of the modules and commands; an action of
// several modules stands where the first of them has it, once for every way to combine their commands. In a Markov
// chain, commands that are enabled together are drawn with equal chances. Throws ltl::SyntaxError for what a state
// shows to be wrong and for more states than the limit; ReadingStopped.
Mdp explore(const PrismProgram& program, PrismExpressions& expressions, const ModelText& text, const PrismView& view,
            const ltl::Limits& limits);

}  // namespace waymark::plan

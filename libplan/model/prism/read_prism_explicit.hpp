// Models in PRISM's explicit files [KNP11] (docs/formats/prism.md).
//
// Labels become propositions and rewards become costs, 1 a choice when there are none. A state without choices gets one
// that stays, "stay", as in PRISM.
#pragma once
#include <filesystem>
#include <optional>
#include <string>

#include "libplan/model/mdp.hpp"

namespace waymark::plan {

struct PrismFiles {                        // the contents
  std::string transitions;                 // .tra
  std::string labels;                      // .lab; the label "init" says where runs begin
  std::optional<std::string> states = {};  // .sta: names
  std::optional<std::string> state_rewards = {}, transition_rewards = {};  // .srew, .trew: added up
};

// States and choices keep their order. Throws ltl::FormatError with line and column; `prefix` names the files in
// messages.
Mdp parse_prism_explicit(const PrismFiles& files, const std::string& prefix = "");

// PREFIX.tra, and PREFIX.lab, .sta, .srew, .trew beside it; the last three may be missing.
Mdp read_prism_explicit(const std::filesystem::path& transitions);

}  // namespace waymark::plan

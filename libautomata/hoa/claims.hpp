// What a HOA file says of its automaton, and what its body says to that.
//
// Every claim under `properties:` that can be decided from the text is: where labels and marks are written,
// determinism, completeness, weakness of the components, and `acc-name:` against `Acceptance:`. Nothing is concluded
// from a claim anywhere in this library. unambiguous, stutter-invariant, tight and what we do not know are not checked;
// inherently-weak and terminal are refuted only where every component has uniform marks. [BBD+15, Sec. 4.2]
#pragma once
#include <string>
#include <vector>

#include "libautomata/hoa/syntax.hpp"

namespace waymark::automata {

struct HoaContradiction {
  HoaToken claim;      // the property, or the name of the acceptance
  std::string reason;  // "state 3 has two edges for one letter"
};

// In the order of the file. O(|body| · labels); the acceptance is compared on all sets of marks when there are at most
// 16, else on 65,536 pseudo-random ones. Diagrams of labels grow.
std::vector<HoaContradiction> contradictions(HoaAutomaton& automaton);

// The condition that `acc-name:` stands for; nullopt when the name is unknown or its parameters are wrong.
struct NamedCondition {
  std::uint64_t sets = 0;
  HoaCondition condition;
};
std::optional<NamedCondition> named_condition(const std::vector<HoaToken>& name);

bool holds(const HoaCondition& condition,
           std::uint64_t infinitely_often);  // sets 0 … 63; no complemented ones

}  // namespace waymark::automata

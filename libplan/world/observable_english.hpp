// What English calls the propositions of a hallway map: "go to the chair", "the chair is ahead", "turn left".
#pragma once
#include <functional>

#include "libltl/english/description.hpp"
#include "libltl/vocabulary.hpp"
#include "libplan/world/observable.hpp"

namespace waymark::plan {

ltl::Described described(const Observable& observable);  // the words for one observable

// Of each proposition of a hallway vocabulary, for ltl::VerbaliseOptions. Throws like observables_of.
std::function<ltl::Described(ltl::Proposition)> hallway_english(const ltl::Vocabulary& vocabulary);

}  // namespace waymark::plan

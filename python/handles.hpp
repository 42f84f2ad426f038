// What Python objects hold: a formula with its arena, a route with its map; and how letters and words come and go.
#pragma once
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "libautomata/finite/dfa.hpp"
#include "libautomata/finite/ltlf_to_dfa.hpp"
#include "libltl/formula.hpp"
#include "libltl/meaning/semantics.hpp"
#include "libltl/text/read_word.hpp"
#include "libplan/world/map.hpp"
#include "libplan/world/trajectory.hpp"

namespace waymark::python {

namespace py = pybind11;

// A formula keeps its arena alive. Formulas of different arenas are moved to one before they meet.
struct FormulaHandle {
  std::shared_ptr<ltl::Arena> arena;
  ltl::Formula formula;
  // The other formula in the arena of this one.
  ltl::Formula moved(const FormulaHandle& other) const { return ltl::transfer(other.formula, *arena); }
  FormulaHandle with(ltl::Formula f) const { return {arena, f}; }
};

// A limit was met, nothing is proved: waymark.LimitError.
struct LimitMet : std::runtime_error {
  using std::runtime_error::runtime_error;
};

// "finite" or "infinite"; ValueError otherwise.
ltl::Semantics semantics_of(const std::string& name);

// A letter is a text such as "{a, b}", or an iterable of names. Names that the vocabulary lacks are passed over, except
// where a growing vocabulary takes them up.
ltl::Letter letter_of(const py::handle& letter, const ltl::Vocabulary& vocabulary);
// A word is a text such as "{a}; ({b})w", or a sequence of letters, the cycle of a lasso apart.
ltl::AnyWord word_of(const py::handle& word, const py::handle& cycle, const ltl::Vocabulary& vocabulary);

py::frozenset names_of(const ltl::Letter& letter, const ltl::Vocabulary& vocabulary);
py::list letters_of(const ltl::Trace& word, const ltl::Vocabulary& vocabulary);
// (prefix, cycle)
py::tuple letters_of(const ltl::Lasso& word, const ltl::Vocabulary& vocabulary);

// Waits for the job in a thread of its own, without Python's lock; Ctrl-C stops the job and raises KeyboardInterrupt.
void wait_for(const std::function<void(std::stop_token)>& job);
template <class Job>
auto interruptible(const Job& job) {
  std::optional<decltype(job(std::stop_token()))> result;
  wait_for([&](std::stop_token stop) { result.emplace(job(std::move(stop))); });
  return std::move(*result);
}

// The value, or LimitMet.
template <class Value>
Value within_limits(std::variant<Value, automata::Exhausted> result) {
  if (const auto* exhausted = std::get_if<automata::Exhausted>(&result))
    throw LimitMet("gave up after " + std::to_string(exhausted->states) + " states");
  return std::get<Value>(std::move(result));
}

void bind_formulas(py::module_& m);
void bind_automata(py::module_& m);
void bind_maps(py::module_& m);
void bind_reading(py::module_& m);
void bind_environment(py::module_& m);

}  // namespace waymark::python

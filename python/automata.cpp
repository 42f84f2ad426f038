// Automata: translation, HOA in and out, runs, products, monitors.
#include <algorithm>

#include "libautomata/budget.hpp"
#include "libautomata/finite/product.hpp"
#include "libautomata/finite/run.hpp"
#include "libautomata/hoa/dot_finite.hpp"
#include "libautomata/hoa/dot_omega.hpp"
#include "libautomata/hoa/finite.hpp"
#include "libautomata/hoa/omega.hpp"
#include "libautomata/limit_deterministic/ltl_to_ldba.hpp"
#include "libautomata/monitor/conjunction.hpp"
#include "libautomata/omega/emptiness.hpp"
#include "libautomata/omega/lasso.hpp"
#include "libautomata/translation/ltl_to_buchi.hpp"
#include "libautomata/translation/ltl_to_parity.hpp"
#include "libltl/limits.hpp"
#include "libplan/solve/task_automaton.hpp"
#include "python/handles.hpp"

namespace waymark::python {
namespace {

using automata::StateId;

constexpr std::size_t most_edges = 1'000;  // of a picture: more cannot be read

template <class Any>
std::vector<std::string> reads_of(const Any& automaton) {
  std::vector<std::string> out;
  for (const ltl::Proposition p : automaton.reads()) out.push_back(automaton.vocabulary().name(p));
  return out;
}

template <class Any>
StateId state_of(const Any& automaton, std::uint32_t q) {
  if (q >= automaton.states()) throw py::index_error("there is no state " + std::to_string(q));
  return StateId{q};
}

ltl::Trace finite_word(const py::object& word, const ltl::Vocabulary& vocabulary) {
  auto read = word_of(word, py::none(), vocabulary);
  if (auto* trace = std::get_if<ltl::Trace>(&read)) return std::move(*trace);
  throw py::value_error("this automaton reads finite words, not a lasso");
}

ltl::Lasso infinite_word(const py::object& word, const py::object& cycle, const ltl::Vocabulary& vocabulary) {
  auto read = word_of(word, cycle, vocabulary);
  if (auto* lasso = std::get_if<ltl::Lasso>(&read)) return std::move(*lasso);
  throw py::value_error("this automaton reads infinite words: give a cycle, or the text of a lasso");
}

using AnyTranslated = std::variant<automata::Dfa, automata::Automaton, automata::MdpSafe>;

AnyTranslated translated(ltl::Formula f, const std::string& to, const ltl::Limits& limits) {
  if (to == "dfa") return within_limits(automata::ltlf_to_dfa(f, limits));
  if (to == "tgba") return within_limits(automata::ltl_to_tgba(f, limits)).automaton;
  if (to == "buchi") return within_limits(automata::ltl_to_buchi(f, limits)).automaton;
  if (to == "parity") return within_limits(automata::ltl_to_parity(f, limits)).automaton;
  if (to == "rabin") return within_limits(automata::ltl_to_rabin(f, limits)).automaton;
  if (to == "generic") return within_limits(automata::ltl_to_generic(f, limits)).automaton;
  if (to == "ldba") return within_limits(automata::ltl_to_ldba(f, limits)).automaton;
  throw std::invalid_argument("to is 'dfa', 'tgba', 'buchi', 'parity', 'rabin', 'generic' or 'ldba', not '" + to + "'");
}

AnyTranslated translate(const FormulaHandle& f, const std::string& to, std::size_t limit_states) {
  ltl::Arena arena;  // of the job alone
  const ltl::Formula own = ltl::transfer(f.formula, arena);
  return interruptible([&](std::stop_token stop) { return translated(own, to, {limit_states, std::move(stop)}); });
}

constexpr auto both = [](bool p, bool q) { return p && q; };
constexpr auto either = [](bool p, bool q) { return p || q; };
constexpr auto first_only = [](bool p, bool q) { return p && !q; };

automata::Dfa combined(const automata::Dfa& a, const automata::Dfa& b, automata::Verdict verdict) {
  return interruptible([&](std::stop_token stop) {
    automata::Budget budget(SIZE_MAX, SIZE_MAX, std::move(stop));
    return automata::product(a, b, verdict, budget);
  });
}

// δ as an array: row q, column Σ 2^i over the propositions i that hold; the order is that of `propositions`.
py::array_t<std::uint32_t> table_of(const automata::Dfa& dfa) {
  constexpr std::size_t most = 20;
  const std::size_t k = dfa.reads().size();
  if (k > most) throw py::value_error("a table of more than 20 propositions");
  const std::size_t letters = std::size_t{1} << k;
  py::array_t<std::uint32_t> out({dfa.states(), letters});
  auto cells = out.mutable_unchecked<2>();
  for (std::size_t bits = 0; bits < letters; ++bits) {
    ltl::Letter letter;
    for (std::size_t i = 0; i < k; ++i)
      if (((bits >> i) & 1U) != 0) letter.insert(dfa.reads()[i]);
    for (std::uint32_t q = 0; q < dfa.states(); ++q)
      cells(q, static_cast<py::ssize_t>(bits)) = dfa.next({q}, letter).index;
  }
  return out;
}

py::array_t<std::uint32_t> run_of(const automata::Dfa& dfa, const py::object& word) {
  const automata::Run run = automata::run(dfa, finite_word(word, dfa.vocabulary()));
  py::array_t<std::uint32_t> out(static_cast<py::ssize_t>(run.states.size()));
  auto cells = out.mutable_unchecked<1>();
  for (std::size_t i = 0; i < run.states.size(); ++i) cells(static_cast<py::ssize_t>(i)) = run.states[i].index;
  return out;
}

py::object difference_of(const automata::Dfa& a, const automata::Dfa& b) {
  const auto found = automata::difference(a, b);
  if (!found) return py::none();
  return py::make_tuple(letters_of(found->word, found->vocabulary), found->first_accepts);
}

void bind_dfa(py::module_& m) {
  using automata::Dfa;
  py::class_<Dfa>(m, "Dfa", "A complete deterministic automaton on finite words.")
      .def_property_readonly("states", &Dfa::states, "How many states there are; they are numbered from 0.")
      .def_property_readonly(
          "initial", [](const Dfa& a) { return a.initial().index; }, "The initial state.")
      .def_property_readonly("propositions", &reads_of<Dfa>, "The propositions that the automaton reads.")
      .def_property_readonly(
          "accepting",
          [](const Dfa& a) {
            py::array_t<bool> out(static_cast<py::ssize_t>(a.states()));
            for (std::uint32_t q = 0; q < a.states(); ++q) out.mutable_at(q) = a.is_accepting({q});
            return out;
          },
          "By state: may the word end here?")
      .def(
          "is_accepting", [](const Dfa& a, std::uint32_t q) { return a.is_accepting(state_of(a, q)); },
          py::arg("state"), "May the word end in the state?")
      .def(
          "is_trap", [](const Dfa& a, std::uint32_t q) { return a.is_trap(state_of(a, q)); }, py::arg("state"),
          "Is no accepting state reachable?")
      .def(
          "next",
          [](const Dfa& a, std::uint32_t q, const py::object& letter) {
            return a.next(state_of(a, q), letter_of(letter, a.vocabulary())).index;
          },
          py::arg("state"), py::arg("letter"), "The state after the letter.")
      .def(
          "accepts",
          [](const Dfa& a, const py::object& word) { return automata::accepts(a, finite_word(word, a.vocabulary())); },
          py::arg("word"), "Is the finite word accepted?")
      .def("run", &run_of, py::arg("word"), "The states that the word leads through, the initial one first.")
      .def("table", &table_of, "δ as an array: row of the state, column Σ 2ⁱ over the propositions i that hold.")
      .def(
          "shortest_word",
          [](const Dfa& a) -> py::object {
            const auto word = automata::shortest_word(a);
            return word ? py::object(letters_of(*word, a.vocabulary())) : py::none();
          },
          "A shortest accepted word; None when there is none.")
      .def("difference", &difference_of, py::arg("other"),
           "None when both accept the same words; else a shortest word on which they differ, and whether "
           "this one accepts it.")
      .def(
          "__and__", [](const Dfa& a, const Dfa& b) { return combined(a, b, both); }, "The words of both.")
      .def(
          "__or__", [](const Dfa& a, const Dfa& b) { return combined(a, b, either); }, "The words of either.")
      .def(
          "__sub__", [](const Dfa& a, const Dfa& b) { return combined(a, b, first_only); },
          "The words of this one alone.")
      .def(
          "hoa", [](const Dfa& a, const std::string& name) { return automata::write_hoa(a, {.name = name}); },
          py::arg("name") = "", "The automaton in the Hanoi format.")
      .def(
          "dot", [](const Dfa& a) { return automata::write_dot(a); }, "The automaton in the format of Graphviz.");
}

std::string dot_of(const automata::Automaton& a, const automata::OmegaDotOptions& options = {}) {
  const auto dot = automata::write_dot_within(a, most_edges, options);
  if (!dot) throw LimitMet("more than 1000 edges cannot be drawn");
  return *dot;
}

template <class Any>
py::object word_accepted_by(const automata::Automaton& a, const Any& owner) {
  const auto word = automata::find_lasso(a);
  return word ? py::object(letters_of(*word, owner.vocabulary())) : py::none();
}

void bind_omega(py::module_& m) {
  using automata::Automaton;
  py::class_<Automaton>(m, "OmegaAutomaton", "An automaton on infinite words, acceptance on its edges.")
      .def_property_readonly("states", &Automaton::states, "How many states there are; they are numbered from 0.")
      .def_property_readonly(
          "initial", [](const Automaton& a) { return a.initial().index; }, "The initial state.")
      .def_property_readonly("propositions", &reads_of<Automaton>, "The propositions that the automaton reads.")
      .def_property_readonly(
          "sets", [](const Automaton& a) { return a.acceptance().sets; }, "How many acceptance sets there are.")
      .def(
          "next",
          [](const Automaton& a, std::uint32_t q, const py::object& letter) {
            std::vector<std::pair<std::uint32_t, std::vector<std::uint32_t>>> out;
            for (const automata::Branch& b : a.next(state_of(a, q), letter_of(letter, a.vocabulary()))) {
              std::vector<std::uint32_t> marks;
              for (std::uint32_t mark = 0; mark < a.acceptance().sets; ++mark)
                if (b.marks.contains(mark)) marks.push_back(mark);
              out.emplace_back(b.target, std::move(marks));
            }
            return out;
          },
          py::arg("state"), py::arg("letter"), "The branches on the letter: (target, marks).")
      .def(
          "accepts",
          [](const Automaton& a, const py::object& word, const py::object& cycle) {
            return automata::accepts(a, infinite_word(word, cycle, a.vocabulary()));
          },
          py::arg("word"), py::arg("cycle") = py::none(), "Is the lasso accepted?")
      .def(
          "find_word", [](const Automaton& a) { return word_accepted_by(a, a); },
          "(prefix, cycle) of an accepted word; None when there is none.")
      .def(
          "hoa", [](const Automaton& a, const std::string& name) { return automata::write_hoa(a, {.name = name}); },
          py::arg("name") = "", "The automaton in the Hanoi format.")
      .def(
          "dot", [](const Automaton& a) { return dot_of(a); }, "The automaton in the format of Graphviz.");
}

std::string dot_with_jumps(const automata::MdpSafe& a) {
  automata::OmegaDotOptions options;
  for (std::uint32_t q = 0; q < a.states(); ++q)
    for (const StateId to : a.jumps({q})) options.jumps.emplace_back(q, to.index);
  return dot_of(automata::Automaton(a.vocabulary(), a.reads(), a.steps()), options);
}

void bind_limit_deterministic(py::module_& m) {
  using automata::MdpSafe;
  py::class_<MdpSafe>(m, "LimitDeterministic",
                      "A limit-deterministic Büchi automaton that is sound for Markov decision processes.")
      .def_property_readonly("states", &MdpSafe::states, "How many states there are; they are numbered from 0.")
      .def_property_readonly(
          "initial", [](const MdpSafe& a) { return a.initial().index; }, "The initial state.")
      .def_property_readonly("propositions", &reads_of<MdpSafe>, "The propositions that the automaton reads.")
      .def(
          "jumps",
          [](const MdpSafe& a, std::uint32_t q) {
            std::vector<std::uint32_t> out;
            for (const StateId to : a.jumps(state_of(a, q))) out.push_back(to.index);
            return out;
          },
          py::arg("state"), "Where a run may jump before the next letter.")
      .def(
          "next",
          [](const MdpSafe& a, std::uint32_t q,
             const py::object& letter) -> std::optional<std::pair<std::uint32_t, bool>> {
            const auto step = a.next(state_of(a, q), letter_of(letter, a.vocabulary()));
            if (!step) return std::nullopt;
            return std::pair(step->target.index, step->accepting);
          },
          py::arg("state"), py::arg("letter"), "(target, whether the edge accepts); None: the run is rejected.")
      .def(
          "in_accepting_part", [](const MdpSafe& a, std::uint32_t q) { return a.in_accepting_part(state_of(a, q)); },
          py::arg("state"), "Is the state in the accepting part, which no run leaves?")
      .def(
          "accepts",
          [](const MdpSafe& a, const py::object& word, const py::object& cycle) {
            return automata::accepts(a.automaton(), infinite_word(word, cycle, a.vocabulary()));
          },
          py::arg("word"), py::arg("cycle") = py::none(), "Is the lasso accepted?")
      .def(
          "hoa",
          [](const MdpSafe& a, const std::string& name) { return automata::write_hoa(a.automaton(), {.name = name}); },
          py::arg("name") = "", "A Büchi automaton of the same language in the Hanoi format, a branch for every jump.")
      .def("dot", &dot_with_jumps, "The automaton in the format of Graphviz, jumps dotted.");
}

const char* name_of(automata::Foresight verdict) {
  if (verdict == automata::Foresight::Open) return "open";
  return verdict == automata::Foresight::True ? "true" : "false";
}

// A monitor of the conjuncts, kept apart, and the formula to begin anew.
class RunningMonitor {
 public:
  RunningMonitor(const FormulaHandle& f, const std::string& semantics, std::size_t limit_states)
      : formula_(ltl::transfer(f.formula, *arena_)),
        words_(semantics_of(semantics) == ltl::Semantics::Finite ? automata::Words::Finite : automata::Words::Infinite),
        limit_states_(limit_states),
        monitor_(made()) {}

  void reset() { monitor_ = made(); }
  const char* read(const py::object& letter) {
    return name_of(monitor_.read(letter_of(letter, arena_->vocabulary())).foresight);
  }
  automata::MonitorVerdict verdict() const { return monitor_.verdict(); }

 private:
  automata::ConjunctionMonitor made() const {
    return interruptible([&](std::stop_token stop) {
      return within_limits(automata::ConjunctionMonitor::of(formula_, words_, {limit_states_, std::move(stop)}));
    });
  }

  std::unique_ptr<ltl::Arena> arena_ = std::make_unique<ltl::Arena>();
  ltl::Formula formula_;
  automata::Words words_;
  std::size_t limit_states_;
  automata::ConjunctionMonitor monitor_;
};

void bind_monitor(py::module_& m) {
  py::class_<RunningMonitor>(m, "Monitor", "The verdict of a growing word about a formula.")
      .def(py::init<const FormulaHandle&, const std::string&, std::size_t>(), py::arg("formula"),
           py::arg("semantics") = "infinite", py::arg("limit_states") = 1'000'000)
      .def("read", &RunningMonitor::read, py::arg("letter"), "Reads one letter; returns the verdict.")
      .def("reset", &RunningMonitor::reset, "Forgets all letters.")
      .def_property_readonly(
          "verdict", [](const RunningMonitor& r) { return name_of(r.verdict().foresight); },
          "'true': every continuation satisfies the formula; 'false': none does; else 'open'.")
      .def_property_readonly(
          "holds_now", [](const RunningMonitor& r) { return r.verdict().now; },
          "Over finite words, after a letter: does the word so far satisfy the formula? Else None.")
      .def_property_readonly(
          "is_known_satisfiable", [](const RunningMonitor& r) { return r.verdict().is_known_satisfiable; },
          "False: open, but whether some continuation satisfies the formula was not found out.");
}

}  // namespace

void bind_automata(py::module_& m) {
  bind_dfa(m);
  bind_omega(m);
  bind_limit_deterministic(m);
  bind_monitor(m);
  m.def("translate", &translate, py::arg("formula"), py::arg("to") = "dfa", py::arg("limit_states") = 1'000'000,
        "The automaton of a formula.");
  m.def(
      "from_hoa", [](const std::string& text) { return plan::read_given_automaton(text); }, py::arg("text"),
      "Reads one automaton; what says `properties: finite-words` is a Dfa.");
}

}  // namespace waymark::python

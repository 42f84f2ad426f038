// Formulas: text, progression, the definition of ⊨, English; random formulas.
#include <algorithm>
#include <string_view>

#include "libltl/english/verbalise.hpp"
#include "libltl/meaning/progress.hpp"
#include "libltl/meaning/semantics.hpp"
#include "libltl/meaning/trace_check.hpp"
#include "libltl/rewriting/simplify.hpp"
#include "libltl/structure/random.hpp"
#include "libltl/text/parse.hpp"
#include "libltl/text/print.hpp"
#include "libplan/world/observable_english.hpp"
#include "python/handles.hpp"

namespace waymark::python {
namespace {

using Names = std::optional<std::vector<std::string>>;

FormulaHandle parse(const std::string& text, const std::string& notation, const std::string& dialect,
                    const Names& propositions) {
  ltl::ParseOptions options;
  if (notation == "lbt")
    options.notation = ltl::Notation::Lbt;
  else if (notation == "postfix")
    options.notation = ltl::Notation::Postfix;
  else if (notation != "infix")
    throw py::value_error("notation is 'infix', 'lbt' or 'postfix', not '" + notation + "'");
  constexpr std::array dialects{"waymark", "spot", "nusmv", "psl"};  // in the order of Dialect
  const auto named = std::find(dialects.begin(), dialects.end(), dialect);
  if (named == dialects.end())
    throw py::value_error("dialect is 'waymark', 'spot', 'nusmv' or 'psl', not '" + dialect + "'");
  options.dialect = static_cast<ltl::Dialect>(named - dialects.begin());
  if (propositions) options.unknown = ltl::Unknown::Reject;
  const auto arena = std::make_shared<ltl::Arena>(propositions ? ltl::Vocabulary(*propositions) : ltl::Vocabulary());
  return {arena, ltl::parse(text, *arena, options)};
}

std::string text(const FormulaHandle& f, const std::string& style) {
  constexpr std::array names{"ascii", "unicode", "latex", "lbt", "postfix"};
  const auto at = std::find(names.begin(), names.end(), style);
  if (at == names.end())
    throw py::value_error("style is 'ascii', 'unicode', 'latex', 'lbt' or 'postfix', not '" + style + "'");
  return ltl::print(f.formula, static_cast<ltl::Style>(at - names.begin()));
}

const char* operator_of(const FormulaHandle& f) {
  switch (f.formula.op()) {
    case ltl::Op::False: return "false";
    case ltl::Op::True: return "true";
    case ltl::Op::Atom: return "atom";
    case ltl::Op::Not: return "not";
    case ltl::Op::And: return "and";
    case ltl::Op::Or: return "or";
    case ltl::Op::Iff: return "iff";
    case ltl::Op::Next: return "next";
    case ltl::Op::WeakNext: return "weak_next";
    case ltl::Op::Until: return "until";
    case ltl::Op::Yesterday: return "yesterday";
    case ltl::Op::Since: return "since";
    case ltl::Op::Release: break;
  }
  return "release";
}

std::vector<std::string> propositions_of(const FormulaHandle& f) {
  std::vector<std::string> out;
  for (const ltl::Proposition p : ltl::propositions(f.formula)) out.push_back(f.arena->vocabulary().name(p));
  return out;
}

// Equal formulas of different arenas have the same hash: nothing that depends on the order of operands counts.
std::size_t hash_of(const FormulaHandle& f) {
  std::vector<std::string> names = propositions_of(f);
  std::sort(names.begin(), names.end());
  std::size_t hash = ltl::tree_size(f.formula) * 31 + static_cast<std::size_t>(f.formula.op());
  for (const std::string& name : names) hash = hash * 1'000'003 + std::hash<std::string>{}(name);
  return hash;
}

bool holds(const FormulaHandle& f, const py::object& word, const py::object& cycle) {
  const auto read = word_of(word, cycle, f.arena->vocabulary());
  return std::visit([&](const auto& w) { return ltl::holds(w, f.formula); }, read);
}

// By position of a finite word: does its rest from there on satisfy the formula?
py::array_t<bool> truth(const FormulaHandle& f, const py::object& word) {
  const auto read = word_of(word, py::none(), f.arena->vocabulary());
  const auto* trace = std::get_if<ltl::Trace>(&read);
  if (trace == nullptr) throw py::value_error("truth is asked of a finite word");
  if (ltl::has_past(f.formula)) {
    const std::vector<bool> row = ltl::truth(*trace, f.formula);
    py::array_t<bool> out(static_cast<py::ssize_t>(row.size()));
    std::copy(row.begin(), row.end(), out.mutable_data());
    return out;
  }
  const ltl::Columns columns(*trace, f.arena->vocabulary().size());
  std::vector<std::uint64_t> bits(columns.blocks());
  ltl::TraceCheck(f.formula).at_every_position(columns, 0, bits);
  const std::size_t n = trace->size();
  py::array_t<bool> out(static_cast<py::ssize_t>(n));
  auto values = out.mutable_unchecked<1>();
  for (std::size_t i = 0; i < n; ++i)
    values(static_cast<py::ssize_t>(i)) = ((bits[(n - 1 - i) / 64] >> ((n - 1 - i) % 64)) & 1U) != 0;
  return out;
}

std::string english(const FormulaHandle& f, const std::string& semantics, const plan::Map* map) {
  ltl::VerbaliseOptions options{.semantics = semantics_of(semantics)};
  if (map == nullptr) return ltl::verbalise(f.formula, options);
  ltl::Arena arena(map->vocabulary());
  const ltl::Formula here = ltl::transfer(f.formula, arena);
  for (const ltl::Proposition p : ltl::propositions(here))
    if (p.index >= map->vocabulary().size()) throw plan::unknown_proposition(*map, arena.vocabulary().name(p));
  options.describe = plan::hallway_english(map->vocabulary());
  return ltl::verbalise(here, options);
}

std::vector<FormulaHandle> random_formulas(std::size_t count, std::uint64_t seed, std::size_t size,
                                           const std::vector<std::string>& propositions, const std::string& semantics) {
  ltl::Random random(seed);
  const bool finite = semantics_of(semantics) == ltl::Semantics::Finite;
  std::vector<FormulaHandle> out;
  for (std::size_t i = 0; i < count; ++i) {
    const auto arena = std::make_shared<ltl::Arena>(ltl::Vocabulary(propositions));
    const ltl::Formula f = ltl::random_formula(
        random, *arena, {.size = size, .atoms = arena->vocabulary().size(), .constants = false, .weak_next = finite});
    out.push_back({arena, f});
  }
  return out;
}

template <ltl::Formula (*combine)(ltl::Formula, ltl::Formula)>
FormulaHandle binary(const FormulaHandle& a, const FormulaHandle& b) {
  return a.with(combine(a.formula, a.moved(b)));
}
template <ltl::Formula (*make)(ltl::Formula)>
FormulaHandle unary(const FormulaHandle& f) {
  return f.with(make(f.formula));
}

void bind_operators(py::class_<FormulaHandle>& formula) {
  formula.def("__and__", &binary<ltl::conjunction>, "φ ∧ ψ")
      .def("__or__", &binary<ltl::disjunction>, "φ ∨ ψ")
      .def("__xor__", &binary<ltl::exclusive_or>, "exactly one of φ and ψ")
      .def("__rshift__", &binary<ltl::implies>, "φ → ψ")
      .def("__invert__", &unary<ltl::negate>, "¬φ")
      .def("iff", &binary<ltl::iff>, py::arg("other"), "φ ↔ ψ")
      .def("until", &binary<ltl::until>, py::arg("other"), "φ U ψ")
      .def("release", &binary<ltl::release>, py::arg("other"), "φ R ψ")
      .def("weak_until", &binary<ltl::weak_until>, py::arg("other"), "φ W ψ")
      .def("next", &unary<ltl::next>, "X φ: there is a next letter, and φ holds there")
      .def("weak_next", &unary<ltl::weak_next>, "N φ: if there is a next letter, φ holds there")
      .def("eventually", &unary<ltl::eventually>, "F φ")
      .def("always", &unary<ltl::always>, "G φ");
}

void bind_look(py::class_<FormulaHandle>& formula) {
  formula.def("__str__", [](const FormulaHandle& f) { return ltl::print(f.formula); })
      .def("__repr__",
           [](const FormulaHandle& f) {
             return "Formula(" + py::repr(py::str(ltl::print(f.formula))).cast<std::string>() + ")";
           })
      .def(
          "__eq__",
          [](const FormulaHandle& a, const FormulaHandle& b) {
            ltl::Arena arena;
            return ltl::transfer(a.formula, arena) == ltl::transfer(b.formula, arena);
          },
          py::is_operator())
      .def("__hash__", &hash_of)
      .def("_repr_latex_", [](const FormulaHandle& f) { return "$" + text(f, "latex") + "$"; })
      .def("text", &text, py::arg("style") = "ascii",
           "The formula as text: 'ascii', 'unicode', 'latex', 'lbt' or 'postfix'.")
      .def_property_readonly("operator", &operator_of, "The topmost operator: 'and', 'until', 'atom', …")
      .def_property_readonly(
          "operands",
          [](const FormulaHandle& f) {
            std::vector<FormulaHandle> out;
            for (const ltl::Formula g : f.formula.operands()) out.push_back(f.with(g));
            return py::tuple(py::cast(out));
          },
          "The operands of the topmost operator.")
      .def_property_readonly(
          "propositions", [](const FormulaHandle& f) { return py::tuple(py::cast(propositions_of(f))); },
          "The names of the propositions that occur.")
      .def_property_readonly(
          "size", [](const FormulaHandle& f) { return ltl::tree_size(f.formula); }, "Nodes of the syntax tree.");
}

}  // namespace

void bind_formulas(py::module_& m) {
  py::class_<FormulaHandle> formula(m, "Formula", "A formula of linear temporal logic; immutable.");
  formula.def(py::init(&parse), py::arg("text"), py::arg("notation") = "infix", py::arg("dialect") = "waymark",
              py::arg("propositions") = py::none(),
              "Reads a formula. With `propositions`, any other name is an error that names the nearest.");
  bind_look(formula);
  bind_operators(formula);
  formula
      .def(
          "simplify",
          [](const FormulaHandle& f, const std::string& semantics) {
            return f.with(ltl::simplify(f.formula, semantics_of(semantics)));
          },
          py::arg("semantics") = "finite", "A formula that holds on the same words and is no larger.")
      .def(
          "progress",
          [](const FormulaHandle& f, const py::object& letter, const std::string& semantics) {
            return f.with(ltl::progress(f.formula, letter_of(letter, f.arena->vocabulary()), semantics_of(semantics)));
          },
          py::arg("letter"), py::arg("semantics") = "finite", "What remains to be satisfied after the letter.")
      .def(
          "accepts_empty", [](const FormulaHandle& f) { return ltl::accepts_empty(f.formula); },
          "May the word end here? Asked of what progression leaves.")
      .def("holds", &holds, py::arg("word"), py::arg("cycle") = py::none(),
           "Does the word satisfy the formula, by definition? With a cycle, or the text of a lasso: for ever.")
      .def("truth", &truth, py::arg("word"), "By position of a finite word: does the rest satisfy the formula?")
      .def("english", &english, py::arg("semantics") = "finite", py::arg("map") = nullptr,
           "The formula in English, on a map in the words of the map.");
  m.def("random_formulas", &random_formulas, py::arg("count"), py::arg("seed") = 1, py::arg("size") = 12,
        py::arg("propositions") = std::vector<std::string>{"a", "b", "c"}, py::arg("semantics") = "finite",
        "Random formulas; the same seed gives the same ones on every machine.");
}

}  // namespace waymark::python

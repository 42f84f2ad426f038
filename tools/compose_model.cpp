#include "tools/compose_model.hpp"

#include <filesystem>
#include <ostream>
#include <sstream>
#include <stdexcept>
#include <utility>
#include <variant>

#include "libautomata/translation/ltl_to_parity.hpp"
#include "libltl/rewriting/simplify.hpp"
#include "libplan/model/formats/read_dimacs.hpp"
#include "libplan/model/formats/write_jani.hpp"
#include "libplan/model/prism/write_prism.hpp"
#include "libplan/product/explicit_product.hpp"
#include "libplan/product/product_game.hpp"
#include "tools/answer.hpp"
#include "tools/product_picture.hpp"
#include "tools/shell/exit_code.hpp"
#include "tools/shell/json.hpp"
#include "tools/shell/output.hpp"

namespace waymark::tools {
namespace {

using plan::StateLabelled;

Json letter_of(const StateLabelled& model, std::uint32_t s) {
  const plan::Letters& letters = model.mdp.letters();
  JsonArray out;
  for (ltl::Proposition p : letters[model.letter[s]].members()) out.add(letters.vocabulary().name(p));
  return out;
}

Json graph_of(const StateLabelled& model) {
  JsonArray states, choices;
  for (std::uint32_t s = 0; s < model.mdp.states(); ++s) {
    states.add(JsonObject().add("name", model.mdp.name(s)).add("letter", letter_of(model, s)));
    for (std::uint32_t k = 0; k < model.mdp.choices(s); ++k) {
      JsonArray outcomes;
      for (const plan::ModelOutcome& o : model.mdp.outcomes(s, k))
        outcomes.add(JsonObject().add("to", o.target).add("probability", o.probability));
      choices.add(JsonObject()
                      .add("from", s)
                      .add("action", model.mdp.action(s, k))
                      .add("cost", model.mdp.cost(s, k))
                      .add("outcomes", outcomes));
    }
  }
  return JsonObject().add("initial", model.mdp.initial()).add("states", states).add("choices", choices);
}

std::string quoted(const std::string& text) { return Json(text).text(); }

void print_dot(const StateLabelled& model, std::ostream& out) {
  out << "digraph model {\n  node [shape=box, style=rounded, fontname=\"Helvetica\", fontsize=11];\n"
      << "  edge [fontname=\"Helvetica\", fontsize=10];\n  start [shape=point]; start -> 0;\n";
  for (std::uint32_t s = 0; s < model.mdp.states(); ++s) {
    const plan::Letters& letters = model.mdp.letters();
    out << "  " << s
        << " [label=" << quoted(model.mdp.name(s) + ' ' + ltl::show(letters[model.letter[s]], letters.vocabulary()))
        << "];\n";
    for (std::uint32_t k = 0; k < model.mdp.choices(s); ++k) {
      const std::string action = quoted(std::string(model.mdp.action(s, k)));
      const auto outcomes = model.mdp.outcomes(s, k);
      if (outcomes.size() == 1) {
        out << "  " << s << " -> " << outcomes[0].target << " [label=" << action << "];\n";
        continue;
      }
      const std::string drawn = 'c' + std::to_string(s) + '_' + std::to_string(k);
      out << "  " << drawn << " [shape=point]; " << s << " -> " << drawn << " [label=" << action << ", dir=none];\n";
      for (const plan::ModelOutcome& o : outcomes)
        out << "  " << drawn << " -> " << o.target << " [label=\"" << Json(o.probability).text() << "\"];\n";
    }
  }
  out << "}\n";
}

// Models in two formats keep their labels in files of one name.
void keep_labels_of(const std::string& other, const std::string& prefix) {
  if (std::filesystem::exists(other))
    throw UsageError(other + " is a model whose labels are in " + prefix + ".lab: give another prefix by --out");
}

void write_explicit(const StateLabelled& model, const std::string& prefix) {
  if (prefix.empty()) throw UsageError("--format explicit is several files: give their prefix by --out");
  keep_labels_of(prefix + ".gr", prefix);
  const plan::PrismExplicit files = plan::write_prism_explicit(model);
  write_file(prefix + ".tra", files.transitions);
  write_file(prefix + ".sta", files.states);
  write_file(prefix + ".lab", files.labels);
  const char *written = ".srew", *other = ".trew";
  if (!files.rewards_on_states) std::swap(written, other);
  write_file(prefix + written, files.rewards);
  remove_file(prefix + other);  // an older one would be read, too
}

void write_roads(const StateLabelled& model, const std::string& prefix) {
  if (prefix.empty()) throw UsageError("--format dimacs is two files: give their prefix by --out");
  keep_labels_of(prefix + ".tra", prefix);
  std::ostringstream roads, labels;
  try {
    plan::write_dimacs(roads, labels, model);
  } catch (const std::invalid_argument& error) {
    throw UsageError(error.what());
  }
  write_file(prefix + ".gr", roads.str());
  write_file(prefix + ".lab", labels.str());
}

void write_text(const std::string& text, const std::string& prefix, const char* suffix, std::ostream& out) {
  if (prefix.empty())
    out << text;
  else
    write_file(prefix + suffix, text);
}

// Everything but text and JSON, which differ between models and products.
void write_graph(const StateLabelled& model, const std::string& name, const GraphOutput& output, std::ostream& out) {
  if (output.format == "dot") print_dot(model, out);
  if (output.format == "explicit") write_explicit(model, output.out);
  if (output.format == "prism") write_text(plan::write_prism(model), output.out, ".nm", out);
  if (output.format == "dimacs") write_roads(model, output.out);
  if (output.format == "jani") write_text(plan::write_jani(model, name), output.out, ".jani", out);
}

JsonObject sizes_of(const StateLabelled& model) {
  return JsonObject()
      .add("states", model.mdp.states())
      .add("choices", model.mdp.choices())
      .add("outcomes", model.mdp.outcomes());
}

class ProductWriter {
 public:
  ProductWriter(const plan::PlanningCase& planning_case, const ProductTitle& title, const GraphOutput& output,
                const std::stop_token& stop, std::ostream& out)
      : case_(planning_case), title_(title), output_(output), stop_(stop), out_(out) {}

  template <class Model, class Automaton>
  void write(const Model& model, const Automaton& automaton) const {
    const plan::TaskTable table(automaton, model.letters());
    const auto product = plan::ProductMdp<Model>::explore(model, table, {.states = SIZE_MAX, .stop = stop_});
    if (!product) throw Interrupted();
    std::size_t goals = 0;
    product->for_each_state([&](const auto& s) { goals += product->is_goal(s) ? 1 : 0; });
    if (!output_.svg.empty()) draw(*product);
    const bool sizes = output_.format == "text" || (output_.format == "json" && !output_.graph);
    if (output_.format == "text") return print(automaton.states(), *product, goals);
    JsonObject json;
    json.add("formula", title_.formula.empty() ? Json() : Json(title_.formula));
    if (!title_.task.empty()) json.add("task", title_.task);
    json.add("map", case_.name)
        .add("automaton", JsonObject().add("states", automaton.states()))
        .add("product", JsonObject()
                            .add("states", product->states())
                            .add("edges", product->edges())
                            .add("starts", product->starts().size())
                            .add("goals", goals));
    if (!sizes) {
      const StateLabelled labelled = plan::explicit_product(*product);
      if (output_.format != "json") return write_graph(labelled, case_.name, output_, out_);
      json.add("graph", graph_of(labelled));
    }
    out_ << json.text() << '\n';
  }

 private:
  template <class Product>
  void print(std::size_t automaton_states, const Product& product, std::size_t goals) const {
    if (!title_.task.empty()) out_ << "task       " << title_.task << '\n';
    if (!title_.formula.empty()) out_ << "formula    " << title_.formula << '\n';
    out_ << "automaton  " << counted(automaton_states, "state") << '\n'
         << "product    " << counted(product.states(), "state") << " (" << counted(goals, "goal") << "), "
         << counted(product.edges(), "edge") << ", with " << case_.name << '\n';
  }

  template <class Model>
  void draw(const plan::ProductMdp<Model>& product) const {
    ProductPicture picture;
    product.for_each_state(
        [&](const auto& s) { picture.add_state(product.model().name(s.place), s.task, product.is_goal(s), false); });
    for (const std::uint32_t start : product.starts()) picture.add_start(start);
    product.for_each_state([&](const auto& s) {
      for (std::uint32_t k = 0; k < product.choices(s); ++k)
        product.for_each_outcome(s, k, [&](std::uint32_t target, double, bool) {
          if (target != plan::ProductMdp<Model>::trap)
            picture.add_edge(s.index, target,
                             product.is_jump(s, k) ? "jump" : std::string(product.model().action(s.place, k)));
        });
    });
    draw_product(picture, output_.svg, stop_);
  }

  const plan::PlanningCase& case_;
  const ProductTitle& title_;
  const GraphOutput& output_;
  const std::stop_token& stop_;
  std::ostream& out_;
};

}  // namespace

void write_model(const plan::PlanningCase& model, const GraphOutput& output, std::ostream& out) {
  if (const auto* grid = std::get_if<plan::GridWorld>(&model.model); grid != nullptr && output.format == "prism")
    return write_text(plan::write_prism(*grid), output.out, ".nm", out);
  const StateLabelled labelled = std::visit([](const auto& m) { return plan::with_labels_on_states(m); }, model.model);
  if (output.format == "json") {
    JsonObject json;
    json.add("map", model.name).add("model", sizes_of(labelled));
    if (output.graph) json.add("graph", graph_of(labelled));
    out << json.text() << '\n';
  } else if (output.format == "text") {
    out << "model      " << counted(labelled.mdp.states(), "state") << ", " << counted(labelled.mdp.choices(), "choice")
        << ", " << counted(labelled.mdp.outcomes(), "outcome") << ": " << model.name << '\n';
  } else {
    write_graph(labelled, model.name, output, out);
  }
}

void write_game(const plan::PlanningCase& model, ltl::Formula f, const GraphOutput& output, const std::stop_token& stop,
                std::ostream& out) {
  auto made = automata::ltl_to_parity(ltl::simplify(f, ltl::Semantics::Infinite), {.stop = stop});
  if (stop.stop_requested()) throw Interrupted();
  auto* const translated = std::get_if<automata::Translated>(&made);
  if (translated == nullptr) throw GaveUp("no deterministic parity automaton within the limits");
  const auto parity = automata::Dpa::checked(std::move(translated->automaton)).value();
  automata::Budget budget(SIZE_MAX, SIZE_MAX, stop);
  try {
    const automata::ParityGame game =
        std::visit([&](const auto& m) { return plan::ProductGame(m, parity, budget).build(); }, model.model);
    write_text(automata::write_pgsolver(game), output.out, ".pg", out);
  } catch (const automata::Budget::Exceeded&) {
    throw Interrupted();
  }
}

void write_product(const plan::PlanningCase& model, const plan::TaskAutomaton& automaton, const ProductTitle& title,
                   const GraphOutput& output, const std::stop_token& stop, std::ostream& out) {
  const ProductWriter writer(model, title, output, stop, out);
  std::visit([&](const auto& m, const auto& a) { writer.write(m, a); }, model.model, automaton);
}

}  // namespace waymark::tools

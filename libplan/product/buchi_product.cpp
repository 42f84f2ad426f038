#include "libplan/product/buchi_product.hpp"

#include <stdexcept>
#include <unordered_map>

#include "libplan/product/alphabet_classes.hpp"

namespace waymark::plan {
namespace {

using automata::Branch;

template <class Model>
class Composer {
 public:
  Composer(const Model& model, const automata::Automaton& automaton, automata::Budget& budget)
      : model_(model),
        automaton_(automaton),
        budget_(budget),
        classes_(letter_classes(model.letters(), automaton.vocabulary(), automaton.reads())) {}

  BuchiProduct run() {
    out_.graph.sets = automaton_.acceptance().sets;
    for (const Branch& branch : steps(automaton_.initial().index, model_.initial_letter()))
      out_.graph.starts.push_back(meet(model_.initial(), branch.target));
    for (std::uint32_t v = 0; v < out_.places.size(); ++v) expand(v);
    out_.graph.first.push_back(static_cast<std::uint32_t>(out_.graph.edges.size()));
    return std::move(out_);
  }

 private:
  std::span<const Branch> steps(std::uint32_t q, LetterId letter) const {
    return automaton_.next(automata::StateId{q}, classes_.representatives[classes_.of[letter.index]]);
  }
  std::uint32_t meet(std::uint32_t place, std::uint32_t task) {
    const std::uint64_t pair = std::uint64_t{task} * model_.states() + place;
    const auto [at, fresh] = number_.try_emplace(pair, static_cast<std::uint32_t>(out_.places.size()));
    if (fresh) {
      budget_.state();
      out_.places.push_back(place);
      out_.tasks.push_back(task);
    }
    return at->second;
  }
  void expand(std::uint32_t v) {
    out_.graph.first.push_back(static_cast<std::uint32_t>(out_.graph.edges.size()));
    const std::uint32_t place = out_.places[v], task = out_.tasks[v];
    for (std::uint32_t k = 0; k < model_.choices(place); ++k) {
      budget_.step();
      model_.for_each_outcome(place, k, [&](std::uint32_t to, LetterId letter, double) {
        for (const Branch& branch : steps(task, letter))
          out_.graph.edges.push_back({v, meet(to, branch.target), k, branch.marks, model_.cost(place, k)});
      });
    }
  }

  const Model& model_;
  const automata::Automaton& automaton_;
  automata::Budget& budget_;
  const LetterClasses classes_;
  std::unordered_map<std::uint64_t, std::uint32_t> number_;
  BuchiProduct out_;
};

}  // namespace

template <class Model>
BuchiProduct compose(const Model& model, const automata::Automaton& automaton, automata::Budget& budget) {
  if (!model.is_deterministic()) throw std::invalid_argument("a lasso needs a deterministic model");
  if (!automaton.acceptance().is_generalized_buchi())
    throw std::invalid_argument("a lasso needs a generalised Büchi automaton");
  return Composer<Model>(model, automaton, budget).run();
}

template BuchiProduct compose(const Mdp&, const automata::Automaton&, automata::Budget&);
template BuchiProduct compose(const GridWorld&, const automata::Automaton&, automata::Budget&);

}  // namespace waymark::plan

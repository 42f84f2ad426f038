// The parity game of a model and a deterministic parity automaton: can the formula be made sure, however moves fall?
//
// The system chooses, where outcomes differ the environment draws, and the automaton reads the letter of the outcome.
// The system wins a play when the word is accepted; a run that ends, or that the automaton rejects, is lost. It wins
// from the initial vertex exactly when some strategy satisfies the formula on every path, a stronger demand than
// probability one. On a deterministic model it is that there is a lasso. Source: [GTW02, Ch. 2].
#pragma once
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "libautomata/deterministic/parity_game.hpp"
#include "libplan/model/model.hpp"

namespace waymark::plan {

template <Model M>
class ProductGame {
 public:
  // The automaton's vocabulary begins with the model's. The budget: a state for each vertex; throws what it throws.
  ProductGame(const M& model, const automata::Dpa& automaton, automata::Budget& budget)
      : model_(model),
        automaton_(automaton.automaton().vocabulary(), automaton.automaton().reads(),
                   automata::min_even_parity(automaton.automaton().transitions())),
        colours_(static_cast<std::uint32_t>(automaton_.acceptance().sets)),
        budget_(budget) {}

  automata::ParityGame build() && {  // vertex 0 is that of the initial state
    read(model_.initial(), automaton_.initial(), model_.initial_letter());
    for (std::size_t i = 0; i < game_.vertices.size(); ++i)
      if (what_[i]) expand(static_cast<std::uint32_t>(i));
    return std::move(game_);
  }

 private:
  using Player = automata::ParityGame::Player;
  struct Position {  // before the system's choice: the colour is that of the edge into it
    std::uint32_t place;
    automata::StateId state;
    std::uint32_t colour;
  };

  // Colours count the other way round, their parity kept: the least one is the greatest priority.
  std::uint32_t priority(std::uint32_t colour) const { return colours_ + colours_ % 2 - colour; }

  std::uint32_t add(Player owner, std::uint32_t priority, std::string name, std::optional<Position> what) {
    budget_.state();
    game_.vertices.push_back({owner, priority, {}, std::move(name)});
    what_.push_back(what);
    return static_cast<std::uint32_t>(game_.vertices.size() - 1);
  }
  std::uint32_t read(std::uint32_t place, automata::StateId state, LetterId letter) {
    const auto branches = automaton_.next(state, model_.letters()[letter]);
    if (branches.empty()) return lost();
    std::uint32_t colour = colours_;
    for (std::uint32_t mark = colours_; mark-- > 0;)
      if (branches[0].marks.contains(mark)) colour = mark;
    const automata::StateId next{branches[0].target};
    const auto [at, fresh] = numbers_.try_emplace({place, next.index, colour}, 0);
    if (fresh)
      at->second = add(Player::System, priority(colour), model_.name(place) + " / " + std::to_string(next.index),
                       Position{place, next, colour});
    return at->second;
  }
  std::uint32_t lost() {
    if (!lost_) {
      lost_ = add(Player::Environment, 1, "lost", std::nullopt);
      game_.vertices[*lost_].successors = {*lost_};
    }
    return *lost_;
  }

  void expand(std::uint32_t vertex) {
    const Position at = *what_[vertex];
    std::vector<std::uint32_t> successors;
    for (std::uint32_t k = 0; k < model_.choices(at.place); ++k) {
      std::vector<std::uint32_t> outcomes;
      model_.for_each_outcome(at.place, k, [&](std::uint32_t target, LetterId letter, double) {
        outcomes.push_back(read(target, at.state, letter));
      });
      if (outcomes.size() == 1) {
        successors.push_back(outcomes[0]);
      } else {
        const std::uint32_t drawn = add(Player::Environment, 0, std::string(model_.action(at.place, k)), std::nullopt);
        game_.vertices[drawn].successors = std::move(outcomes);
        successors.push_back(drawn);
      }
    }
    if (successors.empty()) successors.push_back(lost());
    game_.vertices[vertex].successors = std::move(successors);
  }

  const M& model_;
  const automata::Automaton automaton_;
  const std::uint32_t colours_;
  automata::Budget& budget_;
  automata::ParityGame game_;
  std::vector<std::optional<Position>> what_;  // by vertex; nothing: its successors are known
  std::map<std::tuple<std::uint32_t, std::uint32_t, std::uint32_t>, std::uint32_t> numbers_;
  std::optional<std::uint32_t> lost_;
};

}  // namespace waymark::plan

// A Markov decision process with letters on moves, stored flat.
//
// 𝓜 = (S, s₀, Act, P, AP, L): in a state one of its choices is made, an outcome is drawn, and the letter of the outcome
// is appended to the word; the first letter is that of the start (docs/conventions.md 1). Labels on states, as in
// [BK08, Def. 10.1], are the special case in which all outcomes into a state carry one letter. Deterministic maps are
// the special case in which every choice has one outcome.
//
// Equal letters are stored once and named by LetterId. The outcomes of a choice are adjacent in one array, and so are
// the choices of a state. An outcome takes 16 bytes, a choice 16 bytes, a state 4 bytes.
#pragma once
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "libltl/vocabulary.hpp"
#include "libltl/word.hpp"
#include "libplan/model/model.hpp"

namespace waymark::plan {

// Of one choice: sums of costs stay far from where doubles end.
inline constexpr double most_cost = 1e100;

class Mdp {
 public:
  std::size_t states() const { return first_choice_.size() - 1; }    // at least one
  std::size_t choices() const { return choices_.size() - 1; }        // of all states
  std::size_t outcomes() const { return outcomes_.size(); }          // of all choices
  bool is_deterministic() const { return outcomes() == choices(); }  // one outcome for every choice

  // What every model answers (model.hpp).
  std::uint32_t initial() const { return initial_; }
  LetterId initial_letter() const { return initial_letter_; }
  const Letters& letters() const { return letters_; }
  std::uint32_t choices(std::uint32_t s) const { return first_choice_[s + 1] - first_choice_[s]; }
  double cost(std::uint32_t s, std::uint32_t k) const { return row(s, k).cost; }  // of the k-th choice of s
  std::string_view action(std::uint32_t s, std::uint32_t k) const { return actions_[row(s, k).action]; }
  std::string name(std::uint32_t s) const { return names_.empty() ? std::to_string(s) : names_[s]; }
  std::uint32_t outcome_count(std::uint32_t s, std::uint32_t k) const {
    return static_cast<std::uint32_t>(outcomes(s, k).size());
  }
  const ModelOutcome& outcome(std::uint32_t s, std::uint32_t k, std::uint32_t i) const { return outcomes(s, k)[i]; }
  template <class Visit>  // visit(target, letter, probability)
  void for_each_outcome(std::uint32_t s, std::uint32_t k, Visit&& visit) const {
    for (const ModelOutcome& o : outcomes(s, k)) visit(o.target, o.letter, o.probability);
  }
  template <class Visit>  // visit(source): the states with an outcome into s, each once, ascending
  void for_each_predecessor(std::uint32_t s, Visit&& visit) const {
    for (std::uint32_t i = first_predecessor_[s]; i < first_predecessor_[s + 1]; ++i) visit(predecessors_[i]);
  }

  std::span<const ModelOutcome> outcomes(std::uint32_t s, std::uint32_t k) const {  // of choice k of s
    const std::size_t c = first_choice_[s] + k;
    return {outcomes_.data() + choices_[c].first_outcome, outcomes_.data() + choices_[c + 1].first_outcome};
  }

 private:
  friend class MdpBuilder;
  struct ChoiceRow {
    std::uint32_t first_outcome = 0;
    std::uint32_t action = 0;  // in actions_
    double cost = 1;
  };
  const ChoiceRow& row(std::uint32_t s, std::uint32_t k) const { return choices_[first_choice_[s] + k]; }
  void tabulate_predecessors();

  std::uint32_t initial_ = 0;
  LetterId initial_letter_;
  Letters letters_;
  std::vector<std::uint32_t> first_choice_;  // by state: index in choices_; one more entry, for the end
  std::vector<ChoiceRow> choices_;           // one more entry, for the end of the last choice
  std::vector<ModelOutcome> outcomes_;
  std::vector<std::uint32_t> first_predecessor_;
  std::vector<std::uint32_t> predecessors_;
  std::vector<std::string> actions_, names_;
};

static_assert(Model<Mdp>);

// Builds one state after the other, choices in the order in which they are added.
class MdpBuilder {
 public:
  explicit MdpBuilder(ltl::Vocabulary vocabulary);
  LetterId letter(const ltl::Letter& letter) { return mdp_.letters_.intern(letter); }  // of the process that is built

  std::uint32_t add_state(std::string_view name = {});        // the choices added from now on are its own
  void add_choice(std::string_view action, double cost = 1);  // of the state that was added last
  void add_outcome(std::uint32_t target, LetterId letter, double probability = 1);  // of the choice that was added last

  // The same without a copy: all outcomes at once, then the choices, each of which has so many of the next ones. Not to
  // be mixed with add_choice.
  void take_outcomes(std::vector<ModelOutcome> outcomes) { mdp_.outcomes_ = std::move(outcomes); }
  void add_taken_choice(std::string_view action, double cost, std::size_t outcomes);

  // Throws std::invalid_argument naming the state: a target that does not exist, a probability outside (0, 1], outcomes
  // that do not add up to 1 (up to 1e-9), a cost outside of [0, most_cost], a choice without outcomes.
  Mdp build(std::uint32_t initial, LetterId initial_letter) &&;

 private:
  void check_choice(std::uint32_t state, std::uint32_t k) const;
  std::uint32_t number_of(std::string_view action);
  Mdp mdp_;
  std::size_t taken_ = 0;                                          // outcomes that have a choice
  std::unordered_map<std::string, std::uint32_t> action_numbers_;  // in mdp_.actions_
};

}  // namespace waymark::plan

// One conjunct of a monitored formula: the runs of φ and of ¬φ, and what letters do to them.
//
// No run of φ is left when no continuation satisfies φ, and none of ¬φ when every one does. Obligations have a
// deterministic automaton for both; other formulas over infinite words have two, and subset constructions as words go.
#pragma once
#include <cstdint>
#include <map>
#include <utility>
#include <variant>
#include <vector>

#include "libautomata/finite/ltlf_to_dfa.hpp"
#include "libautomata/monitor/joint_search.hpp"
#include "libautomata/monitor/part.hpp"
#include "libltl/formula.hpp"
#include "libltl/limits.hpp"

namespace waymark::automata {

// A part with its place, and the places that letters led to.
class Watched {
 public:
  explicit Watched(Part part) : part_(std::move(part)), at_(part_.initial()) {}

  void read(std::uint32_t kind, const ltl::Letter& letter) { at_ = next(at_, kind, letter); }  // moves the place
  Part::Place next(Part::Place from, std::uint32_t kind, const ltl::Letter& letter) {          // remembered by kind
    if (from < steps_.size() && kind < steps_[from].size() && steps_[from][kind] != unknown) return steps_[from][kind];
    return new_step(from, kind, letter);
  }
  void forget_letters() { steps_.clear(); }  // kinds mean other letters from now on

  // Keeps the place alone when there are too many; says whether places have other numbers now.
  bool forgets_places();

  bool is_lost() const { return at_ == Part::nowhere; }          // no continuation is accepted
  bool is_accepting() const { return part_.is_accepting(at_); }  // finite words: the word may end here
  Part::Place at() const { return at_; }                         // the place
  Part& part() { return part_; }                                 // which grows with its places
  const Part& part() const { return part_; }                     // the automaton

 private:
  static constexpr Part::Place unknown = UINT32_MAX;
  static constexpr std::size_t most_places = 1U << 16U;  // that are remembered
  Part::Place new_step(Part::Place from, std::uint32_t kind, const ltl::Letter& letter);
  Part part_;
  Part::Place at_;
  std::vector<std::vector<Part::Place>> steps_;  // by place and kind of letter
};

// What one conjunct sees of letters: those that agree on its propositions are of one kind.
class Kinds {
 public:
  explicit Kinds(std::vector<ltl::Proposition> reads) : reads_(std::move(reads)) {}
  std::uint32_t of(const ltl::Letter& letter) {  // its kind, O(|reads| log kinds)
    std::vector<bool> bits(reads_.size());
    for (std::size_t i = 0; i < reads_.size(); ++i) bits[i] = letter.contains(reads_[i]);
    return number_.try_emplace(std::move(bits), static_cast<std::uint32_t>(number_.size())).first->second;
  }
  void forget() { number_.clear(); }  // all kinds
  std::size_t size() const { return number_.size(); }
  const std::vector<ltl::Proposition>& reads() const { return reads_; }  // of the conjunct

 private:
  std::vector<ltl::Proposition> reads_;
  std::map<std::vector<bool>, std::uint32_t> number_;
};

struct Conjunct {
  Watched yes, no;  // the runs of φ, of ¬φ
  Kinds kinds;      // of letters
};

// Gives up at the limits.
std::variant<Conjunct, Exhausted> conjunct_of(ltl::Formula f, Words words, const ltl::Limits& limits);

}  // namespace waymark::automata

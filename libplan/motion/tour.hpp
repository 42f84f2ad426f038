// Tours: motions through a terrain, their words, and the certificate of a word.
//
// A letter is the set of regions that contain the centre of the robot. The word of a tour has the letter of the start
// and one letter for every change. Letters that hold for an instant only are not read. A centre that passes a corner
// where regions end or meet is refused, because rounding would decide the word. X refers to the next change, and the
// time spent in a region has no influence.
#pragma once
#include <variant>
#include <vector>

#include "libautomata/finite/dfa.hpp"
#include "libltl/formula.hpp"
#include "libplan/motion/cells.hpp"
#include "libplan/motion/motion.hpp"

namespace waymark::plan {

struct TimedWord {
  std::vector<ltl::Letter> letters;  // over the vocabulary of the terrain
  std::vector<double> times;         // when each is first read, as in TimedRoute; the first at 0
};
struct NoTour {          // the motion is no tour
  std::size_t step = 0;  // the fault lies on the way to this configuration
  std::string reason;    // what is wrong there
};
std::variant<TimedWord, NoTour> word_of(const Motion& motion, const Terrain& terrain);  // read off the geometry

// A motion that was checked: it keeps off walls, and its word ⊨ φ. The only way to get one is certify.
class CertifiedTour {
 public:
  const Motion& motion() const { return motion_; }  // as it was checked
  const TimedWord& word() const { return word_; }   // that satisfies the formula

 private:
  friend CertifiedTour certify(Motion motion, const Terrain& terrain, ltl::Formula f);
  CertifiedTour(Motion motion, TimedWord word) : motion_(std::move(motion)), word_(std::move(word)) {}
  Motion motion_;
  TimedWord word_;
};

// Throws std::logic_error (we are wrong) naming the configuration or the formula when the check fails. The formula must
// be of an arena over the vocabulary of the terrain.
CertifiedTour certify(Motion motion, const Terrain& terrain, ltl::Formula f);

struct CellStep {               // of a run through the cells
  std::uint32_t cell = 0;       // that is entered
  const Passage* by = nullptr;  // into the cell; nullptr: the start
};
struct PassageId {                 // from a cell into a neighbour
  std::uint32_t from = 0, to = 0;  // the cells
  friend auto operator<=>(const PassageId&, const PassageId&) = default;
};
// The run of 𝒜_φ through the cells that is shortest from the centre of a passage to that of the next, without going
// through those that are blocked. nullopt: there is none; with none blocked, that no tour of any robot satisfies φ.
std::optional<std::vector<CellStep>> plan_tour(const automata::Dfa& dfa, const TerrainCells& cells, std::uint32_t start,
                                               const std::vector<PassageId>& blocked = {});

}  // namespace waymark::plan

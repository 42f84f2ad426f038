// English → LTL: the formulas that a model reads out of an instruction, best first.
//
// Without a map, `ground` ranks programs by p(program | sentence) alone. With one, each sentence's candidate programs
// are planned from where the last sentence ended, and the end pose that carries most probability wins: the answer to
// "which place is meant" is the mass of all readings that lead there, not the single likeliest reading. Where several
// sentences are said, what follows tells where those before it ended (choosing/paragraph.hpp).
#pragma once
#include <cstddef>
#include <span>
#include <string_view>
#include <vector>

#include "libparser/decode/grounder.hpp"
#include "libparser/programs/execute.hpp"

namespace waymark::parser {

struct Reading {           // a formula that the instruction may mean
  ltl::Formula formula;    // over the vocabulary of the model
  double probability = 0;  // of the readings returned: they sum to 1
  Program program;         // that denotes the formula
};

struct GroundOptions {          // what grounding may cost
  std::size_t beam = 64;        // candidate programs a sentence
  std::size_t top = 64;         // readings returned at most
  Then then = Then::WholePlan;  // the meaning of `then`
  bool one_an_end =
      false;  // programs that lead to one pose are one reading, the likeliest of them: the first is likeliest
};

// The text may hold several sentences: each is read by itself and the programs are joined by `then`.
// Throws ltl::FormatError when the arena's vocabulary is not the model's; an empty text gives no reading.
std::vector<Reading> ground(const Grounder& grounder, std::string_view text, ltl::Arena& arena,
                            const GroundOptions& options = {});

// The same on a map. `starts`: one pose, or several when the heading is unknown. The first reading is the likeliest of
// those that lead where most probability leads. Probabilities are those of the ends, shared among the readings that
// lead there; a reading without a route has none, unless no reading has one.
std::vector<Reading> ground(const Grounder& grounder, std::string_view text, const plan::Map& map,
                            std::span<const plan::PoseId> starts, ltl::Arena& arena, const GroundOptions& options = {});

// The same with the map made ready: for many texts on one map.
std::vector<Reading> ground(const Grounder& grounder, std::string_view text, const Executor& executor,
                            std::span<const plan::PoseId> starts, ltl::Arena& arena, const GroundOptions& options = {});

// The position of the reading whose end pose carries most probability, the likeliest among those that end there;
// 0 when no reading has a route. `readings` must not be empty.
std::size_t choose(std::span<const Reading> readings, const plan::Map& map, std::span<const plan::PoseId> starts,
                   Then then = Then::WholePlan);

}  // namespace waymark::parser

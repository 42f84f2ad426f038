// Which place is meant: candidate programs are planned on the map, and their weight is summed by end pose.
#pragma once
#include <optional>
#include <span>
#include <vector>

#include "libparser/decode/grounder.hpp"
#include "libparser/programs/execute.hpp"

namespace waymark::parser {

struct End {                  // a pose that may be meant
  plan::PoseId pose;          // the end of a plan
  double mass = 0;            // weight of the candidates that end there
  std::size_t candidate = 0;  // of those that end there, the preferred one
};

// A program the reader thinks likely, weighed by how well it says what the sentence says (lexical_overlap.hpp).
struct Weighed {
  Program program;        // a candidate
  double log_weight = 0;  // log p(program | sentence) − trust_in_wording · lexical_overlap_penalty; not normalised
  double preference = 0;  // the same with more trust, to compare programs that lead to one end
};
inline constexpr double trust_in_wording = 3.0, trust_at_one_end = 6.0;  // weights of the lexical-overlap penalty

struct Decision {                          // which ends, by which programs
  std::vector<Weighed> candidates;         // most weight first
  std::vector<std::optional<Plan>> plans;  // of each candidate; nullopt: no route
  std::vector<std::size_t> start;          // of each candidate: which of the starts its plan leaves from
  std::vector<End> ends;                   // most mass first; empty when no candidate has a route
};

struct Deciding {               // how ends are decided
  std::size_t beam = 64;        // programs a reader gives
  Then then = Then::WholePlan;  // the meaning of `then`
  double trust = 1;             // in wording, of what is usual: 0 takes the reader's word for everything
  bool clauses = true;          // sentences of several are also read clause by clause: clauses.hpp
};

// The reader's `beam` likeliest programs of a sentence, most weight first.
std::vector<Weighed> likely_programs(const Grounder& grounder, const SentenceInput& input, const Deciding& how = {});

// The plan from several starts is the cheapest of the plans from each, ties by their order.
std::optional<std::pair<Plan, std::size_t>> plan_from(const Executor& executor, const Program& program,
                                                      std::span<const plan::PoseId> starts, Then then);

// What candidates that are known come to. By weight of the programs alone; reranker.hpp reranks the ends.
Decision decide(std::vector<Weighed> candidates, const Executor& executor, std::span<const plan::PoseId> starts,
                Then then);
// The same, read first.
Decision decide(const Grounder& grounder, const Executor& executor, const SentenceInput& input,
                std::span<const plan::PoseId> starts, const Deciding& how = {});

// Sums weights by end pose. Ties: the end that an earlier candidate leads to first. candidates and plans: same size.
std::vector<End> rank_ends(std::span<const Weighed> candidates, std::span<const std::optional<Plan>> plans);

}  // namespace waymark::parser

// Which place is meant: candidate programs are planned on the map, and their probability is summed by end pose.
#pragma once
#include <optional>
#include <span>
#include <vector>

#include "libparser/beam.hpp"
#include "libparser/execute.hpp"

namespace waymark::parser {

struct End {
  plan::PoseId pose;
  double mass = 0;            // probability of the candidates that end there
  std::size_t candidate = 0;  // the likeliest of them
};

struct Decision {
  std::vector<Candidate> candidates;       // likeliest first
  std::vector<std::optional<Plan>> plans;  // of each candidate; nullopt: no route
  std::vector<std::size_t> start;          // of each candidate: which of the starts its plan leaves from
  std::vector<End> ends;                   // most mass first; empty when no candidate has a route
};

// The plan from several starts is the cheapest of the plans from each, ties by their order.
std::optional<std::pair<Plan, std::size_t>> plan_from(const Executor& executor, const Program& program,
                                                      std::span<const plan::PoseId> starts, Then then);

// By probability of the programs alone; chooser.hpp reranks the ends.
Decision decide(const LinearModel& model, const Executor& executor, const SentenceInput& input,
                std::span<const plan::PoseId> starts, std::size_t beam, Then then);

// Sums masses by end pose. Ties: the end of the likelier candidate first.
std::vector<End> rank_ends(std::span<const double> probabilities, std::span<const std::optional<Plan>> plans);

}  // namespace waymark::parser

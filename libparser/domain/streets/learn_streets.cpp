#include "libparser/domain/streets/learn_streets.hpp"

#include <optional>
#include <utility>

#include "libparser/supervision/examples.hpp"

namespace waymark::streets {
namespace {

using parser::LabelledDecision;

std::optional<std::size_t> candidate(const std::vector<CandidateRoute>& routes, const StreetRoute& route) {
  for (std::size_t i = 0; i < routes.size(); ++i)
    if (routes[i].landmarks == route) return i;
  return std::nullopt;
}

// Of each text whose route is among its candidates.
std::vector<LabelledDecision> decisions(std::span<const StreetInstruction* const> instructions,
                                        const std::vector<StreetMap>& maps, StreetModel& model,
                                        const std::stop_token& stop) {
  std::vector<LabelledDecision> out;
  std::vector<std::optional<StreetReader>> readers(maps.size());
  for (const StreetInstruction* instruction : instructions) {
    if (stop.stop_requested()) throw parser::Stopped{};
    auto& reader = readers[instruction->map];
    if (!reader) reader.emplace(maps[instruction->map], model.common, model.limits);
    const auto found = reader->candidates(instruction->tokens, instruction->start);
    const auto gold = candidate(found.routes, instruction->path);
    if (!gold) continue;
    LabelledDecision& decision = out.emplace_back(numbered(found.features, model.weights));
    decision.map = instruction->map;
    decision.right = {*gold};
    decision.rival = candidate(found.routes, found.routes[*gold].rival);
  }
  return out;
}

}  // namespace

StreetModel learn_streets(std::span<const StreetInstruction* const> instructions,
                          const std::vector<StreetMap>& maps, const StreetOptions& options) {
  StreetModel model;
  model.limits = options.limits;
  model.common = common_words(instructions, maps);
  std::vector<LabelledDecision> all = decisions(instructions, maps, model, options.ranker.stop);
  learn_ranker(model.weights, all, options.ranker, [](double) {});
  return model;
}

}  // namespace waymark::streets

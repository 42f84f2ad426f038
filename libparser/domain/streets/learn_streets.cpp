#include "libparser/domain/streets/learn_streets.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numeric>
#include <optional>
#include <random>

#include "libparser/domain/streets/second_look.hpp"

namespace waymark::streets {
namespace {

constexpr int least_cities = 3;

struct Example {
  std::size_t map;
  std::vector<RouteFeatures> routes;
  std::size_t gold;
  std::optional<std::size_t> rival;  // of the gold route
};

class Learner {
 public:
  Learner(StreetModel& model, const StreetOptions& options)
      : weights_(model.weights),
        rate_(static_cast<float>(options.rate)),
        decay_(static_cast<float>(options.decay)),
        against_rival_(static_cast<float>(options.against_rival)),
        squares_(weights_.size(), 0.0F),
        gradient_(weights_.size(), 0.0F) {}

  void update(const Example& example) {
    scores_.assign(example.routes.size(), 0.0F);
    for (std::size_t i = 0; i < scores_.size(); ++i)
      for (const WeighedFeature& f : example.routes[i]) scores_[i] += weights_[f.index] * f.value;
    const float behind = example.rival ? scores_[*example.rival] - scores_[example.gold] : 0;
    const float push = example.rival ? against_rival_ / (1 + std::exp(-behind - margin)) : 0;
    const float best = *std::max_element(scores_.begin(), scores_.end());
    float sum = 0;
    for (float& score : scores_) sum += score = std::exp(score - best);
    for (std::size_t i = 0; i < scores_.size(); ++i) {
      float g = (i == example.gold ? 1.0F + push : 0.0F) - scores_[i] / sum;
      if (i == example.rival) g -= push;
      if (std::abs(g) < least_gradient) continue;
      for (const WeighedFeature& f : example.routes[i]) {
        if (gradient_[f.index] == 0) touched_.push_back(f.index);
        gradient_[f.index] += g * f.value;
      }
    }
    for (const std::uint32_t index : touched_) step(index);
    touched_.clear();
  }

 private:
  static constexpr float least_gradient = 1e-5F;
  static constexpr float margin = 1;  // by which the rival is to score less

  void step(std::uint32_t index) {
    const float g = gradient_[index] - decay_ * weights_[index];
    gradient_[index] = 0;
    if (g == 0) return;  // listed twice: its gradient had come back to zero on the way
    squares_[index] += g * g;
    weights_[index] += rate_ * g / std::sqrt(squares_[index]);
  }

  std::vector<float>& weights_;
  float rate_, decay_, against_rival_;
  std::vector<float> squares_, gradient_, scores_;
  std::vector<std::uint32_t> touched_;
};

std::optional<std::size_t> candidate(const std::vector<CandidateRoute>& routes, const StreetRoute& route) {
  for (std::size_t i = 0; i < routes.size(); ++i)
    if (routes[i].landmarks == route) return i;
  return std::nullopt;
}

using Texts = std::vector<std::vector<const StreetInstruction*>>;  // by map

Texts texts_by_map(std::span<const StreetInstruction* const> instructions, std::size_t maps) {
  Texts texts(maps);
  for (const StreetInstruction* instruction : instructions) texts[instruction->map].push_back(instruction);
  return texts;
}

std::vector<Example> examples(std::span<const StreetInstruction* const> instructions,
                              const std::vector<StreetMap>& maps, const StreetModel& model,
                              const std::stop_token& stop) {
  std::vector<Example> out;
  std::vector<std::optional<StreetReader>> readers(maps.size());
  const auto by_map = model.observes ? texts_by_map(instructions, maps.size()) : Texts{};
  for (const StreetInstruction* instruction : instructions) {
    if (stop.stop_requested()) break;
    auto& reader = readers[instruction->map];
    if (!reader) {
      reader.emplace(maps[instruction->map], model.common, model.limits);
      if (model.observes) reader->observe(by_map[instruction->map]);
    }
    auto found = reader->candidates(instruction->tokens, instruction->start);
    const auto gold = candidate(found.routes, instruction->path);
    if (!gold) continue;
    const auto rival = candidate(found.routes, found.routes[*gold].rival);
    out.push_back({instruction->map, std::move(found.features), *gold, rival});
  }
  return out;
}

// Features that were met in one or two cities only are about those: they are left out.
void keep_what_is_shared(std::vector<Example>& examples) {
  std::vector<std::uint64_t> cities(std::size_t{1} << feature_bits, 0);
  for (const Example& example : examples)
    for (const RouteFeatures& features : example.routes)
      for (const WeighedFeature& f : features) cities[f.index] |= std::uint64_t{1} << (example.map % 64);
  std::uint64_t all = 0;
  for (const Example& example : examples) all |= std::uint64_t{1} << (example.map % 64);
  const int least = std::min(least_cities, std::popcount(all));
  const auto alone = [&](const WeighedFeature& f) { return std::popcount(cities[f.index]) < least; };
  for (Example& example : examples)
    for (RouteFeatures& features : example.routes)
      features.erase(std::remove_if(features.begin(), features.end(), alone), features.end());
}

std::optional<StreetModel> learn_reranker(std::span<const StreetInstruction* const> instructions,
                                          const std::vector<StreetMap>& maps, const StreetOptions& options) {
  StreetModel model;
  model.limits = options.limits;
  model.observes = options.adapt;
  model.common = common_words(instructions, maps);
  std::vector<Example> all = examples(instructions, maps, model, options.stop);
  keep_what_is_shared(all);
  std::vector<std::size_t> order(all.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::mt19937_64 random(options.seed);
  Learner learner(model, options);
  for (int epoch = 0; epoch < options.epochs; ++epoch) {
    for (std::size_t i = order.size(); i > 1; --i) std::swap(order[i - 1], order[random() % i]);
    for (const std::size_t i : order) {
      if (options.stop.stop_requested()) return std::nullopt;
      learner.update(all[i]);
    }
  }
  if (options.stop.stop_requested()) return std::nullopt;
  return model;
}

// Each city read by a reranker that was learned in the others, as a city never seen is; empty when there is one city only.
std::optional<std::vector<ReadCity>> read_by_others(std::span<const StreetInstruction* const> instructions,
                                                    const std::vector<StreetMap>& maps,
                                                    const StreetOptions& options) {
  std::vector<ReadCity> cities;
  const Texts by_map = texts_by_map(instructions, maps.size());
  for (std::size_t m = 0; m < maps.size(); ++m) {
    std::vector<const StreetInstruction*> others;
    for (const StreetInstruction* instruction : instructions)
      if (instruction->map != m) others.push_back(instruction);
    if (by_map[m].empty() || others.empty()) continue;
    const auto reranker = learn_reranker(others, maps, options);
    if (!reranker) return std::nullopt;
    ReadCity& city = cities.emplace_back(ReadCity{read_texts(*reranker, maps[m], by_map[m]), {}});
    for (const StreetInstruction* instruction : by_map[m]) city.right.push_back(instruction->path);
  }
  return cities;
}

}  // namespace

std::optional<StreetModel> learn_streets(std::span<const StreetInstruction* const> instructions,
                                         const std::vector<StreetMap>& maps, const StreetOptions& options) {
  auto model = learn_reranker(instructions, maps, options);
  if (!model || !options.adapt) return model;
  const auto cities = read_by_others(instructions, maps, options);
  if (!cities) return std::nullopt;
  model->second_look = learn_second_look(*cities).weights;
  return model;
}

}  // namespace waymark::streets

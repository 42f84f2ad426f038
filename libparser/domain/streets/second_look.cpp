#include "libparser/domain/streets/second_look.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace waymark::streets {
namespace {

constexpr std::array<double, 14> steps{0.01, 0.03, 0.08, 0.15, 0.3, 0.5, 0.75,
                                       1.0,  1.4,  1.8,  2.2,  2.6, 3.2, 4.5};
constexpr std::size_t most_texts = 7;
constexpr double by_chance =
    2;  // texts of one start and goal that are about other routes: the scale of support

enum Feature : std::uint32_t { FirstReading, RankShare, Support, SupportStep };
constexpr std::uint32_t first_text_step = SupportStep + static_cast<std::uint32_t>(steps.size()) + 1;
constexpr std::size_t features = first_text_step + most_texts + 1;

struct Supported {
  double sum = 0;
  std::size_t texts = 0;
};

std::map<StreetRoute, Supported> support(std::span<const TextReadings> texts) {
  std::map<StreetRoute, Supported> by_route;
  for (const TextReadings& readings : texts)
    for (const StreetReading& reading : readings) {
      Supported& s = by_route[reading.route.landmarks];
      s.sum += reading.probability;
      s.texts += reading.probability > 0.5 ? 1U : 0U;
    }
  return by_route;
}

RouteFeatures features_of(const StreetReading& reading, const Supported& all) {
  constexpr double least = 1e-7;
  const double sum = std::max(0.0, all.sum - reading.probability);
  const std::size_t texts = all.texts - (reading.probability > 0.5 ? 1U : 0U);
  const double share = reading.route.rank_share;
  const auto step = static_cast<std::uint32_t>(
      std::count_if(steps.begin(), steps.end(), [&](double least_sum) { return sum >= least_sum; }));
  return {{FirstReading, static_cast<float>(std::log(std::max(reading.probability, 1e-30)))},
          {RankShare, static_cast<float>(std::log(share + least))},
          {Support, static_cast<float>(std::log1p(sum / (by_chance * share + least)))},
          {SupportStep + step, 1.0F},
          {first_text_step + static_cast<std::uint32_t>(std::min(texts, most_texts)), 1.0F}};
}

std::vector<std::vector<RouteFeatures>> features_of(std::span<const TextReadings> texts) {
  const auto by_route = support(texts);
  std::vector<std::vector<RouteFeatures>> out;
  for (const TextReadings& readings : texts) {
    std::vector<RouteFeatures>& own = out.emplace_back();
    for (const StreetReading& reading : readings)
      own.push_back(features_of(reading, by_route.at(reading.route.landmarks)));
  }
  return out;
}

double score(const std::vector<double>& weights, const RouteFeatures& of) {
  double sum = 0;
  for (const WeighedFeature& f : of) sum += weights[f.index] * static_cast<double>(f.value);
  return sum;
}

struct Example {
  std::vector<RouteFeatures> candidates;
  std::size_t right;
  double weight;
};

std::vector<Example> examples(std::span<const ReadCity> cities) {
  std::vector<Example> out;
  for (const ReadCity& city : cities) {
    auto all = features_of(city.texts);
    for (std::size_t t = 0; t < city.texts.size(); ++t) {
      const TextReadings& readings = city.texts[t];
      const auto right = std::find_if(readings.begin(), readings.end(), [&](const StreetReading& r) {
        return r.route.landmarks == city.right[t];
      });
      if (right == readings.end()) continue;
      out.push_back({std::move(all[t]), static_cast<std::size_t>(right - readings.begin()),
                     1 / static_cast<double>(city.texts.size())});
    }
  }
  return out;
}

// ∂/∂weights Σ weight · log p(right).
void add_gradient(const Example& example, const std::vector<double>& weights, std::vector<double>& gradient) {
  constexpr double least = 1e-6;
  std::vector<double> p;
  for (const RouteFeatures& candidate : example.candidates) p.push_back(score(weights, candidate));
  const double best = *std::max_element(p.begin(), p.end());
  double sum = 0;
  for (double& x : p) sum += x = std::exp(x - best);
  for (std::size_t i = 0; i < p.size(); ++i) {
    const double g = example.weight * ((i == example.right ? 1 : 0) - p[i] / sum);
    if (std::abs(g) < least * example.weight) continue;
    for (const WeighedFeature& f : example.candidates[i])
      gradient[f.index] += g * static_cast<double>(f.value);
  }
}

}  // namespace

TransductiveReranking learn_second_look(std::span<const ReadCity> cities) {
  constexpr int rounds = 80;
  constexpr double rate = 0.3, decay = 5e-4;
  const std::vector<Example> all = examples(cities);
  TransductiveReranking look;
  if (all.empty()) return look;
  look.weights.assign(features, 0.0);
  look.weights[FirstReading] = 1;
  std::vector<double> squares(features, 1e-12), gradient(features);
  for (int round = 0; round < rounds; ++round) {
    std::fill(gradient.begin(), gradient.end(), 0.0);
    for (const Example& example : all) add_gradient(example, look.weights, gradient);
    for (std::size_t f = 0; f < features; ++f) {
      const double g = gradient[f] - decay * (look.weights[f] - (f == FirstReading ? 1 : 0));
      squares[f] += g * g;
      look.weights[f] += rate * g / std::sqrt(squares[f]);
    }
  }
  return look;
}

std::vector<TextReadings> look_again(const TransductiveReranking& look, std::span<const TextReadings> texts) {
  std::vector<TextReadings> out(texts.begin(), texts.end());
  if (look.weights.empty()) return out;
  const auto all = features_of(texts);
  for (std::size_t t = 0; t < out.size(); ++t) {
    for (std::size_t i = 0; i < out[t].size(); ++i) out[t][i].probability = score(look.weights, all[t][i]);
    settle(out[t]);
  }
  return out;
}

}  // namespace waymark::streets

#include "libparser/domain/commands/learn_mentions.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include "libltl/structure/random.hpp"
#include "libparser/domain/commands/landmark_mentions.hpp"
#include "libparser/domain/commands/mention_lattice.hpp"

namespace waymark::parser {
namespace {

constexpr std::size_t most_wanted = 8;

struct Example {
  std::vector<std::string> tokens;
  const CityWords* city;
  std::vector<std::size_t> wanted;
  double weight = 1;
};

std::vector<Example> examples_of(std::span<const Command> commands, CommandDomains& domains) {
  std::vector<Example> out;
  std::vector<std::string> sources;
  std::map<std::string, double> met;
  for (const Command& command : commands) {
    if (command.suspect || command.marked) continue;
    const CommandDomain& domain = domains.of(command.domain);
    if (!domain.city_words()) continue;
    Example example{landmark_tokens(command.text), domain.city_words(), {}, 1};
    for (const std::string& p : command.propositions)
      if (const auto landmark = domain.landmark(p)) example.wanted.push_back(*landmark);
    if (example.wanted.size() < command.propositions.size() || example.wanted.size() > most_wanted) continue;
    out.push_back(std::move(example));
    sources.push_back(command.source);
    ++met[command.source];
  }
  for (std::size_t i = 0; i < out.size(); ++i)
    out[i].weight = static_cast<double>(out.size()) / static_cast<double>(met.size()) / met[sources[i]];
  return out;
}

// The gradient of the log-likelihood; false when no cover names what is wanted.
bool gradient(const Example& example, const Synonyms& synonyms, const MentionVector& weights, MentionVector& out) {
  const MentionLattice lattice(example.tokens, *example.city, synonyms);
  MentionVector expected{}, wanted{};
  if (lattice.log_sum(weights, wanted, &example.wanted) == -INFINITY) return false;
  lattice.log_sum(weights, expected);
  for (std::size_t i = 0; i < mention_features; ++i) out[i] = wanted[i] - expected[i];
  return true;
}

}  // namespace

LearnedMentions learn_mentions(std::span<const Command> commands, CommandDomains& domains, const Synonyms& synonyms,
                               const MentionTraining& options) {
  const std::vector<Example> examples = examples_of(commands, domains);
  constexpr MentionVector by_hand = mention_weights_by_hand();
  LearnedMentions out;
  MentionVector squares{}, g{};
  ltl::Random random(options.seed);
  std::vector<std::size_t> order(examples.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  for (int epoch = 0; epoch < options.epochs; ++epoch) {
    out.commands = out.unexplained = 0;
    for (std::size_t i = order.size(); i > 1; --i) std::swap(order[i - 1], order[random.below(i)]);
    for (const std::size_t i : order) {
      if (!gradient(examples[i], synonyms, out.weights, g)) {
        ++out.unexplained;
        continue;
      }
      ++out.commands;
      for (std::size_t f = 0; f < mention_features; ++f) {
        const double step = examples[i].weight * g[f] - options.penalty * (out.weights[f] - by_hand[f]);
        squares[f] += step * step;
        if (squares[f] > 0) out.weights[f] += options.rate * step / std::sqrt(squares[f]);
      }
    }
  }
  return out;
}

}  // namespace waymark::parser

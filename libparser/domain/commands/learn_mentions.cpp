#include "libparser/domain/commands/learn_mentions.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <set>

#include "libltl/structure/random.hpp"
#include "libparser/domain/commands/landmark_mentions.hpp"
#include "libparser/domain/commands/mention_lattice.hpp"
#include "libparser/domain/commands/mention_scores.hpp"
#include "libparser/domain/commands/word_forms.hpp"

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
  if (lattice.log_sum(weights, wanted, &example.wanted) == -std::numeric_limits<double>::infinity()) return false;
  lattice.log_sum(weights, expected);
  for (std::size_t i = 0; i < mention_features; ++i) out[i] = wanted[i] - expected[i];
  return true;
}

// Commands with marks, and the names that their domains have.
class MarkedTexts {
 public:
  explicit MarkedTexts(std::span<const Command> commands) {
    for (const Command& command : commands) {
      if (command.suspect || command.mentions.empty()) continue;
      commands_.push_back(&command);
      for (const auto& [key, name] : command.things) names_[command.domain].insert(name);
    }
    for (const auto& [domain, names] : names_) drawn_from_[domain].assign(names.begin(), names.end());
  }

  std::size_t size() const { return commands_.size(); }

  // The gradient of the log-likelihood of the cover that the marks tell.
  void gradient(std::size_t i, std::size_t distractors, ltl::Random& random, const Synonyms& synonyms,
                const MentionVector& weights, MentionVector& out) const {
    Command command = *commands_[i];
    if (random.chance(0.5)) add_distractors(command, distractors, random);
    const CommandDomain domain = CommandDomain::of_things(command);
    const MentionLattice lattice(landmark_tokens(command.text), *domain.city_words(), synonyms);
    MentionVector expected{};
    lattice.log_sum(weights, expected);
    out = lattice.features(cover(lattice, command));
    for (std::size_t f = 0; f < mention_features; ++f) out[f] -= expected[f];
  }

 private:
  void add_distractors(Command& command, std::size_t distractors, ltl::Random& random) const {
    const std::vector<std::string>& names = drawn_from_.at(command.domain);
    for (std::size_t k = 0; k < distractors; ++k) {
      const std::string& name = names[random.below(names.size())];
      const auto has = [&](const auto& thing) { return thing.second == name; };
      if (std::none_of(command.things.begin(), command.things.end(), has))
        command.things["other" + std::to_string(k)] = name;
    }
  }

  static std::vector<std::size_t> cover(const MentionLattice& lattice, const Command& command) {
    const std::vector<std::string> tokens = landmark_tokens(command.text);
    std::vector<std::size_t> out;
    for (const Mention& mark : marked_mentions(command)) {
      std::size_t best = lattice.phrases().size(), longest = 0;
      for (std::size_t p = 0; p < lattice.phrases().size(); ++p) {
        const MentionPhrase& phrase = lattice.phrases()[p];
        if (phrase.landmark != mark.thing || phrase.begin < mark.begin || phrase.end > mark.end) continue;
        const auto outside = std::count_if(tokens.begin() + static_cast<std::ptrdiff_t>(mark.begin),
                                           tokens.begin() + static_cast<std::ptrdiff_t>(phrase.begin),
                                           [](const std::string& token) { return negates(token); });
        if ((phrase.negated != mark.negated) != (outside % 2 == 1)) continue;
        if (phrase.end - phrase.begin <= longest) continue;
        longest = phrase.end - phrase.begin;
        best = p;
      }
      if (longest > 0) out.push_back(best);
    }
    return out;
  }

  std::vector<const Command*> commands_;
  std::map<std::string, std::set<std::string>> names_;  // by domain
  std::map<std::string, std::vector<std::string>> drawn_from_;
};

// Steps of AdaGrad from the weights set by hand.
class Ascent {
 public:
  Ascent(MentionVector& weights, const MentionTraining& options) : weights_(weights), options_(options) {}

  void step(const MentionVector& gradient, double weight) {
    constexpr MentionVector by_hand = mention_weights_by_hand();
    for (std::size_t f = 0; f < mention_features; ++f) {
      const double step = weight * gradient[f] - options_.penalty * (weights_[f] - by_hand[f]);
      squares_[f] += step * step;
      if (squares_[f] > 0) weights_[f] += options_.rate * step / std::sqrt(squares_[f]);
    }
  }

 private:
  MentionVector& weights_;
  const MentionTraining& options_;
  MentionVector squares_{};
};

}  // namespace

LearnedMentions learn_mentions(std::span<const Command> commands, CommandDomains& domains, const Synonyms& synonyms,
                               const MentionTraining& options) {
  const std::vector<Example> examples = examples_of(commands, domains);
  const MarkedTexts marked(commands);
  LearnedMentions out;
  MentionVector g{};
  Ascent ascent(out.weights, options);
  ltl::Random random(options.seed);
  std::vector<std::size_t> order(examples.size() + marked.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  const auto every = static_cast<std::size_t>(std::max(1, options.epochs / std::max(1, options.marked_epochs)));
  for (std::size_t epoch = 0; epoch < static_cast<std::size_t>(options.epochs); ++epoch) {
    out.commands = out.marked = marked.size();
    out.unexplained = 0;
    for (std::size_t i = order.size(); i > 1; --i) std::swap(order[i - 1], order[random.below(i)]);
    for (const std::size_t i : order) {
      if (i >= examples.size()) {
        if (i % every != epoch % every) continue;
        marked.gradient(i - examples.size(), options.distractors, random, synonyms, out.weights, g);
        ascent.step(g, options.marked_weight);
      } else if (gradient(examples[i], synonyms, out.weights, g)) {
        ++out.commands;
        ascent.step(g, examples[i].weight);
      } else {
        ++out.unexplained;
      }
    }
  }
  return out;
}

}  // namespace waymark::parser

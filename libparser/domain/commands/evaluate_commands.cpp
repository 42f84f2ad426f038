#include "libparser/domain/commands/evaluate_commands.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "libltl/parallel.hpp"
#include "libltl/text/parse.hpp"
#include "libltl/text/print.hpp"
#include "libparser/domain/commands/learn_mentions.hpp"

namespace waymark::parser {
namespace {

CommandAnswer answer_of(const LiftedReader& reader, const Command& command, const CommandDomain& domain,
                        const ReadCommandOptions& options) {
  CommandAnswer answer{&command, "", 0, false, false};
  ltl::Arena arena;
  const ltl::Formula gold = ltl::parse(command.formula, arena);
  const CommandReadings read = read_command(reader, domain, command.text, arena, options);
  if (read.readings.empty()) return answer;
  const ltl::Formula best = read.readings.front().formula;
  answer.formula = ltl::print(best);
  answer.probability = read.readings.front().probability;
  answer.exact = best == gold;
  answer.equivalent = same_language(best, gold);
  return answer;
}

void count(CommandScore& score, const CommandAnswer& answer) {
  ++score.n;
  score.exact += answer.exact ? 1 : 0;
  score.equivalent += answer.equivalent ? 1 : 0;
}

}  // namespace

void Calibration::add(double probability, bool right) {
  const auto at = static_cast<std::size_t>(std::clamp(probability, 0.0, 1.0) * static_cast<double>(bins.size()));
  Bin& bin = bins[std::min(at, bins.size() - 1)];
  ++bin.n;
  bin.right += right ? 1 : 0;
  bin.probability += probability;
}

double Calibration::expected_error() const {
  double error = 0;
  std::size_t all = 0;
  for (const Bin& bin : bins) {
    error += std::abs(static_cast<double>(bin.right) - bin.probability);
    all += bin.n;
  }
  return all > 0 ? error / static_cast<double>(all) : 0;
}

CommandScores score_commands(const LiftedReader& reader, std::span<const Command> commands, CommandDomains& domains,
                             const ReadCommandOptions& options) {
  std::vector<const CommandDomain*> domain;
  for (const Command& command : commands) domain.push_back(&domains.of(command.domain));
  CommandScores scores;
  scores.answers.resize(commands.size());
  ltl::parallel_for(commands.size(), 2, [&](std::size_t i, std::size_t) {
    scores.answers[i] = answer_of(reader, commands[i], *domain[i], options);
  });
  for (const CommandAnswer& answer : scores.answers) {
    count(scores.all, answer);
    count(scores.by_type[answer.command->type], answer);
    count(scores.by_domain[answer.command->domain], answer);
  }
  return scores;
}

CommandSplit split_commands(std::vector<Command> commands, std::vector<Command> others,
                            const std::set<std::string>& fold) {
  CommandSplit split;
  const bool tests_others = !others.empty();
  for (Command& command : commands) {
    const bool in_fold = fold.contains(command.id);
    if (in_fold && tests_others) continue;
    (in_fold ? split.test : split.training).push_back(std::move(command));
  }
  for (Command& other : others)
    if (fold.empty() || fold.contains(other.from)) split.test.push_back(std::move(other));
  std::set<std::pair<std::string, std::size_t>> known;
  for (const Command& command : split.training) known.emplace(command.type, command.n);
  split.new_kinds = std::any_of(split.test.begin(), split.test.end(), [&](const Command& c) {
    return c.type != "free" && c.n > 0 && !known.contains({c.type, c.n});
  });
  return split;
}

LiftedReader train_commands(const CommandSplit& split, CommandDomains& domains, const SynchronousGrammar& grammar,
                            const std::shared_ptr<const WordVectors>& vectors, const CommandsExperiment& how) {
  std::vector<LiftedExample> examples = own_commands(grammar, *vectors, how.own);
  const auto synonyms = std::make_shared<const Synonyms>(how.synonyms);
  const MentionModel mentions{learn_mentions(split.training, domains, *synonyms).weights, synonyms};
  const auto labelled = labelled_commands(split.training, domains, mentions, split.new_kinds ? 1 : 0, how.doubted);
  examples.insert(examples.end(), labelled.examples.begin(), labelled.examples.end());
  std::vector<std::shared_ptr<const LiftedNetwork>> networks;
  for (std::size_t i = 0; i < how.networks; ++i) {
    LiftedTraining training = how.network;
    training.seed += i;
    networks.push_back(learn_lifted(examples, vectors, training, [&](double done) {
      if (how.progress) how.progress((static_cast<double>(i) + done) / static_cast<double>(how.networks));
    }));
  }
  return {vectors, std::move(networks), mentions};
}

}  // namespace waymark::parser

#include "libparser/domain/commands/evaluate_commands.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <variant>

#include "libautomata/finite/ltlf_to_dfa.hpp"
#include "libautomata/finite/product.hpp"
#include "libltl/parallel.hpp"
#include "libltl/text/parse.hpp"
#include "libltl/text/print.hpp"
#include "libparser/corpus/token.hpp"
#include "libparser/domain/commands/learn_mentions.hpp"

namespace waymark::parser {
namespace {

bool has_weak_next(ltl::Formula f) {
  const auto all = ltl::subformulas(f);
  return std::any_of(all.begin(), all.end(), [](ltl::Formula g) { return g.op() == ltl::Op::WeakNext; });
}

bool same_meaning(ltl::Formula a, ltl::Formula b) {
  if (!has_weak_next(a) && !has_weak_next(b)) return same_language(a, b);
  const auto one = automata::ltlf_to_dfa(a, {.states = 20'000, .stop = {}});
  const auto other = automata::ltlf_to_dfa(b, {.states = 20'000, .stop = {}});
  const auto *first = std::get_if<automata::Dfa>(&one), *second = std::get_if<automata::Dfa>(&other);
  return first && second && !automata::difference(*first, *second);
}

// Reads the commands of a test, each by what it may name.
class Questions {
 public:
  Questions(const LiftedReader& reader, const MarkedCommands& marked, const ScoreOptions& options)
      : reader_(reader), marked_(marked), options_(options) {}

  CommandAnswer answer(const Command& command, const CommandDomain& domain) const {
    CommandAnswer answer{&command, "", 0, false, false, true};
    const bool hallway = is_hallway(command);
    ltl::Arena arena(hallway ? marked_.vocabulary() : ltl::Vocabulary());
    std::vector<ltl::Formula> gold{ltl::parse(command.formula, arena)};
    for (const std::string& also : command.also) gold.push_back(ltl::parse(also, arena));
    const CommandReadings read = read_lifts(reader_, lifts_of(command, domain, arena), options_.read);
    if (read.readings.empty()) return answer;
    const ltl::Formula best = read.readings.front().formula;
    answer.formula = ltl::print(best);
    answer.probability = read.readings.front().probability * read.understood;
    answer.refused = read.understood < least_understood_command || answer.probability < options_.least;
    if (answer.refused) return answer;
    answer.exact = std::find(gold.begin(), gold.end(), best) != gold.end();
    answer.equivalent =
        answer.exact || std::any_of(gold.begin(), gold.end(), [&](ltl::Formula g) { return same_meaning(best, g); });
    return answer;
  }

  static bool is_hallway(const Command& command) { return command.domain == hallway_domain && command.marked; }

 private:
  static constexpr double least_understood_command = 0.5;

  std::vector<BoundLift> lifts_of(const Command& command, const CommandDomain& domain, ltl::Arena& arena) const {
    const HallwayThings& hallways = marked_.hallways();
    if (options_.marks_are_given && command.marked) {
      MarkedCommands::Marked m = marked_.lift(command);
      Bindings bindings =
          is_hallway(command) ? hallways.bindings(arena, m.things, std::nullopt) : domain.bindings(arena, m.slots);
      return {{std::move(m.text), 1, std::move(bindings)}};
    }
    if (is_hallway(command)) {
      LiftedMentions m = hallways.lift(tokenize(command.text), &reader_.vectors());
      return {{std::move(m.text), 1, hallways.bindings(arena, m.things, std::nullopt)}};
    }
    std::vector<BoundLift> lifts;
    for (CommandDomain::Lift& lift : domain.lift(command.text, reader_.mentions())) {
      if (!options_.read.names_domain) lift.text.domain.clear();
      lifts.push_back({std::move(lift.text), lift.probability, domain.bindings(arena, lift.slots)});
    }
    return lifts;
  }

  const LiftedReader& reader_;
  const MarkedCommands& marked_;
  const ScoreOptions& options_;
};

void count(CommandScore& score, const CommandAnswer& answer) {
  ++score.n;
  score.exact += answer.exact ? 1 : 0;
  score.equivalent += answer.equivalent ? 1 : 0;
  score.refused += answer.refused ? 1 : 0;
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
                             const MarkedCommands& marked, const ScoreOptions& options) {
  std::vector<CommandDomain> domain;
  for (const Command& command : commands) domain.push_back(domains.of(command));
  CommandScores scores;
  scores.answers.resize(commands.size());
  const Questions questions(reader, marked, options);
  ltl::parallel_for(commands.size(), 2,
                    [&](std::size_t i, std::size_t) { scores.answers[i] = questions.answer(commands[i], domain[i]); });
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

LiftedReader learn_reader(std::vector<LiftedExample> own, std::span<const LiftedExample> people,
                          const std::shared_ptr<const WordVectors>& vectors, const MentionModel& mentions,
                          const CommandsExperiment& how) {
  std::vector<LiftedExample> all = own;
  all.insert(all.end(), people.begin(), people.end());
  std::vector<std::shared_ptr<const LiftedNetwork>> networks;
  const auto parts = static_cast<double>(how.networks + 1);  // the matcher takes about as long as a network
  for (std::size_t i = 0; i < how.networks; ++i) {
    LiftedTraining training = how.network;
    training.seed += i;
    networks.push_back(learn_lifted(all, vectors, training, [&](double done) {
      if (how.progress) how.progress((static_cast<double>(i) + done) / parts);
    }));
  }
  MatcherTraining training = how.matcher;
  training.seed = how.network.seed;
  if (!people.empty())
    std::erase_if(own, [](const LiftedExample& e) { return e.lifted.front() != LiftedSymbol::Nothing; });
  own.insert(own.end(), people.begin(), people.end());
  auto matcher = learn_matcher(own, training, [&](double done) {
    if (how.progress) how.progress((static_cast<double>(how.networks) + done) / parts);
  });
  return {vectors, std::move(networks), mentions, std::move(matcher)};
}

LiftedReader train_commands(const CommandSplit& split, CommandDomains& domains, const MarkedCommands& marked,
                            const SynchronousGrammar& grammar, const std::shared_ptr<const WordVectors>& vectors,
                            const CommandsExperiment& how) {
  const auto synonyms = std::make_shared<const Synonyms>(how.synonyms);
  std::vector<Command> with_marks, others;
  for (const Command& command : split.training) (command.marked ? with_marks : others).push_back(command);
  const MentionModel mentions{learn_mentions(split.training, domains, *synonyms).weights, synonyms};
  std::vector<LiftedExample> people =
      labelled_commands(others, domains, mentions, split.new_kinds ? 1 : 0, how.doubted).examples;
  const auto texts = marked_examples(with_marks, marked);
  people.insert(people.end(), texts.examples.begin(), texts.examples.end());
  return learn_reader(own_commands(grammar, *vectors, how.own), people, vectors, mentions, how);
}

}  // namespace waymark::parser

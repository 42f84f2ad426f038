#include "libparser/ground.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>

#include "libparser/corpus/token.hpp"
#include "libparser/rerank/paragraph.hpp"
#include "libparser/rerank/reranker.hpp"

namespace waymark::parser {
namespace {

// Adds a program at the end: `stay` says nothing beside other steps.
void append(Program& program, const Program& more) {
  for (const Step& step : more)
    if (step.kind != StepKind::Stay) program.push_back(step);
}

Program or_stay(Program program) {
  if (program.empty()) program.push_back(Step{});
  return program;
}

// The likeliest joinings of a program of the one list with a program of the other, best first; both lists sorted.
std::vector<Weighed> join(const std::vector<Weighed>& firsts, const std::vector<Weighed>& seconds, std::size_t top) {
  struct Pair {
    std::size_t i, j;
    double log_probability;
    bool operator<(const Pair& other) const {
      if (log_probability != other.log_probability) return log_probability < other.log_probability;
      return std::pair(i, j) > std::pair(other.i, other.j);
    }
  };
  std::priority_queue<Pair> open;
  const auto push = [&](std::size_t i, std::size_t j) {
    if (i < firsts.size() && j < seconds.size()) open.push({i, j, firsts[i].log_weight + seconds[j].log_weight});
  };
  push(0, 0);
  std::vector<Weighed> joined;
  while (!open.empty() && joined.size() < top) {
    const Pair best = open.top();
    open.pop();
    joined.push_back({firsts[best.i].program, best.log_probability, 0});
    append(joined.back().program, seconds[best.j].program);
    push(best.i, best.j + 1);
    if (best.j == 0) push(best.i + 1, 0);
  }
  return joined;
}

// Programs → readings with probabilities that sum to 1; programs with one formula are one reading.
std::vector<Reading> readings_of(const std::vector<Weighed>& programs, ltl::Arena& arena) {
  std::vector<Reading> readings;
  double total = 0, highest = -std::numeric_limits<double>::infinity();
  for (const Weighed& weighed : programs) highest = std::max(highest, weighed.log_weight);
  for (const Weighed& weighed : programs) {
    const Program program = or_stay(weighed.program);
    const ltl::Formula formula = formula_of(program, arena);
    const double probability = std::exp(weighed.log_weight - highest);
    total += probability;
    const auto same =
        std::find_if(readings.begin(), readings.end(), [&](const Reading& r) { return r.formula == formula; });
    if (same != readings.end())
      same->probability += probability;
    else
      readings.push_back({formula, probability, program});
  }
  for (Reading& reading : readings) reading.probability /= total;
  return readings;
}

// p(program | sentence, map): that of its end, shared among the programs that lead there by their weight; 0 without a
// route. When none has a route, the weights alone.
std::vector<double> on_the_map(const Decision& decision, bool one_an_end) {
  std::vector<double> weights;
  for (const Weighed& candidate : decision.candidates) weights.push_back(std::exp(candidate.log_weight));
  if (decision.ends.empty()) return weights;
  std::vector<double> probabilities(weights.size(), 0.0);
  for (const End& end : decision.ends) {
    if (one_an_end) {
      probabilities[end.candidate] += end.mass;
      continue;
    }
    const auto leads_there = [&](std::size_t c) { return decision.plans[c] && decision.plans[c]->end == end.pose; };
    double total = 0;
    for (std::size_t c = 0; c < weights.size(); ++c)
      if (leads_there(c)) total += weights[c];
    for (std::size_t c = 0; c < weights.size(); ++c)
      if (leads_there(c)) probabilities[c] = end.mass * weights[c] / total;
  }
  return probabilities;
}

void by_probability(std::vector<Reading>& readings) {
  std::stable_sort(readings.begin(), readings.end(),
                   [](const Reading& a, const Reading& b) { return a.probability > b.probability; });
}

// Sentences that were heard, and what they come to from any pose.
class Hearing {
 public:
  Hearing(const Grounder& grounder, const Executor& executor, const GroundOptions& options)
      : grounder_(grounder), executor_(executor), options_(options) {}

  void hear(const std::string& sentence, bool heading_unknown) {
    inputs_.push_back({tokenize(sentence), heading_unknown});
    programs_.push_back(likely_programs(grounder_, inputs_.back(), {options_.beam, options_.then}));
  }
  void forget() {
    inputs_.clear();
    programs_.clear();
  }
  std::size_t heard() const { return inputs_.size(); }

  Decision decided(std::size_t k, std::span<const plan::PoseId> from) const {
    Decision decision = decide(programs_[k], executor_, from, options_.then);
    choose_end(*grounder_.ranking, executor_, inputs_[k], from, decision);
    return decision;
  }
  TransitionDistribution outlook(std::size_t k, plan::PoseId from) const {
    Decision decision = decide(programs_[k], executor_, {&from, 1}, options_.then);
    const double evidence = choose_and_locate(*grounder_.ranking, executor_, inputs_[k], from, decision);
    return {shares(decision), evidence};
  }
  static std::vector<std::pair<plan::PoseId, double>> shares(const Decision& decision) {
    std::vector<std::pair<plan::PoseId, double>> out;
    double total = 0;
    for (const End& end : decision.ends) total += end.mass;
    for (const End& end : decision.ends) out.emplace_back(end.pose, end.mass / total);
    return out;
  }

 private:
  const Grounder& grounder_;
  const Executor& executor_;
  const GroundOptions& options_;
  std::vector<SentenceInput> inputs_;
  std::vector<std::vector<Weighed>> programs_;
};

// What all sentences but the last come to.
struct Settled {
  Program program;
  std::vector<plan::PoseId> here;
};

// The last one has a say in it: it tells where those before it ended (choosing/paragraph.hpp).
Settled settle(const Grounder& grounder, const Executor& executor, const std::vector<std::string>& sentences,
               std::span<const plan::PoseId> starts, const GroundOptions& options) {
  Hearing hearing(grounder, executor, options);
  Settled settled{{}, {starts.begin(), starts.end()}};
  Decision decision;
  std::size_t next = 0;
  while (next + 1 < sentences.size() && decision.ends.empty()) {  // what leads nowhere says nothing
    hearing.forget();
    hearing.hear(sentences[next++], starts.size() > 1);
    decision = hearing.decided(0, settled.here);
  }
  if (decision.ends.empty()) return settled;
  while (next < sentences.size()) hearing.hear(sentences[next++], false);
  std::vector<plan::PoseId> way =
      likeliest_way(executor.map(), {Hearing::shares(decision), 0}, hearing.heard(),
                    [&](std::size_t k, plan::PoseId from) { return hearing.outlook(k, from); }, {});
  way.pop_back();
  for (std::size_t k = 0; k < way.size(); ++k) {
    const Decision taken = hearing.decided(k, settled.here);
    for (const End& end : taken.ends)
      if (end.pose == way[k]) append(settled.program, taken.candidates[end.candidate].program);
    settled.here = {way[k]};
  }
  return settled;
}

}  // namespace

std::vector<Reading> ground(const Grounder& grounder, std::string_view text, ltl::Arena& arena,
                            const GroundOptions& options) {
  grounder.ranking->language.check_vocabulary(arena.vocabulary(), "the formulas");
  const std::vector<std::string> sentences = split_sentences(text);
  if (sentences.empty()) return {};
  std::vector<Weighed> programs{{}};
  for (const std::string& sentence : sentences) {
    const SentenceInput input{tokenize(sentence), false};
    programs = join(programs, likely_programs(grounder, input, {options.beam, options.then}), options.top);
  }
  std::vector<Reading> readings = readings_of(programs, arena);
  by_probability(readings);
  return readings;
}

std::vector<Reading> ground(const Grounder& grounder, std::string_view text, const plan::Map& map,
                            std::span<const plan::PoseId> starts, ltl::Arena& arena, const GroundOptions& options) {
  return ground(grounder, text, Executor(map), starts, arena, options);
}

std::vector<Reading> ground(const Grounder& grounder, std::string_view text, const Executor& executor,
                            std::span<const plan::PoseId> starts, ltl::Arena& arena, const GroundOptions& options) {
  const plan::Map& map = executor.map();
  grounder.ranking->language.check_vocabulary(arena.vocabulary(), "the formulas");
  grounder.ranking->language.check_vocabulary(map.vocabulary(), "map " + map.name());
  const std::vector<std::string> sentences = split_sentences(text);
  if (sentences.empty() || starts.empty()) return {};
  const Settled settled = settle(grounder, executor, sentences, starts, options);
  const SentenceInput input{tokenize(sentences.back()), settled.here.size() > 1};
  Decision decision = decide(grounder, executor, input, settled.here, {options.beam, options.then});
  choose_end(*grounder.ranking, executor, input, settled.here, decision);
  const std::vector<double> weights = on_the_map(decision, options.one_an_end);
  std::vector<Weighed> programs;
  for (std::size_t c = 0; c < weights.size(); ++c) {
    if (options.one_an_end && weights[c] <= 0) continue;
    programs.push_back({settled.program, std::log(weights[c]), 0});
    append(programs.back().program, decision.candidates[c].program);
  }
  std::vector<Reading> readings = readings_of(programs, arena);
  by_probability(readings);
  if (!decision.ends.empty()) {
    Program best = settled.program;
    append(best, decision.candidates[decision.ends.front().candidate].program);
    best = or_stay(std::move(best));
    const ltl::Formula formula = formula_of(best, arena);
    const auto chosen =
        std::find_if(readings.begin(), readings.end(), [&](const Reading& r) { return r.formula == formula; });
    std::rotate(readings.begin(), chosen, chosen + 1);
  }
  if (readings.size() > options.top)
    readings.erase(readings.begin() + static_cast<std::ptrdiff_t>(options.top), readings.end());
  return readings;
}

std::size_t choose(std::span<const Reading> readings, const plan::Map& map, std::span<const plan::PoseId> starts,
                   Then then) {
  const Executor executor(map);
  std::vector<Weighed> candidates;
  std::vector<std::optional<Plan>> plans;
  for (const Reading& reading : readings) {
    const double log_probability = std::log(reading.probability);
    candidates.push_back({reading.program, log_probability, log_probability});
    auto plan = plan_from(executor, reading.program, starts, then);
    plans.push_back(plan ? std::optional<Plan>(std::move(plan->first)) : std::nullopt);
  }
  const std::vector<End> ends = rank_ends(candidates, plans);
  return ends.empty() ? 0 : ends.front().candidate;
}

}  // namespace waymark::parser

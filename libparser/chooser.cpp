#include "libparser/chooser.hpp"

#include <algorithm>
#include <cmath>

#include "libparser/lexicon.hpp"

namespace waymark::parser {
namespace {

enum Template : std::uint64_t { LogMass = 64, Alone, WithWord, WithPair, Mentioned, Missing, Count };
enum Kind : std::uint64_t {
  Actions = 1,
  Pattern,
  Moves,
  Turns,
  LastAction,
  AtEnd,
  FirstAtEnd,
  Passed,
  OpenStart
};

std::uint64_t key(Template which, std::uint64_t kind, std::uint64_t id, std::uint64_t word = 0) {
  return static_cast<std::uint64_t>(which) << 56U | (kind & 0xFFU) << 48U | (id & 0xFFFFFFU) << 24U |
         (word & 0xFFFFFFU);
}

std::uint32_t mix(std::uint32_t a, std::uint32_t b) {
  const std::uint64_t h = (std::uint64_t{a} << 32U | b) * 0x9E3779B97F4A7C15ULL;
  return static_cast<std::uint32_t>(h >> 40U);
}

std::uint32_t fold(const std::vector<plan::Action>& actions, bool runs_only) {
  std::uint32_t h = 7;
  for (std::size_t i = 0; i < actions.size() && i < 16; ++i)
    if (!runs_only || i == 0 || actions[i] != actions[i - 1])
      h = mix(h, static_cast<std::uint32_t>(actions[i]));
  return h;
}

plan::Action mirror_action(plan::Action action) {
  if (action == plan::Action::Forward) return action;
  return action == plan::Action::Left ? plan::Action::Right : plan::Action::Left;
}

}  // namespace

ChooserSentence::ChooserSentence(const LinearModel& model, const SentenceInput& input, bool mirrored)
    : model_(&model), heading_unknown_(input.heading_unknown), mirrored_(mirrored) {
  std::uint32_t before = WordTable::begin;
  for (std::size_t i = 0; i <= input.tokens.size(); ++i) {
    const std::uint32_t word = i < input.tokens.size() ? model.words.find(input.tokens[i]) : WordTable::end;
    if (i < input.tokens.size() && word != WordTable::unknown) words_.push_back(word);
    if (before != WordTable::unknown && word != WordTable::unknown) pairs_.push_back(mix(before, word));
    before = word;
  }
  for (auto* list : {&words_, &pairs_}) {
    std::sort(list->begin(), list->end());
    list->erase(std::unique(list->begin(), list->end()), list->end());
  }
  const std::vector<std::string> said = mentions(input.tokens);
  things_ = static_cast<std::size_t>(std::count_if(
      said.begin(), said.end(), [](const std::string& s) { return s.rfind("thing ", 0) == 0; }));
  for (const std::string& word : input.tokens)
    if (const std::size_t n = number_named(word); n > 0) counts_.push_back(n);
  const Columns& columns = model.columns();
  const SentenceFeatures features = sentence_features(input, model.words);
  const std::vector<bool> forbidden = forbidden_tokens(model.grammar(), model.vocabulary(), features);
  for (std::uint16_t p = 0; p < model.vocabulary().size(); ++p) {
    const std::size_t token = PostfixGrammar::literal(p);
    const std::string& thing = columns.parts[columns.thing[token] - columns.tokens];
    mentioned_.push_back(std::binary_search(said.begin(), said.end(), thing));
    hidden_.push_back(forbidden[token]);
    images_.push_back(p);
  }
  if (mirrored) images_ = mirror_images(model.vocabulary());
}

void ChooserSentence::route_properties(const Executor& executor, plan::PoseId start, const Plan& plan,
                                       std::vector<Property>& out) const {
  std::vector<plan::Action> actions = plan.actions;
  std::vector<std::uint32_t> poses{Arrival::start(start)};  // labels without events
  for (plan::Action action : actions)
    poses.push_back(Arrival::start(*executor.map().successor(Arrival::pose(poses.back()), action)));
  if (mirrored_) std::transform(actions.begin(), actions.end(), actions.begin(), mirror_action);
  const auto moves =
      static_cast<std::size_t>(std::count(actions.begin(), actions.end(), plan::Action::Forward));
  const std::uint32_t pattern = fold(actions, true);
  out.push_back({Actions, fold(actions, false), true});
  out.push_back({Pattern, pattern, true});
  out.push_back({Moves, std::min<std::size_t>(moves, 10), true});
  out.push_back({Turns, std::min<std::size_t>(actions.size() - moves, 5), true});
  out.push_back({LastAction, actions.empty() ? 3U : static_cast<std::uint64_t>(actions.back()), true});
  if (heading_unknown_) out.push_back({OpenStart, pattern, true});
  for (std::uint16_t p = 0; p < images_.size(); ++p) {
    const std::uint16_t image = images_[p];
    if (hidden_[image]) continue;
    const auto holds = [&](std::uint32_t at) { return executor.holds(p, at); };
    if (holds(poses.back())) {
      out.push_back({AtEnd, image, false});
      if (std::none_of(poses.begin(), poses.end() - 1, holds)) out.push_back({FirstAtEnd, image, false});
    }
    const Columns& columns = model_->columns();
    const bool here =
        columns.parts[columns.direction[PostfixGrammar::literal(p)] - columns.tokens] == "direction here";
    if (here && poses.size() > 2 && std::any_of(poses.begin() + 1, poses.end() - 1, holds))
      out.push_back({Passed, image, false});
  }
}

void ChooserSentence::mention_features(const std::vector<Property>& properties, std::size_t moves,
                                       std::vector<std::pair<std::uint64_t, float>>& out) const {
  const Columns& columns = model_->columns();
  std::vector<std::uint16_t> met;  // things that are mentioned and met
  for (const Property& property : properties) {
    if (property.kind != AtEnd && property.kind != FirstAtEnd && property.kind != Passed) continue;
    if (!mentioned_[property.id]) continue;
    const std::size_t token = PostfixGrammar::literal(static_cast<std::uint16_t>(property.id));
    out.emplace_back(key(Mentioned, property.kind, columns.direction[token]), 1.0F);
    met.push_back(columns.thing[token]);
  }
  std::sort(met.begin(), met.end());
  const auto distinct = static_cast<std::size_t>(std::unique(met.begin(), met.end()) - met.begin());
  out.emplace_back(key(Missing, 0, std::min<std::size_t>(things_ - std::min(things_, distinct), 3)), 1.0F);
  for (std::size_t n : counts_) out.emplace_back(key(Count, n == moves ? 1 : 0, moves == 0 ? 1 : 0), 1.0F);
}

void ChooserSentence::features(const Executor& executor, plan::PoseId start, const Plan& plan, double mass,
                               std::vector<std::pair<std::uint64_t, float>>& out) const {
  std::vector<Property> properties;
  route_properties(executor, start, plan, properties);
  out.clear();
  out.emplace_back(key(LogMass, 0, 0), static_cast<float>(std::log(std::max(mass, 1e-9))));
  for (const Property& property : properties) {
    out.emplace_back(key(Alone, property.kind, property.id), 1.0F);
    for (std::uint32_t word : words_) out.emplace_back(key(WithWord, property.kind, property.id, word), 1.0F);
    if (!property.with_pairs) continue;
    for (std::uint32_t pair : pairs_) out.emplace_back(key(WithPair, property.kind, property.id, pair), 1.0F);
  }
  const auto moves =
      static_cast<std::size_t>(std::count(plan.actions.begin(), plan.actions.end(), plan::Action::Forward));
  mention_features(properties, moves, out);
}

std::uint64_t log_mass_feature() { return key(LogMass, 0, 0); }

void choose_end(const LinearModel& model, const Executor& executor, const SentenceInput& input,
                std::span<const plan::PoseId> starts, Decision& decision) {
  if (model.chooser.rows() == 0 || decision.ends.size() < 2) return;
  const ChooserSentence sentence(model, input);
  std::vector<std::pair<std::uint64_t, float>> features;
  std::vector<double> scores;
  for (const End& end : decision.ends) {
    sentence.features(executor, starts[decision.start[end.candidate]], *decision.plans[end.candidate],
                      end.mass, features);
    double score = 0;
    for (const auto& [feature, value] : features)
      if (const std::uint32_t row = model.chooser.find(feature); row != WeightTable::absent)
        score += static_cast<double>(value) * static_cast<double>(*model.chooser.row(row));
    scores.push_back(score);
  }
  const double highest = *std::max_element(scores.begin(), scores.end());
  double total = 0;
  for (double score : scores) total += std::exp(score - highest);
  for (std::size_t i = 0; i < scores.size(); ++i)
    decision.ends[i].mass = std::exp(scores[i] - highest) / total;
  std::stable_sort(decision.ends.begin(), decision.ends.end(),
                   [](const End& a, const End& b) { return a.mass > b.mass; });
}

}  // namespace waymark::parser

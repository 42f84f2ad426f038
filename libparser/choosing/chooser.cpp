#include "libparser/choosing/chooser.hpp"

#include <algorithm>
#include <cmath>

#include "libparser/programs/lexicon.hpp"

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
  const auto propositions = static_cast<std::uint16_t>(model.vocabulary().size());
  for (std::uint16_t p = 0; p < propositions; ++p) {
    const std::size_t token = PostfixGrammar::literal(p);
    const std::string& thing = columns.parts[columns.thing[token] - columns.tokens];
    mentioned_.push_back(std::binary_search(said.begin(), said.end(), thing));
    hidden_.push_back(forbidden[token]);
    images_.push_back(p);
  }
  if (mirrored) images_ = mirror_images(model.vocabulary());
}

std::vector<ChooserSentence::Property> ChooserSentence::route_properties(const Executor& executor,
                                                                         plan::PoseId start,
                                                                         const Plan& plan) const {
  std::vector<Property> out;
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
  const Columns& columns = model_->columns();
  const auto propositions = static_cast<std::uint16_t>(images_.size());
  for (std::uint16_t p = 0; p < propositions; ++p) {
    const std::uint16_t image = images_[p];
    if (hidden_[image]) continue;
    const auto holds = [&](std::uint32_t at) { return executor.holds(p, at); };
    if (holds(poses.back())) {
      out.push_back({AtEnd, image, false});
      if (std::none_of(poses.begin(), poses.end() - 1, holds)) out.push_back({FirstAtEnd, image, false});
    }
    const bool here =
        columns.parts[columns.direction[PostfixGrammar::literal(p)] - columns.tokens] == "direction here";
    if (here && poses.size() > 2 && std::any_of(poses.begin() + 1, poses.end() - 1, holds))
      out.push_back({Passed, image, false});
  }
  return out;
}

void ChooserSentence::add_to_last_end(std::uint64_t first, const Property* property) {
  const auto [it, is_new] = index_.try_emplace(first, static_cast<std::uint32_t>(features_.bundles.size()));
  features_.ends.back().push_back(it->second);
  if (!is_new) return;
  auto& bundle = features_.bundles.emplace_back(1, first);
  if (property == nullptr) return;
  for (std::uint32_t word : words_) bundle.push_back(key(WithWord, property->kind, property->id, word));
  if (!property->with_pairs) return;
  for (std::uint32_t pair : pairs_) bundle.push_back(key(WithPair, property->kind, property->id, pair));
}

void ChooserSentence::add_mentions(const std::vector<Property>& properties, std::size_t moves) {
  const Columns& columns = model_->columns();
  std::vector<std::uint16_t> met;  // things that are mentioned and met
  for (const Property& property : properties) {
    if (property.kind != AtEnd && property.kind != FirstAtEnd && property.kind != Passed) continue;
    if (!mentioned_[property.id]) continue;
    const std::size_t token = PostfixGrammar::literal(static_cast<std::uint16_t>(property.id));
    add_to_last_end(key(Mentioned, property.kind, columns.direction[token]), nullptr);
    met.push_back(columns.thing[token]);
  }
  std::sort(met.begin(), met.end());
  const auto distinct = static_cast<std::size_t>(std::unique(met.begin(), met.end()) - met.begin());
  add_to_last_end(key(Missing, 0, std::min<std::size_t>(things_ - std::min(things_, distinct), 3)), nullptr);
  for (std::size_t n : counts_) add_to_last_end(key(Count, n == moves ? 1 : 0, moves == 0 ? 1 : 0), nullptr);
}

void ChooserSentence::add_end(const Executor& executor, plan::PoseId start, const Plan& plan, double mass) {
  features_.ends.emplace_back();
  features_.log_mass.push_back(static_cast<float>(std::log(std::max(mass, 1e-9))));
  const std::vector<Property> properties = route_properties(executor, start, plan);
  for (const Property& property : properties)
    add_to_last_end(key(Alone, property.kind, property.id), &property);
  const auto moves =
      static_cast<std::size_t>(std::count(plan.actions.begin(), plan.actions.end(), plan::Action::Forward));
  add_mentions(properties, moves);
}

std::uint64_t log_mass_feature() { return key(LogMass, 0, 0); }

void choose_end(const LinearModel& model, const Executor& executor, const SentenceInput& input,
                std::span<const plan::PoseId> starts, Decision& decision) {
  if (model.chooser.rows() == 0 || decision.ends.size() < 2) return;
  ChooserSentence sentence(model, input);
  for (const End& end : decision.ends)
    sentence.add_end(executor, starts[decision.start[end.candidate]], *decision.plans[end.candidate],
                     end.mass);
  const EndFeatures features = sentence.take();
  const auto weight = [&](std::uint64_t feature) {
    const std::uint32_t row = model.chooser.find(feature);
    return row == WeightTable::absent ? 0.0 : static_cast<double>(model.chooser.weight(row, 0));
  };
  std::vector<double> bundles;
  for (const auto& bundle : features.bundles) {
    bundles.push_back(0);
    for (std::uint64_t feature : bundle) bundles.back() += weight(feature);
  }
  std::vector<double> scores;
  for (std::size_t i = 0; i < features.ends.size(); ++i) {
    scores.push_back(weight(log_mass_feature()) * static_cast<double>(features.log_mass[i]));
    for (std::uint32_t bundle : features.ends[i]) scores.back() += bundles[bundle];
  }
  const double highest = *std::max_element(scores.begin(), scores.end());
  double total = 0;
  for (double& score : scores) total += score = std::exp(score - highest);
  for (std::size_t i = 0; i < scores.size(); ++i) decision.ends[i].mass = scores[i] / total;
  std::stable_sort(decision.ends.begin(), decision.ends.end(),
                   [](const End& a, const End& b) { return a.mass > b.mass; });
}

}  // namespace waymark::parser

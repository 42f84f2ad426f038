#include "libparser/rerank/route_features.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "libparser/lexicon/lexicon.hpp"

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
  OpenStart,
  AtDeparture,
  Along,
  LastAlong,
  AtTurn,
  LastRun,
  FirstRun,
  Runs,
  Crossings,
  Before
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
    if (!runs_only || i == 0 || actions[i] != actions[i - 1]) h = mix(h, static_cast<std::uint32_t>(actions[i]));
  return h;
}

plan::Action mirror_action(plan::Action action) {
  if (action == plan::Action::Forward) return action;
  return action == plan::Action::Left ? plan::Action::Right : plan::Action::Left;
}

}  // namespace

RerankerSentence::RerankerSentence(const RankingModel& model, const SentenceInput& input, bool mirrored)
    : model_(&model), heading_unknown_(input.heading_unknown), mirrored_(mirrored) {
  WordId before = WordTable::begin;
  for (std::size_t i = 0; i <= input.tokens.size(); ++i) {
    const WordId word = i < input.tokens.size() ? model.words.find(input.tokens[i]) : WordTable::end;
    if (i < input.tokens.size() && word != WordTable::unknown) words_.push_back(word.index);
    if (before != WordTable::unknown && word != WordTable::unknown) pairs_.push_back(mix(before.index, word.index));
    before = word;
  }
  for (auto* list : {&words_, &pairs_}) {
    std::sort(list->begin(), list->end());
    list->erase(std::unique(list->begin(), list->end()), list->end());
  }
  const std::vector<Part> said = mentions(input.tokens);
  things_ = static_cast<std::size_t>(
      std::count_if(said.begin(), said.end(), [](const Part& part) { return part.kind == PartKind::Thing; }));
  for (const std::string& word : input.tokens)
    if (const std::size_t n = number_named(word); n > 0) counts_.push_back(n);
  const Columns& columns = model.language.columns();
  const SentenceFeatures features = sentence_features(input, model.words);
  const std::vector<bool> forbidden = forbidden_tokens(model.language, features);
  const auto propositions = static_cast<std::uint16_t>(model.language.vocabulary().size());
  for (std::uint16_t p = 0; p < propositions; ++p) {
    const std::size_t token = PostfixGrammar::literal(p);
    mentioned_.push_back(std::binary_search(said.begin(), said.end(), columns.part(columns.thing[token])));
    hidden_.push_back(forbidden[token]);
    images_.push_back(p);
  }
  if (mirrored) images_ = mirror_images(model.language.vocabulary());
}

// The actions that words may speak of, and the poses they are seen from (as Arrival counts them, without events).
struct RerankerSentence::Walk {
  std::vector<plan::Action> actions;  // mirrored if need be; without first turns that nobody speaks of
  std::uint32_t first_turns;          // those turns and what follows, without repetitions
  std::vector<Arrival> poses;         // of the whole route, the start first
  std::vector<Arrival> moved_from;    // where each move begins
  std::vector<Arrival> turned_at;     // where a turn follows a move
  std::vector<std::size_t> runs;      // of moves without a turn between them
  std::size_t last_run = 0;           // moves at the end of the route
};

RerankerSentence::Walk RerankerSentence::walk_of(const Executor& executor, plan::PoseId start, const Plan& plan) const {
  using plan::Action;
  Walk walk{plan.actions, 0, {Arrival::start(start)}, {}, {}, {}};
  for (const Action action : plan.actions)
    walk.poses.push_back(Arrival::start(*executor.map().successor(walk.poses.back().pose(), action)));
  if (mirrored_) std::transform(walk.actions.begin(), walk.actions.end(), walk.actions.begin(), mirror_action);
  walk.first_turns = fold(walk.actions, true);
  if (heading_unknown_)
    walk.actions.erase(walk.actions.begin(), std::find(walk.actions.begin(), walk.actions.end(), Action::Forward));
  const std::size_t left_out = plan.actions.size() - walk.actions.size();
  for (std::size_t i = 0; i < walk.actions.size(); ++i) {
    const Arrival at = walk.poses[left_out + i];
    const bool after_move = i > 0 && walk.actions[i - 1] == Action::Forward;
    if (walk.actions[i] == Action::Forward) {
      if (!after_move) walk.runs.push_back(0);
      ++walk.runs.back();
      walk.moved_from.push_back(at);
    } else if (after_move) {
      walk.turned_at.push_back(at);
    }
  }
  if (!walk.actions.empty() && walk.actions.back() == Action::Forward) walk.last_run = walk.runs.back();
  return walk;
}

void RerankerSentence::add_shape(const Walk& walk, std::vector<Property>& out) const {
  const auto up_to = [](std::size_t n, std::size_t most) { return std::uint64_t{std::min(n, most)}; };
  const std::size_t moves = walk.moved_from.size();
  if (heading_unknown_) out.push_back({OpenStart, walk.first_turns, true});
  out.push_back({Actions, fold(walk.actions, false), true});
  out.push_back({Pattern, fold(walk.actions, true), true});
  out.push_back({Moves, up_to(moves, 10), true});
  out.push_back({Turns, up_to(walk.actions.size() - moves, 5), true});
  out.push_back({LastAction, walk.actions.empty() ? 3U : static_cast<std::uint64_t>(walk.actions.back()), true});
  out.push_back({LastRun, up_to(walk.last_run, 10), true});
  out.push_back({FirstRun, walk.runs.empty() ? 0U : up_to(walk.runs.front(), 10), true});
  out.push_back({Runs, up_to(walk.runs.size(), 4), true});
}

void RerankerSentence::add_sights(const Executor& executor, const Walk& walk, std::vector<Property>& out) const {
  const auto crossing = model_->language.vocabulary().find("intersection");
  const auto propositions = static_cast<std::uint16_t>(images_.size());
  for (std::uint16_t p = 0; p < propositions; ++p) {
    const std::uint16_t image = images_[p];
    if (hidden_[image]) continue;
    const auto holds = [&](Arrival at) { return executor.holds(p, at); };
    const auto count = [&](auto begin, auto end) { return static_cast<std::size_t>(std::count_if(begin, end, holds)); };
    const auto& [poses, moved_from] = std::tie(walk.poses, walk.moved_from);
    const auto& [direction, kind, name] = model_->language.observables()[p];
    const bool next = direction == plan::Direction::Next,
               here = direction == plan::Direction::Here && kind != plan::Kind::PlaceNumber;
    if (holds(poses.back())) {
      const std::size_t before = count(poses.begin(), poses.end() - 1);
      out.push_back({AtEnd, image, false});
      if (before == 0) out.push_back({FirstAtEnd, image, false});
      if (mentioned_[image] && !next) out.push_back({Before, std::min<std::size_t>(before, 4), true});
    }
    if (here && poses.size() > 2 && count(poses.begin() + 1, poses.end() - 1) > 0)
      out.push_back({Passed, image, false});
    if (!moved_from.empty() && !next && holds(moved_from.front())) out.push_back({AtDeparture, image, false});
    if (direction == plan::Direction::Ahead) {
      if (count(moved_from.begin(), moved_from.end()) > 0) out.push_back({Along, image, false});
      if (walk.last_run > 0 && holds(moved_from.back())) out.push_back({LastAlong, image, false});
    }
    if (count(walk.turned_at.begin(), walk.turned_at.end()) > 0) out.push_back({AtTurn, image, false});
    if (crossing && crossing->index == p) {
      const std::size_t crossed = moved_from.empty() ? 0 : count(moved_from.begin() + 1, moved_from.end());
      out.push_back({Crossings, std::min<std::size_t>(crossed, 5), true});
    }
  }
}

void RerankerSentence::add_to_last_end(std::uint64_t first, const Property* property) {
  const auto [it, is_new] = index_.try_emplace(first, static_cast<std::uint32_t>(features_.bundles.size()));
  features_.candidates.back().push_back(it->second);
  if (!is_new) return;
  auto& bundle = features_.bundles.emplace_back();
  bundle.push_back({first, 1});
  if (property == nullptr) return;
  for (std::uint32_t word : words_) bundle.push_back({key(WithWord, property->kind, property->id, word), 1});
  if (!property->with_pairs) return;
  for (std::uint32_t pair : pairs_) bundle.push_back({key(WithPair, property->kind, property->id, pair), 1});
}

void RerankerSentence::add_mentions(const std::vector<Property>& properties, std::size_t moves) {
  const Columns& columns = model_->language.columns();
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

void RerankerSentence::add_end(const Executor& executor, plan::PoseId start, const Plan& plan, double mass) {
  features_.candidates.push_back({static_cast<std::uint32_t>(features_.bundles.size())});
  features_.bundles.push_back({{log_mass_feature(), static_cast<float>(std::log(std::max(mass, 1e-9)))}});
  std::vector<Property> properties;
  const Walk walk = walk_of(executor, start, plan);
  add_shape(walk, properties);
  add_sights(executor, walk, properties);
  for (const Property& property : properties) add_to_last_end(key(Alone, property.kind, property.id), &property);
  add_mentions(properties, walk.moved_from.size());
}

std::uint64_t log_mass_feature() { return key(LogMass, 0, 0); }

}  // namespace waymark::parser

#include "libparser/domain/streets/pragmatic_features.hpp"

#include <algorithm>
#include <cmath>
#include <set>

namespace waymark::streets {
namespace {

using K = FeatureKind;

std::size_t at_most(std::size_t value, std::size_t most) { return std::min(value, most); }

bool named(const TextOnRoute& text, LandmarkIndex landmark) {
  return std::any_of(text.placed.begin(), text.placed.end(),
                     [landmark](const PlacedMention& m) { return m.landmark == landmark; });
}

void add_rival_named(FeatureList& out, const TextOnRoute& text, LandmarkIndex landmark) {
  const StreetRoute& route = text.route.landmarks;
  std::size_t at = 0;
  double nearest = 1e9;
  for (std::size_t i = 0; i < route.size(); ++i)
    if (const double d = closeness(text.map, landmark, route[i]); d < nearest) nearest = d, at = i;
  const unsigned role = at == 0 ? 0 : at + 1 == route.size() ? 2 : 1;
  const bool neighbour_named = named(text, route[at]);
  out.add(K::RivalNamed, 1, 0, bin(nearest, {0.02, 0.06, 0.13, 0.25, 0.4}), role, neighbour_named);
  out.add(K::RivalNamed, 1, 1, bin(distance_from(text.map, route, landmark) / text.unit, {0.02, 0.05, 0.1, 0.2, 0.4}),
          neighbour_named);
}

// 2: what is named, one after the other, is the route; 1: in another order; 0: neither.
unsigned agreement(const StreetRoute& said, const StreetRoute& route) {
  if (said == route) return 2;
  const std::set<LandmarkIndex> all(said.begin(), said.end());
  return all == std::set<LandmarkIndex>(route.begin(), route.end()) ? 1 : 0;
}

struct Count {
  std::size_t all = 0, named = 0;
};

Count only_on(const TextOnRoute& text, const StreetRoute& here, const StreetRoute& there) {
  Count count;
  for (const LandmarkIndex landmark : here) {
    if (stands_on(there, landmark)) continue;
    ++count.all;
    count.named += named(text, landmark) ? 1U : 0U;
  }
  return count;
}

}  // namespace

double closeness(const StreetMap& map, LandmarkIndex a, LandmarkIndex b) {
  constexpr double above = 4;
  double left = 1e9, right = -1e9, bottom = 1e9, top = -1e9;
  for (const Landmark& l : map.landmarks) {
    left = std::min(left, l.right), right = std::max(right, l.right);
    bottom = std::min(bottom, l.up), top = std::max(top, l.up);
  }
  const auto share = [](double d, double extent) { return extent > 0 ? std::abs(d) / extent : 0; };
  const Landmark &x = map.landmarks[a], &y = map.landmarks[b];
  return std::max(share(x.right - y.right, right - left), above * share(x.up - y.up, top - bottom));
}

void add_sight(FeatureList& out, const TextOnRoute& text) {
  const StreetRoute &route = text.route.landmarks, &rival = text.route.rival;
  std::size_t unseen = 0, beside_it = 0;
  for (const PlacedMention& mention : text.placed) {
    if (mention.position != off_route) continue;
    if (!stands_on(rival, mention.landmark)) {
      ++unseen;
      continue;
    }
    ++beside_it;
    add_rival_named(out, text, mention.landmark);
  }
  out.add(K::InSight, 1, 0, at_most(unseen, 3));
  out.add(K::InSight, 1, 1, at_most(beside_it, 3));
  const Count own = only_on(text, route, rival), theirs = only_on(text, rival, route);
  out.add(K::TellsApart, 1, 0, at_most(own.all, 2), at_most(own.named, 2), at_most(theirs.all, 2),
          at_most(theirs.named, 2));
  out.add(K::TellsApart, 1, 1, own.all > 0, own.all == own.named, own.named > 0, theirs.all > 0);
  StreetRoute said{route.front()};
  for (const PlacedMention& mention : text.placed)
    if (mention.landmark != said.back()) said.push_back(mention.landmark);
  out.add(K::RivalExact, 1, said == rival, agreement(said, route));
}

void add_walk(FeatureList& out, const TextOnRoute& text) {
  const Walk walk = walk_along(text.route, text.placed);
  const std::size_t n = text.placed.size();
  const auto count = [&](MentionRole step) {
    return static_cast<std::size_t>(std::count(walk.steps.begin(), walk.steps.end(), step));
  };
  const std::size_t ahead = count(MentionRole::Ahead), behind = count(MentionRole::Behind);
  out.add(K::Walk, 1, 0, at_most(walk.unreached, 3), at_most(ahead, 2), at_most(behind, 2),
          at_most(count(MentionRole::OnRival), 2), walk.reaches_goal);
  out.add(K::Walk, 1, 1, at_most(walk.unreached, 4), walk.reaches_goal);
  out.add(K::Walk, 1, 2, at_most(ahead, 3), at_most(behind, 3));
  out.add(K::Walk, 1, 3, at_most(count(MentionRole::AtStart), 2), ahead > 0);
  out.add(K::Walk, 1, 4, n > 0 ? static_cast<unsigned>(walk.steps.back()) : 9U, walk.reaches_goal);
  out.add(K::Walk, static_cast<double>(walk.unreached), 5);
  out.add(K::Walk, static_cast<double>(ahead), 6);
  out.add(K::Walk, static_cast<double>(behind), 7);
  std::size_t begin = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const auto step = static_cast<unsigned>(walk.steps[i]);
    const bool last = i + 1 == n;
    const bool again = std::count_if(text.placed.begin(), text.placed.end(),
                                     [&](const PlacedMention& m) { return m.landmark == text.placed[i].landmark; }) > 1;
    out.add(K::Step, 1, 0, step, text.cues[i].cue, again);
    out.add(K::Step, 1, 1, step, last, i == 0, again);
    out.add(K::Step, 1, 2, step, text.cues[i].cue, text.cues[i].onwards, last);
    std::set<std::uint64_t> words;
    for (std::size_t t = begin; t < text.mentions[i].begin; ++t)
      if (const std::uint64_t word = hash_of(text.tokens[t]); words.insert(word).second)
        out.add(K::StepWord, 1, step, again, word);
    begin = text.mentions[i].end;
  }
}

}  // namespace waymark::streets

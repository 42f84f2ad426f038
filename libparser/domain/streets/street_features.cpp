#include "libparser/domain/streets/street_features.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "libparser/domain/streets/pragmatic_features.hpp"
#include "libparser/domain/streets/street_directions.hpp"

namespace waymark::streets {
namespace {

using Kind = FeatureKind;

class Writer {
 public:
  Writer(FeatureList& out, const TextOnRoute& text)
      : map_(text.map),
        unit_(text.unit),
        tokens_(text.tokens),
        mentions_(text.mentions),
        cues_(text.cues),
        route_(text.route),
        nodes_(text.route.landmarks),
        placed_(text.placed),
        named_(nodes_.size(), 0),
        out_(out) {
    for (const PlacedMention& m : placed_)
      if (m.position != off_route) ++named_[m.position];
    as_read();
    take_for_neighbours();
  }

  void write() {
    moves();
    silent_landmarks();
    rank_and_length();
    coverage();
  }

 private:
  template <typename... Parts>
  void add(Kind kind, double value, Parts... parts) {
    out_.add(kind, value, parts...);
  }

  static constexpr double most_apart = 0.5;  // mean ways

  double angle(LandmarkIndex a, LandmarkIndex b) const {
    const Landmark &from = map_.landmarks[a], &to = map_.landmarks[b];
    return std::atan2(to.up - from.up, to.right - from.right) * 57.29577951308232;
  }

  double beside(LandmarkIndex l) const { return distance_from(map_, nodes_, l) / unit_; }

  std::uint32_t nearest_on_route(LandmarkIndex l) const {
    std::uint32_t best = 0;
    for (std::uint32_t i = 1; i < nodes_.size(); ++i)
      if (map_.distance(l, nodes_[i]) < map_.distance(l, nodes_[best])) best = i;
    return best;
  }

  // Which readings of the text are the route, or leave out a few of its landmarks?
  void as_read() {
    for (const streets::Interpretation& reading : readings(nodes_[0], placed_, cues_)) {
      std::size_t at = 0;
      for (const LandmarkIndex node : nodes_) at += at < reading.landmarks.size() && reading.landmarks[at] == node;
      if (at < reading.landmarks.size()) continue;
      const std::size_t silent = nodes_.size() - at;
      const bool to_goal = reading.landmarks.back() == nodes_.back();
      add(Kind::Reading, 1, reading.followed, std::min<std::size_t>(silent, 3), to_goal);
      if (silent > 0) continue;
      for (std::size_t m = 0; m < placed_.size(); ++m)
        if (cues_[m].cue == Cue::Past || cues_[m].cue == Cue::Not) {
          const bool on = placed_[m].position != off_route;
          add(Kind::PassedBy, 1, on, cues_[m].cue,
              on ? 0 : 1 + bin(beside(placed_[m].landmark), {0.02, 0.05, 0.1, 0.2, 0.4}));
          if (on) add(Kind::PassedBy, 1, 9, cues_[m].cue, passed_straight(placed_[m].position));
        }
    }
  }

  // How far a landmark on the route is from the straight line between its neighbours there.
  unsigned passed_straight(std::uint32_t p) const {
    if (p == 0 || p + 1 >= nodes_.size()) return 99;
    const double extra = map_.distance(nodes_[p - 1], nodes_[p]) + map_.distance(nodes_[p], nodes_[p + 1]) -
                         map_.distance(nodes_[p - 1], nodes_[p + 1]);
    return bin(extra / unit_, {0.002, 0.01, 0.05, 0.2});
  }

  // A landmark off the route that stands beside one on it, unnamed and in the right place of the order, was taken for
  // it.
  void take_for_neighbours() {
    std::uint32_t least = 0;
    for (std::size_t m = 0; m < placed_.size(); ++m) {
      if (placed_[m].position != off_route) {
        least = placed_[m].position;
        continue;
      }
      auto most = static_cast<std::uint32_t>(nodes_.size() - 1);
      for (std::size_t next = m + 1; next < placed_.size(); ++next)
        if (placed_[next].position != off_route) {
          most = std::max(placed_[next].position, least);
          break;
        }
      double nearest = most_apart;
      std::uint32_t at = off_route;
      for (std::uint32_t p = least; p <= most; ++p) {
        const double apart = map_.distance(placed_[m].landmark, nodes_[p]) / unit_;
        if (named_[p] == 0 && apart < nearest) nearest = apart, at = p;
      }
      if (at == off_route) continue;
      const unsigned role = at == 0 ? 0 : at + 1 == nodes_.size() ? 2 : 1;
      add(Kind::Confused, 1, role, bin(nearest, {0.05, 0.1, 0.15, 0.2, 0.3}));
      placed_[m].position = least = at;
      ++named_[at];
    }
  }

  // How the route moves between two places of it; `between`: are the landmarks jumped over named elsewhere?
  unsigned move(std::uint32_t from, std::uint32_t to) const {
    if (to == off_route) return 1;
    if (from == off_route) return 2;
    if (to == from) return 3;
    if (to == from + 1) return 4;
    if (to > from) {
      std::size_t silent = 0;
      for (std::uint32_t i = from + 1; i < to; ++i) silent += named_[i] == 0 ? 1U : 0U;
      if (silent == 0) return 5 + std::min(to - from, 4U);
      return (silent == to - from - 1 ? 10 : 14) + std::min(to - from, 4U);
    }
    return to + 1 == from ? 20 : 21;
  }

  void moves() {
    std::uint32_t from = 0;
    unsigned before = 0, last_coarse = 9;
    std::size_t begin = 0;
    for (std::size_t m = 0; m < placed_.size(); ++m) {
      const PlacedMention& here = placed_[m];
      const bool goal = here.position + 1 == nodes_.size();
      const unsigned how = move(from, here.position) * 2 + (goal ? 1U : 0U) + (m == 0 ? 100U : 0U);
      add(Kind::Move, 1, how);
      add(Kind::MoveMove, 1, how, before);
      if (m == 0)
        add(Kind::FirstMention, 1, how,
            bin(map_.distance(here.landmark, nodes_[0]) / unit_, {0.001, 0.1, 0.2, 0.3, 0.5}),
            mentions_[0].begin > 0 ? hash_of(tokens_[0]) : 0);
      words_between(how, begin, mentions_[m].begin);
      const unsigned roughly = coarse(m == 0 ? 0 : placed_[m - 1].position, here.position);
      cues_between(roughly + (m == 0 ? 10U : 0U), goal, begin, mentions_[m].begin);
      add(Kind::CoarsePair, 1, roughly, last_coarse);
      last_coarse = roughly;
      if (here.position == off_route)
        off(here, begin, mentions_[m].begin);
      else
        directions(from, here.position, begin, mentions_[m].begin);
      before = how;
      if (here.position != off_route) from = here.position;
      begin = mentions_[m].end;
    }
    const unsigned how = from + 1 == nodes_.size() ? 1 : placed_.empty() ? 2 : 0;
    add(Kind::Goal, 1, how, before);
    std::set<std::uint64_t> seen;
    for (std::size_t i = begin; i < tokens_.size(); ++i)
      if (seen.insert(hash_of(tokens_[i])).second) add(Kind::GoalWord, 1, how, hash_of(tokens_[i]));
  }

  unsigned coarse(std::uint32_t from, std::uint32_t to) const {
    if (to == off_route) return 0;
    if (from == off_route) return 1;
    if (to == from) return 2;
    if (to == from + 1) return 3;
    return to > from ? 4 : 5;
  }

  void cues_between(unsigned how, bool goal, std::size_t begin, std::size_t end) {
    unsigned cues = 0;
    for (std::size_t i = begin; i < end; ++i) {
      add(Kind::CoarseWord, 1, how, hash_of(tokens_[i]));
      cues |= 1U << static_cast<unsigned>(cue_of(tokens_[i]));
    }
    for (unsigned kind = 1; kind <= 10; ++kind)
      if ((cues >> kind & 1U) != 0) add(Kind::Cue, 1, how, kind, goal);
    // The last cue word before the landmark says most.
    for (std::size_t i = end; i-- > begin;)
      if (const unsigned kind = static_cast<unsigned>(cue_of(tokens_[i])); kind != 0) {
        add(Kind::Cue, 1, how, 100 + kind, goal);
        break;
      }
  }

  void words_between(unsigned how, std::size_t begin, std::size_t end) {
    std::set<std::uint64_t> seen;
    std::uint64_t gap = 0;
    for (std::size_t i = begin; i < end; ++i) {
      const std::uint64_t word = hash_of(tokens_[i]);
      gap = mix(gap, word);
      if (seen.insert(word).second) add(Kind::MoveWord, 1, how, word);
    }
    add(Kind::MoveGap, 1, how, gap);
    if (end > begin)
      add(Kind::StartWord, 1, how, hash_of(tokens_[end - 1]), end - begin > 1 ? hash_of(tokens_[end - 2]) : 0);
  }

  void off(const PlacedMention& here, std::size_t begin, std::size_t end) {
    const double away = beside(here.landmark);
    const unsigned how_far = bin(away, {0.03, 0.08, 0.15, 0.25, 0.4, 0.7});
    const std::uint32_t nearest = nearest_on_route(here.landmark);
    const unsigned apart = bin(map_.distance(here.landmark, nodes_[nearest]) / unit_, {0.05, 0.1, 0.2, 0.3, 0.5, 0.8});
    const unsigned role = nearest == 0 ? 0 : nearest + 1 == nodes_.size() ? 2 : 1;
    add(Kind::Beside, 1, how_far);
    add(Kind::Beside, 1, 100, apart, role, named_[nearest] > 0);
    for (std::size_t i = begin; i < end; ++i) add(Kind::BesideWord, 1, how_far / 2, hash_of(tokens_[i]));
  }

  void directions(std::uint32_t from, std::uint32_t to, std::size_t begin, std::size_t end) {
    if (to == from || to == off_route || to < from) return;
    const auto said = last_direction(tokens_, begin, end);
    if (!said) return;
    const auto off_by = [&](std::uint32_t a, std::uint32_t b) {
      return bin(angle_between(said->angle, angle(nodes_[a], nodes_[b])), {15, 30, 45, 67.5, 90, 135});
    };
    const auto kind = static_cast<unsigned>(said->kind);
    add(Kind::Angle, 1, kind, off_by(from, to));
    add(Kind::AngleFirst, 1, kind, off_by(to - 1, to), to == from + 1);
    add(Kind::AngleFirst, 1, kind + 10, off_by(from, from + 1), to == from + 1);
  }

  void silent_landmarks() {
    std::size_t silent = 0;
    for (std::size_t i = 1; i < nodes_.size(); ++i) {
      if (named_[i] > 0) continue;
      ++silent;
      const bool goal = i + 1 == nodes_.size();
      const auto d = [&](std::size_t a, std::size_t b) { return map_.distance(nodes_[a], nodes_[b]); };
      const double extra = goal ? d(i - 1, i) : d(i - 1, i) + d(i, i + 1) - d(i - 1, i + 1);
      const unsigned out_of_way = bin(extra / unit_, {0.005, 0.02, 0.05, 0.1, 0.2, 0.4, 0.8});
      const unsigned beside_last = bin(d(i - 1, i) / unit_, {0.05, 0.1, 0.2, 0.4, 0.8});
      const bool on_rival = std::find(route_.rival.begin(), route_.rival.end(), nodes_[i]) != route_.rival.end();
      add(Kind::Silent, 1, goal, out_of_way);
      add(Kind::Silent, 1, goal, 100 + beside_last);
      add(Kind::SilentRival, 1, goal, on_rival);
      double near = 9;
      for (const PlacedMention& m : placed_)
        if (m.position == off_route) near = std::min(near, map_.distance(m.landmark, nodes_[i]) / unit_);
      add(Kind::Unnamed, 1, goal, bin(near, {0.05, 0.1, 0.2, 0.3, 0.5, 0.8, 8}));
    }
    add(Kind::SilentCount, 1, std::min<std::size_t>(silent, 5), placed_.size() > 5 ? 5 : placed_.size());
    add(Kind::SilentCount, static_cast<double>(silent), 99);
  }

  void rank_and_length() {
    const bool all = std::count(named_.begin() + 1, named_.end(), 0) == 0;
    add(Kind::Rank, route_.rank / 10.0, 0);
    add(Kind::Rank, 1, 1, bin(route_.rank, {1, 2, 3, 5, 8, 12, 18}));
    add(Kind::RankAll, route_.rank / 10.0, all);
    const double ratio = route_.shortest > 0 ? route_.length / route_.shortest : 1;
    add(Kind::Detour, 1, bin(ratio, {1.000001, 1.01, 1.03, 1.1, 1.2, 1.5, 2, 3}), all);
    add(Kind::Legs, 1, std::min<std::size_t>(nodes_.size(), 9));
    add(Kind::Legs, 1,
        20 + bin(static_cast<double>(nodes_.size()) - 1 - static_cast<double>(placed_.size()),
                 {-3, -2, -1, 0, 1, 2, 3}));
  }

  // 2: what is named, one after the other, is the route; 1: in another order, or with something silent; 0: neither.
  unsigned agreement() const {
    StreetRoute said{nodes_[0]};
    for (const PlacedMention& m : placed_)
      if (m.landmark != said.back()) said.push_back(m.landmark);
    if (said == nodes_) return 2;
    std::sort(said.begin(), said.end());
    said.erase(std::unique(said.begin(), said.end()), said.end());
    StreetRoute route = nodes_;
    std::sort(route.begin(), route.end());
    return said == route ? 1 : 0;
  }

  void coverage() {
    std::set<LandmarkIndex> on, off;
    double complete = 0;
    for (const PlacedMention& m : placed_) {
      (m.position == off_route ? off : on).insert(m.landmark);
      if (m.position != off_route) complete += m.complete;
    }
    add(Kind::Exact, 1, agreement(), off.empty());
    add(Kind::Coverage, static_cast<double>(on.size()), 0);
    add(Kind::Coverage, static_cast<double>(off.size()), 1);
    add(Kind::Coverage, 1, 2, std::min<std::size_t>(off.size(), 3));
    add(Kind::Fit, complete);
    add(Kind::Coverage, 1, 3, named_[0] > 0);
    // What is named tells the route from its rival.
    std::size_t here = 0, there = 0;
    for (const PlacedMention& m : placed_) {
      const bool rival = std::find(route_.rival.begin(), route_.rival.end(), m.landmark) != route_.rival.end();
      here += m.position != off_route && !rival ? 1U : 0U;
      there += m.position == off_route && rival ? 1U : 0U;
    }
    add(Kind::Rival, 1, 0, std::min<std::size_t>(here, 3));
    add(Kind::Rival, 1, 1, std::min<std::size_t>(there, 3));
  }

  const StreetMap& map_;
  double unit_;
  const std::vector<std::string>& tokens_;
  const std::vector<Mention>& mentions_;
  const std::vector<MentionCue>& cues_;
  const CandidateRoute& route_;
  const StreetRoute& nodes_;
  std::vector<PlacedMention> placed_;
  std::vector<std::size_t> named_;  // how often each landmark of the route is
  FeatureList& out_;
};

}  // namespace

RouteFeatures street_features(const StreetMap& map, double unit, const std::vector<std::string>& tokens,
                              const std::vector<Mention>& mentions, const std::vector<MentionCue>& cues,
                              const CandidateRoute& route) {
  const TextOnRoute text{map, unit, tokens, mentions, cues, route, place(mentions, route.landmarks)};
  FeatureList out;
  Writer(out, text).write();
  add_sight(out, text);
  add_walk(out, text);
  return out.take();
}

}  // namespace waymark::streets

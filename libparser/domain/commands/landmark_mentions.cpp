#include "libparser/domain/commands/landmark_mentions.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <string_view>

#include "libparser/corpus/token.hpp"
#include "libparser/domain/commands/mention_lattice.hpp"

namespace waymark::parser {
namespace {

constexpr std::size_t covers = 24, most_readings = 4;
constexpr double least_probability = 0.02;

// Where a phrase ends with what is said of its place: general nouns, "on Central Avenue", ", a theatre building,".
std::size_t with_description(const std::vector<std::string>& tokens, std::size_t end) {
  constexpr std::array<std::string_view, 12> streets{"street", "avenue", "road", "lane",  "boulevard", "drive",
                                                     "plaza",  "place",  "way",  "court", "square",    "parkway"};
  constexpr std::size_t longest_description = 6;
  const auto is = [&](std::size_t at, auto... words) { return at < tokens.size() && ((tokens[at] == words) || ...); };
  while (end < tokens.size() && is_general_noun(word_root(tokens[end]))) ++end;
  if (is(end, "on", "at", "in", "near", "along"))
    for (std::size_t at = end + 1; at < tokens.size() && at <= end + longest_description && !is(at, ",", "and", "then");
         ++at)
      if (std::find(streets.begin(), streets.end(), word_root(tokens[at])) != streets.end()) return at + 1;
  if (is(end, ",") && is(end + 1, "a", "an"))
    for (std::size_t at = end + 2; at <= tokens.size() && at <= end + 2 + longest_description; ++at) {
      if (at == tokens.size() || is(at, ",", ".")) return at;
      if (is(at, "then", "and", "or", "go", "visit")) break;
    }
  return end;
}

// Where a clause begins with words that only say that it holds: "there is", "it's", "the presence of".
std::size_t with_opening(const std::vector<std::string>& tokens, std::size_t begin, std::size_t least) {
  const auto is = [&](std::size_t at, auto... words) { return ((tokens[at] == words) || ...); };
  std::size_t at = begin;
  if (at > least && is(at - 1, "a", "an", "the", "one")) --at;
  const std::size_t article = at;
  while (at > least && at + 4 > article &&
         is(at - 1, "is", "s", "are", "be", "been", "was", "will", "has", "gets", "shall", "should", "must", "being"))
    --at;
  if (at > least && at < article && is(at - 1, "there", "it")) return at - 1;
  if (at > least + 1 && at == article && is(at - 1, "of") && is(at - 2, "presence", "existence", "event", "case"))
    return at - 2;
  return begin;
}

// The things that are named in order of first mention, and which of them an odd number of mentions negate.
std::vector<bool> polarity(const LandmarkLift& lift, const std::vector<Mention>& mentions) {
  std::vector<bool> out(lift.slots.size(), false);
  for (const Mention& mention : mentions) {
    const auto at = std::find(lift.slots.begin(), lift.slots.end(), mention.thing);
    if (at == lift.slots.end()) continue;
    const auto slot = static_cast<std::size_t>(at - lift.slots.begin());
    out[slot] = out[slot] != mention.negated;
  }
  return out;
}

struct LiftOfCover {
  LandmarkLift lift;
  std::vector<bool> negated;  // of its slots
};

LiftOfCover lifted(const std::vector<std::string>& tokens, const CityWords& city, const MentionLattice& lattice,
                   const Cover& cover) {
  std::vector<Mention> mentions;
  for (const std::size_t p : cover.phrases) {
    const MentionPhrase& phrase = lattice.phrases()[p];
    mentions.push_back({phrase.begin, phrase.end, phrase.landmark, phrase.negated});
  }
  for (std::size_t i = 0; i < mentions.size(); ++i) {
    const std::size_t end = with_description(tokens, mentions[i].end);
    if (i + 1 == mentions.size() || end <= mentions[i + 1].begin) mentions[i].end = end;
    if (city.names(mentions[i].thing).clause)
      mentions[i].begin = with_opening(tokens, mentions[i].begin, i == 0 ? 0 : mentions[i - 1].end);
    const std::size_t least = i == 0 ? 0 : mentions[i - 1].end;
    if (mentions[i].begin > least && mentions[i].end < tokens.size() && tokens[mentions[i].begin - 1] == "\"" &&
        tokens[mentions[i].end] == "\"") {  // a quoted name
      --mentions[i].begin;
      ++mentions[i].end;
    }
  }
  LiftedMentions found = parser::lift(tokens, mentions);
  LiftOfCover out;
  out.lift.text = std::move(found.text);
  out.lift.slots = std::move(found.things);
  out.negated = polarity(out.lift, mentions);
  return out;
}

}  // namespace

std::vector<std::string> landmark_tokens(const std::string& text) {
  std::string plain = without_accents(text);
  std::replace_if(
      plain.begin(), plain.end(), [](char c) { return c == '/' || c == '-' || c == '_'; }, ' ');
  std::replace(plain.begin(), plain.end(), '`', '"');
  for (std::size_t at = 0; (at = plain.find('&', at)) != std::string::npos; at += 3) plain.replace(at, 1, " & ");
  return tokenize(plain);
}

std::vector<LandmarkLift> lift_landmarks(const std::string& text, const CityWords& city, const MentionModel& model) {
  const std::vector<std::string> tokens = landmark_tokens(text);
  const MentionLattice lattice(tokens, city, *model.synonyms);
  const std::vector<Cover> best = lattice.best(model.weights, covers);
  std::vector<LiftOfCover> lifts;
  double total = 0;
  for (const Cover& cover : best) {
    LiftOfCover next = lifted(tokens, city, lattice, cover);
    next.lift.probability = std::exp(cover.score - best.front().score);
    total += next.lift.probability;
    const auto same = std::find_if(lifts.begin(), lifts.end(), [&](const LiftOfCover& other) {
      return other.lift.slots == next.lift.slots && other.negated == next.negated;
    });
    if (same == lifts.end())
      lifts.push_back(std::move(next));
    else
      same->lift.probability += next.lift.probability;
  }
  std::vector<LandmarkLift> out;
  for (LiftOfCover& next : lifts) out.push_back(std::move(next.lift));
  std::stable_sort(out.begin(), out.end(),
                   [](const LandmarkLift& a, const LandmarkLift& b) { return a.probability > b.probability; });
  for (LandmarkLift& lift : out) lift.probability /= total;
  while (out.size() > most_readings || out.back().probability < least_probability) out.pop_back();
  return out;
}

}  // namespace waymark::parser

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

LandmarkLift lifted(const std::vector<std::string>& tokens, const MentionLattice& lattice, const Cover& cover) {
  std::vector<Mention> mentions;
  for (const std::size_t p : cover.phrases) {
    const MentionPhrase& phrase = lattice.phrases()[p];
    mentions.push_back({phrase.begin, phrase.end, phrase.landmark});
  }
  for (std::size_t i = 0; i < mentions.size(); ++i) {
    const std::size_t end = with_description(tokens, mentions[i].end);
    if (i + 1 == mentions.size() || end <= mentions[i + 1].begin) mentions[i].end = end;
  }
  LiftedMentions lifted = parser::lift(tokens, mentions);
  LandmarkLift out;
  out.text = std::move(lifted.text);
  out.slots = std::move(lifted.things);
  return out;
}

}  // namespace

std::vector<std::string> landmark_tokens(const std::string& text) {
  std::string plain = without_accents(text);
  std::replace_if(
      plain.begin(), plain.end(), [](char c) { return c == '/' || c == '-'; }, ' ');
  for (std::size_t at = 0; (at = plain.find('&', at)) != std::string::npos; at += 3) plain.replace(at, 1, " & ");
  return tokenize(plain);
}

std::vector<LandmarkLift> lift_landmarks(const std::string& text, const CityWords& city, const MentionModel& model) {
  const std::vector<std::string> tokens = landmark_tokens(text);
  const MentionLattice lattice(tokens, city, *model.synonyms);
  const std::vector<Cover> best = lattice.best(model.weights, covers);
  std::vector<LandmarkLift> out;
  double total = 0;
  for (const Cover& cover : best) {
    LandmarkLift lift = lifted(tokens, lattice, cover);
    lift.probability = std::exp(cover.score - best.front().score);
    total += lift.probability;
    const auto same =
        std::find_if(out.begin(), out.end(), [&](const LandmarkLift& other) { return other.slots == lift.slots; });
    if (same == out.end())
      out.push_back(std::move(lift));
    else
      same->probability += lift.probability;
  }
  std::stable_sort(out.begin(), out.end(),
                   [](const LandmarkLift& a, const LandmarkLift& b) { return a.probability > b.probability; });
  for (LandmarkLift& lift : out) lift.probability /= total;
  while (out.size() > most_readings || out.back().probability < least_probability) out.pop_back();
  return out;
}

}  // namespace waymark::parser

#include "libparser/domain/commands/mention_lattice.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "libltl/structure/random.hpp"
#include "libparser/corpus/token.hpp"

namespace waymark::parser {
namespace {

const CityWords& old_mill() {
  static const CityWords words({{"bar", "Otter Bar", {}, {{"amenity", "pub"}, {"addr:street", "Mill Street"}}},
                                {"stop", "Mill St & Oak St", {}, {{"highway", "bus_stop"}}},
                                {"library", "Oak Library", {}, {{"amenity", "library"}}},
                                {"cafe", "Otter Café", {}, {{"amenity", "cafe"}, {"cuisine", "thai"}}},
                                {"full", "the mill pond is full", {}, {}}});
  return words;
}

MentionVector random_weights(ltl::Random& random) {
  MentionVector w = mention_weights_by_hand();
  for (double& weight : w) weight = 0.3 * weight + 2 * random.unit() - 1;
  return w;
}

// Whether nothing but words that tie stands between two phrases of a text, by the definition in the header.
bool is_beside(const std::vector<std::string>& tokens, std::size_t end, std::size_t begin) {
  const std::set<std::string> ties{"operated", "by",   "on",      "at",   "in",    "of",   "with", "located",
                                   "the",      "near", "serving", "west", "north", "east", "south"};
  std::size_t at = begin;
  while (at > 0 && ties.contains(word_root(tokens[at - 1]))) --at;
  if (at > 1 && (tokens[at - 1] == "a" || tokens[at - 1] == "an") && tokens[at - 2] == ",") at -= 2;
  return at == end;
}

// All covers, one by one.
struct Enumerated {
  const std::vector<std::string>& tokens;
  const MentionLattice& lattice;
  const MentionVector& weights;
  std::vector<Cover> covers;

  void extend(const Cover& cover, std::size_t from) {
    covers.push_back(cover);
    for (std::size_t p = 0; p < lattice.phrases().size(); ++p) {
      const MentionPhrase& phrase = lattice.phrases()[p];
      if (phrase.begin < from) continue;
      Cover longer = cover;
      for (std::size_t i = 0; i < mention_features; ++i) longer.score += weights[i] * phrase.features[i];
      if (!cover.phrases.empty() && !phrase.clause && is_beside(tokens, from, phrase.begin))
        longer.score += at(weights, MentionFeature::Adjacent);
      longer.phrases.push_back(p);
      extend(longer, phrase.end);
    }
  }
};

const char* const texts[] = {"go to the otter bar on mill street",
                             "the library , then the thai cafe at oak street",
                             "avoid oak library",
                             "otter bar mill street",
                             "walk on",
                             "otter cafe , a cafe near the bar",
                             "otter bar the mill pond is not full"};

TEST(MentionLattice, SumsAndBestCoversAreThoseOfEnumeration) {
  ltl::Random random(7);
  for (const char* text : texts) {
    const auto tokens = tokenize(text);
    const MentionLattice lattice(tokens, old_mill(), Synonyms());
    const MentionVector weights = random_weights(random);
    Enumerated all{tokens, lattice, weights, {}};
    all.extend({}, 0);
    double sum = 0;
    for (const Cover& cover : all.covers) sum += std::exp(cover.score);
    MentionVector expected{};
    EXPECT_NEAR(lattice.log_sum(weights, expected), std::log(sum), 1e-9) << text;

    std::stable_sort(all.covers.begin(), all.covers.end(),
                     [](const Cover& a, const Cover& b) { return a.score > b.score; });
    const auto best = lattice.best(weights, 5);
    ASSERT_EQ(best.size(), std::min<std::size_t>(5, all.covers.size())) << text;
    for (std::size_t i = 0; i < best.size(); ++i) {
      EXPECT_NEAR(best[i].score, all.covers[i].score, 1e-9) << text;
      const MentionVector features = lattice.features(best[i].phrases);
      double score = 0;
      for (std::size_t f = 0; f < mention_features; ++f) score += weights[f] * features[f];
      EXPECT_NEAR(score, best[i].score, 1e-9) << text;
    }
  }
}

TEST(MentionLattice, SumsOfWhatIsWantedAreThoseOfEnumeration) {
  ltl::Random random(8);
  for (const char* text : texts) {
    const auto tokens = tokenize(text);
    const MentionLattice lattice(tokens, old_mill(), Synonyms());
    const MentionVector weights = random_weights(random);
    Enumerated all{tokens, lattice, weights, {}};
    all.extend({}, 0);
    for (const std::vector<std::size_t>& wanted : {std::vector<std::size_t>{0}, {2, 3}, {0, 1}, {}}) {
      double sum = 0;
      for (const Cover& cover : all.covers) {
        std::set<std::size_t> named;
        for (const std::size_t p : cover.phrases) named.insert(lattice.phrases()[p].landmark);
        if (named == std::set<std::size_t>(wanted.begin(), wanted.end())) sum += std::exp(cover.score);
      }
      MentionVector expected{};
      const double found = lattice.log_sum(weights, expected, &wanted);
      if (sum == 0)
        EXPECT_EQ(found, -INFINITY) << text;
      else
        EXPECT_NEAR(found, std::log(sum), 1e-9) << text;
    }
  }
}

TEST(MentionLattice, ExpectedFeaturesAreTheDerivatives) {
  ltl::Random random(9);
  const std::vector<std::size_t> wanted{2, 3};
  const MentionLattice lattice(tokenize(texts[1]), old_mill(), Synonyms());
  for (const auto* only : {static_cast<const std::vector<std::size_t>*>(nullptr), &wanted}) {
    MentionVector weights = random_weights(random), expected{}, unused{};
    lattice.log_sum(weights, expected, only);
    for (std::size_t i = 0; i < mention_features; ++i) {
      const double h = 1e-5, w = weights[i];
      weights[i] = w + h;
      const double above = lattice.log_sum(weights, unused, only);
      weights[i] = w - h;
      const double below = lattice.log_sum(weights, unused, only);
      weights[i] = w;
      EXPECT_NEAR(expected[i], (above - below) / (2 * h), 1e-6) << "feature " << i;
    }
  }
}

TEST(MentionLattice, AWordStandsForASynonymThatTheCityKnows) {
  const Synonyms synonyms({"coffee bar, cafe", "depository library, library"});
  const auto named = [&](const char* text) {
    std::set<std::size_t> landmarks;
    const MentionLattice lattice(tokenize(text), old_mill(), synonyms);
    for (const MentionPhrase& phrase : lattice.phrases())
      if (at(phrase.features, MentionFeature::Synonym) > 0) landmarks.insert(phrase.landmark);
    return landmarks;
  };
  EXPECT_EQ(named("go to the coffee bar"), (std::set<std::size_t>{3}));
  EXPECT_EQ(named("go to the cafe"), (std::set<std::size_t>{}));
}

}  // namespace
}  // namespace waymark::parser

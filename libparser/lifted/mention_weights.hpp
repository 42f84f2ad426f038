// What counts for and against a phrase of a text as the mention of a landmark, the weights of a log-linear model, and
// the synonyms of nouns.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>

#include "libparser/lexicon/synonyms.hpp"

namespace waymark::parser {

enum class MentionFeature : std::uint8_t {
  Mention,         // each phrase
  NameWord,        // words of names of the landmark
  NameRarity,      // the same, each by its rarity among the landmarks of the city
  TagWord,         // words of tags that are in no name of it
  TagRarity,       // the same, each by its rarity
  LoneTag,         // a single word of a name that is a tag too: "the library"
  CommandWord,     // words of names or tags that commands often have
  Misspelled,      // words of names with a letter wrong
  Synonym,         // words that stand for a synonym of theirs
  Joint,           // "on", "operated"
  GeneralNoun,     // "building"
  Comma,           // commas inside
  Foreign,         // words inside that are nothing of these
  OwnName,         // a whole name of its own, in order
  SharedName,      // the whole name of its brand or operator, in order
  NameLength,      // words of that name
  UnorderedName,   // all words of a name, in another order
  NameCoverage,    // share of the words of a name that are said, of the name for which it is largest
  Adjacent,        // nothing but "on", "at" and the like lies between this phrase and the one before
  NamePrefix,      // more words than one, the first ones of a name: "Blue Heron" for "Blue Heron Books and Tea"
  EndsWithTag,     // the last word is a tag: "the Thai restaurant"
  FollowsArticle,  // "the" or "a" stands before
  FollowsLink,     // "to", "visit" and the like stands before, or the text begins
  PrecedesLink,    // "and", "then" and the like, a mark, or the end of the text follows
};
inline constexpr std::size_t mention_features = static_cast<std::size_t>(MentionFeature::PrecedesLink) + 1;  // how many

using MentionVector = std::array<double, mention_features>;  // a number for each feature
// By feature.
inline double& at(MentionVector& v, MentionFeature f) { return v[static_cast<std::size_t>(f)]; }
inline double at(const MentionVector& v, MentionFeature f) { return v[static_cast<std::size_t>(f)]; }

// The weights before anything is learned. They were set by hand on every second open command that describes landmarks.
constexpr MentionVector mention_weights_by_hand() {
  MentionVector w{};
  w[static_cast<std::size_t>(MentionFeature::Mention)] = -2.2;
  w[static_cast<std::size_t>(MentionFeature::NameWord)] = 1.4;
  w[static_cast<std::size_t>(MentionFeature::NameRarity)] = 2.6;
  w[static_cast<std::size_t>(MentionFeature::TagWord)] = 1.05;
  w[static_cast<std::size_t>(MentionFeature::TagRarity)] = 1.95;
  w[static_cast<std::size_t>(MentionFeature::LoneTag)] = 0.4;
  w[static_cast<std::size_t>(MentionFeature::CommandWord)] = 0.3;
  w[static_cast<std::size_t>(MentionFeature::Misspelled)] = -0.7;
  w[static_cast<std::size_t>(MentionFeature::Synonym)] = -0.5;
  w[static_cast<std::size_t>(MentionFeature::Joint)] = -0.08;
  w[static_cast<std::size_t>(MentionFeature::GeneralNoun)] = -0.08;
  w[static_cast<std::size_t>(MentionFeature::Comma)] = -1.2;
  w[static_cast<std::size_t>(MentionFeature::Foreign)] = -3.6;
  w[static_cast<std::size_t>(MentionFeature::OwnName)] = 3.6;
  w[static_cast<std::size_t>(MentionFeature::SharedName)] = 2.4;
  w[static_cast<std::size_t>(MentionFeature::NameLength)] = 1;
  w[static_cast<std::size_t>(MentionFeature::UnorderedName)] = 3.6;
  w[static_cast<std::size_t>(MentionFeature::Adjacent)] = -10;
  return w;
}

struct MentionModel {                                                             // what finds mentions
  MentionVector weights = mention_weights_by_hand();                              // of the features
  std::shared_ptr<const Synonyms> synonyms = std::make_shared<const Synonyms>();  // never null
};

}  // namespace waymark::parser

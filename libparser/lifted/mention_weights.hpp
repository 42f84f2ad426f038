// What counts for and against a phrase of a text as the mention of a landmark, the weights of a log-linear model, and
// the synonyms of nouns.
#pragma once
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>

#include "libparser/lexicon/synonyms.hpp"

namespace waymark::parser {

enum class MentionFeature : std::uint8_t {  // what is counted of a phrase
  Mention,                                  // each phrase
  NameWord,                                 // words of names of the landmark
  NameRarity,                               // the same, each by its rarity among the landmarks of the city
  TagWord,                                  // words of tags that are in no name of it
  TagRarity,                                // the same, each by its rarity
  LoneTag,                                  // a single word of a name that is a tag too: "the library"
  CommandWord,                              // words of names or tags that commands often have
  Misspelled,                               // words of names with a letter wrong
  Synonym,                                  // words that stand for a synonym of theirs
  Joint,                                    // "on", "operated"
  GeneralNoun,                              // "building"
  Comma,                                    // commas inside
  Foreign,                                  // words inside that are nothing of these
  OwnName,                                  // a whole name of its own, in order
  SharedName,                               // the whole name of its brand or operator, in order
  NameLength,                               // words of that name
  UnorderedName,                            // all words of a name, in another order
  NameCoverage,    // share of the words of a name that are said, of the name for which it is largest
  Adjacent,        // nothing but "on", "at" and the like lies between this phrase and the one before
  NamePrefix,      // more words than one, the first ones of a name: "Blue Heron" for "Blue Heron Books and Tea"
  EndsWithTag,     // the last word is a tag: "the Thai restaurant"
  FollowsArticle,  // "the" or "a" stands before
  FollowsLink,     // "to", "visit" and the like stands before, or the text begins
  PrecedesLink,    // "and", "then" and the like, a mark, or the end of the text follows
  // The rest counts for names that describe: "the bookstore", "the door is open".
  Described,    // each phrase for such a name
  Clause,       // each phrase for a name that is a clause
  Form,         // words in another form: "running" for "runs"
  State,        // words that say the same of a thing: "shut" for "closed"
  Opposite,     // words that say the opposite
  Short,        // abbreviations
  Particle,     // "on" of "the heater is on"
  Light,        // "be", "gets", "must" inside
  Negation,     // "not" and the like inside
  FirstWord,    // the first word of the name is said
  LastWord,     // the last word of the name is said
  LoneWord,     // one word of several is said
  LoneOther,    // the only word that is said is in another form, or says the same or the opposite
  MissingWord,  // words of the name that are not said, of that for which they are fewest
  LoneSubject,  // one word of several is said, the first of a clause
  LoneGeneral,  // the only word that is said is a general noun, or names nothing by itself
  Again,        // the first word of the name stands before the phrase, too
  LoneAgain,    // the same, and one word of several is said
  StateAgain,   // the same, and that word is no subject but in another form, or says the same or the opposite
  StateOfName,  // the first word of the name is said, and one that says the same or the opposite
  Repeated,     // words of the name that are said twice
  AfterLight,   // a light verb stands before
  BeforeLight,  // a light verb follows
};
// What counts for any name. Names that describe have weights of their own for it, behind the features above.
inline constexpr std::size_t common_mention_features = static_cast<std::size_t>(MentionFeature::PrecedesLink) + 1;
inline constexpr std::size_t first_of_descriptions = static_cast<std::size_t>(MentionFeature::BeforeLight) + 1;
inline constexpr std::size_t mention_features = first_of_descriptions + common_mention_features;  // how many

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
  w[static_cast<std::size_t>(MentionFeature::Form)] = -0.5;
  w[static_cast<std::size_t>(MentionFeature::State)] = -1.2;
  w[static_cast<std::size_t>(MentionFeature::Opposite)] = -1.2;
  w[static_cast<std::size_t>(MentionFeature::Short)] = -0.7;
  w[static_cast<std::size_t>(MentionFeature::Particle)] = 0.5;
  w[static_cast<std::size_t>(MentionFeature::Light)] = -0.1;
  w[static_cast<std::size_t>(MentionFeature::Negation)] = -0.3;
  w[static_cast<std::size_t>(MentionFeature::LoneOther)] = -1.5;
  for (std::size_t f = 0; f < common_mention_features; ++f) w[first_of_descriptions + f] = w[f];
  return w;
}

// Weights of a file that knows fewer features: the others count for nothing. Where it knows only what counts for any
// name, that counts for descriptions, too.
inline MentionVector completed_mention_weights(std::span<const float> known) {
  MentionVector w{};
  std::copy(known.begin(), known.end(), w.begin());
  if (known.size() <= common_mention_features)
    std::copy(known.begin(), known.end(), w.begin() + static_cast<std::ptrdiff_t>(first_of_descriptions));
  return w;
}

struct MentionModel {                                                             // what finds mentions
  MentionVector weights = mention_weights_by_hand();                              // of the features
  std::shared_ptr<const Synonyms> synonyms = std::make_shared<const Synonyms>();  // never null
};

}  // namespace waymark::parser

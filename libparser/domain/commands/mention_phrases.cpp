#include "libparser/domain/commands/mention_phrases.hpp"

#include <algorithm>
#include <array>
#include <string_view>

#include "libparser/corpus/token.hpp"
#include "libparser/domain/commands/word_forms.hpp"

namespace waymark::parser {
namespace {

using Words = std::vector<std::string>;

// A text beside the words of a city: what each word may stand for.
class Text {
 public:
  Text(const Words& tokens, const CityWords& city, const Synonyms& synonyms) : city_(city), tokens_(tokens) {
    for (const std::string& token : tokens) words_.push_back(word_root(token));
    meanings_.resize(words_.size());
    for (std::size_t i = 0; i < words_.size(); ++i) add_meanings(i, synonyms);
    for (std::size_t i = 0; i + 1 < words_.size(); ++i)  // "tai pan" where a name has "taipan"
      if (city.knows(words_[i] + words_[i + 1])) {
        words_[i] += words_[i + 1];
        words_[i + 1] = words_[i];
      }
  }

  const Words& tokens() const { return tokens_; }
  const Words& words() const { return words_; }  // their roots
  const std::vector<WordMeaning>& meanings(std::size_t i) const { return meanings_[i]; }
  // ", a theatre building": what follows a comma with an article says more of the same place.
  bool separates(std::size_t i) const {
    if (words_[i] == ";") return true;
    if (words_[i] != ",") return false;
    return i + 1 >= words_.size() ||
           (words_[i + 1] != "a" && words_[i + 1] != "an" && words_[i + 1] != "the" && words_[i + 1] != "located");
  }
  const CityWords& city() const { return city_; }

 private:
  void add_meanings(std::size_t i, const Synonyms& synonyms) {
    meanings_[i] = city_.meanings(words_[i]);
    if (city_.knows(words_[i]) || is_joint(words_[i]) || is_word_of_commands(words_[i])) return;
    for (const std::size_t length : {std::size_t{2}, std::size_t{1}}) {
      if (i + length > words_.size()) continue;
      for (const std::string& other : synonyms.of(length == 2 ? words_[i] + ' ' + words_[i + 1] : words_[i]))
        add_synonym(i, length, tokenize(other));
    }
    if (const auto meant = city_.meant(words_[i])) meanings_[i].push_back({*meant, WordMatch::Misspelled});
  }

  // "petrol station" stands for "gas station" word by word, "coffee bar" for "cafe" with both words.
  void add_synonym(std::size_t i, std::size_t length, const Words& other) {
    if (other.size() != length && other.size() != 1) return;
    for (std::size_t k = 0; k < length; ++k) {
      const std::string root = word_root(other[other.size() == 1 ? 0 : k]);
      if (root != words_[i + k] && city_.knows(root)) meanings_[i + k].push_back({root, WordMatch::Synonym});
    }
  }

  const CityWords& city_;
  const Words& tokens_;
  Words words_;
  std::vector<std::vector<WordMeaning>> meanings_;
};

bool is_article(const std::string& word) { return word == "the" || word == "a" || word == "an"; }

// A word that no name of a place goes on with, or a mark.
bool is_link(const std::string& word) {
  constexpr std::array<std::string_view, 20> links{
      "past", "through", "while", "without", "toward",  "towards",  "into", "via",   "along",  "across",
      "over", "enter",   "leave", "but",     "passing", "avoiding", "when", "until", "unless", "continue"};
  return is_joint(word) || is_word_of_commands(word) || word.find_first_of(",.;:!?'\"()") == 0 ||
         std::find(links.begin(), links.end(), word) != links.end();
}

// The phrases for one landmark.
class PhrasesFor {
 public:
  PhrasesFor(const Text& text, std::size_t landmark)
      : text_(text), landmark_(landmark), names_(text.city().names(landmark)) {
    for (std::size_t i = 0; i < text.words().size(); ++i) {
      const WordMeaning said = meaning(i);
      const bool counts = !is_joint(said.word) || names_.particles.contains(said.word);
      words_.push_back(said.word);
      matches_.push_back(said.match);
      in_name_.push_back(counts && names_.name_words.contains(said.word));
      in_tags_.push_back(counts && names_.tag_words.contains(said.word));
      rarity_.push_back(has(i) ? text.city().rarity(said.word) : 0);
    }
    for (std::size_t i = 0; i < names_.sequences.size(); ++i) find(names_.sequences[i], i < names_.own);
  }

  void add_to(std::vector<MentionPhrase>& out) const {
    const std::size_t n = words_.size();
    for (std::size_t begin = 0; begin < n; ++begin) {
      if (!has(begin)) continue;
      std::size_t foreign = 0, said = 0;
      for (std::size_t end = begin + 1; end <= n && end - begin <= longest_phrase; ++end) {
        if (text_.separates(end - 1)) break;
        if (is_foreign(end - 1) && ++foreign > most_foreign) break;
        if (!has(end - 1) && !is_end_negated(begin, end)) continue;
        if (has(end - 1) && !is_joint(words_[end - 1])) ++said;
        if (said > 0)
          out.push_back({begin, end, landmark_, is_negated(begin, end), names_.clause, features(begin, end)});
      }
    }
  }

 private:
  struct Occurrence {
    std::size_t begin, end;
    bool own;
  };

  // What a word of the text stands for in the names of this landmark: itself, where it is no word of them.
  WordMeaning meaning(std::size_t i) const {
    const std::string& word = text_.words()[i];
    const auto is_told = [&](const std::string& other) {
      return names_.name_words.contains(other) || names_.tag_words.contains(other);
    };
    if (is_told(word)) return {word, WordMatch::Same};
    for (const WordMeaning& other : text_.meanings(i))
      if (is_told(other.word)) return other;
    return {text_.tokens()[i] == "s" ? "s" : word, WordMatch::Same};  // "it's", no "south"
  }

  void find(const Words& name, bool own) {
    if (name.empty()) return;
    for (auto it = words_.begin(); (it = std::search(it, words_.end(), name.begin(), name.end())) != words_.end();
         ++it) {
      const auto begin = static_cast<std::size_t>(it - words_.begin());
      occurrences_.push_back({begin, begin + name.size(), own});
    }
  }

  bool has(std::size_t i) const { return in_name_[i] || in_tags_[i]; }
  bool is_light(std::size_t i) const { return names_.described && is_light_word(text_.tokens()[i]); }
  bool is_negator(std::size_t i) const { return names_.described && negates(text_.tokens()[i]); }
  bool is_foreign(std::size_t i) const {
    const std::string& word = words_[i];
    return !has(i) && word != "," && !is_joint(word) && !is_general_noun(word) && !is_light(i) && !is_negator(i);
  }
  bool is_end_negated(std::size_t begin, std::size_t end) const {  // "the robot carries nothing"
    return names_.clause && end > begin + 1 && has(end - 2) && is_negator(end - 1);
  }
  bool is_negated(std::size_t begin, std::size_t end) const {
    bool negated = false;
    for (std::size_t i = begin; i < end; ++i) negated ^= has(i) ? matches_[i] == WordMatch::Opposite : is_negator(i);
    return negated;
  }

  MentionVector features(std::size_t begin, std::size_t end) const {
    using F = MentionFeature;
    const Words& around = text_.words();
    MentionVector v{};
    at(v, F::Mention) = 1;
    at(v, F::FollowsArticle) = begin > 0 && is_article(around[begin - 1]) ? 1 : 0;
    at(v, F::FollowsLink) = begin == 0 || is_link(around[begin - 1]) ? 1 : 0;
    at(v, F::PrecedesLink) = end == around.size() || is_link(around[end]) ? 1 : 0;
    at(v, F::EndsWithTag) = in_tags_[end - 1] ? 1 : 0;
    for (std::size_t i = begin; i < end; ++i) {
      if (has(i) && is_repeated(begin, i)) {
        if (names_.described && !is_joint(words_[i])) ++at(v, F::Repeated);
        continue;
      }
      add_word(v, i);
    }
    if (end - begin == 1 && in_name_[begin] && in_tags_[begin]) at(v, F::LoneTag) = 1;
    add_names(v, begin, end);
    if (names_.described) add_description(v, begin, end);
    if (!names_.described && !names_.untagged) return v;
    for (std::size_t f = 0; f < common_mention_features; ++f) std::swap(v[f], v[first_of_descriptions + f]);
    return v;
  }
  bool is_repeated(std::size_t begin, std::size_t i) const { return is_said(words_[i], begin, i); }
  bool is_said(const std::string& word, std::size_t begin, std::size_t end) const {
    const auto first = words_.begin() + static_cast<std::ptrdiff_t>(begin);
    const auto last = words_.begin() + static_cast<std::ptrdiff_t>(end);
    return std::find(first, last, word) != last;
  }

  void add_word(MentionVector& v, std::size_t i) const {
    using F = MentionFeature;
    const std::string& word = words_[i];
    if (has(i)) {
      add_match(v, matches_[i]);
      if (is_joint(word)) {
        ++at(v, F::Particle);
      } else if (is_word_of_commands(word)) {
        ++at(v, F::CommandWord);
      } else {
        ++at(v, in_name_[i] ? F::NameWord : F::TagWord);
        at(v, in_name_[i] ? F::NameRarity : F::TagRarity) += rarity_[i];
      }
    } else if (is_negator(i)) {
      ++at(v, F::Negation);
    } else if (word == ",") {
      ++at(v, F::Comma);
    } else if (is_joint(word)) {
      ++at(v, F::Joint);
    } else if (is_light(i)) {
      ++at(v, F::Light);
    } else {
      ++at(v, is_general_noun(word) ? F::GeneralNoun : F::Foreign);
    }
  }
  static void add_match(MentionVector& v, WordMatch match) {
    using F = MentionFeature;
    switch (match) {
      case WordMatch::Same: return;
      case WordMatch::Form: ++at(v, F::Form); return;
      case WordMatch::State: ++at(v, F::State); return;
      case WordMatch::Opposite: ++at(v, F::Opposite); return;
      case WordMatch::Synonym: ++at(v, F::Synonym); return;
      case WordMatch::Short: ++at(v, F::Short); return;
      case WordMatch::Misspelled: ++at(v, F::Misspelled); return;
    }
  }

  void add_names(MentionVector& v, std::size_t begin, std::size_t end) const {
    using F = MentionFeature;
    for (const Occurrence& o : occurrences_) {
      if (o.begin < begin || o.end > end) continue;
      if (o.own) at(v, F::OwnName) = 1;
      if (!o.own && at(v, F::OwnName) == 0) at(v, F::SharedName) = 1;
      at(v, F::NameLength) = std::max(at(v, F::NameLength), static_cast<double>(o.end - o.begin));
    }
    for (const Words& name : names_.sequences)
      if (end - begin > 1 && end - begin < name.size() &&
          std::equal(name.begin(), name.begin() + static_cast<std::ptrdiff_t>(end - begin),
                     words_.begin() + static_cast<std::ptrdiff_t>(begin)))
        at(v, F::NamePrefix) = 1;
    for (const auto& name : names_.words) {
      const auto said = static_cast<double>(
          std::count_if(name.begin(), name.end(), [&](const std::string& word) { return is_said(word, begin, end); }));
      at(v, F::NameCoverage) = std::max(at(v, F::NameCoverage), said / static_cast<double>(name.size()));
    }
    if (at(v, F::NameCoverage) == 1 && at(v, F::NameLength) == 0) at(v, F::UnorderedName) = 1;
  }

  void add_description(MentionVector& v, std::size_t begin, std::size_t end) const {
    using F = MentionFeature;
    const Words& around = text_.tokens();
    at(v, F::Described) = 1;
    at(v, F::Clause) = names_.clause ? 1 : 0;
    at(v, F::FirstWord) = is_said(names_.first, begin, end) ? 1 : 0;
    at(v, F::LastWord) = is_said(names_.last, begin, end) ? 1 : 0;
    at(v, F::AfterLight) = begin > 0 && is_light_word(around[begin - 1]) ? 1 : 0;
    at(v, F::BeforeLight) = end < around.size() && is_light_word(around[end]) ? 1 : 0;
    std::size_t missing = longest_phrase, words = 0;
    for (const auto& name : names_.words) {
      const auto unsaid = static_cast<std::size_t>(
          std::count_if(name.begin(), name.end(), [&](const std::string& word) { return !is_said(word, begin, end); }));
      if (unsaid < missing) words = name.size();
      missing = std::min(missing, unsaid);
    }
    at(v, F::MissingWord) = static_cast<double>(missing);
    const bool again = is_said(names_.first, 0, begin), other = at(v, F::State) + at(v, F::Opposite) > 0;
    at(v, F::Again) = again ? 1 : 0;
    at(v, F::StateOfName) = at(v, F::FirstWord) > 0 && other ? 1 : 0;
    if (missing + 1 != words) return;
    const bool differs = other || at(v, F::Form) + at(v, F::Short) > 0;
    at(v, F::LoneWord) = missing > 0 ? 1 : 0;
    at(v, F::LoneOther) = differs ? 1 : 0;
    at(v, F::LoneSubject) = missing > 0 && names_.clause && at(v, F::FirstWord) > 0 ? 1 : 0;
    at(v, F::LoneGeneral) =
        std::any_of(around.begin() + static_cast<std::ptrdiff_t>(begin),
                    around.begin() + static_cast<std::ptrdiff_t>(end),
                    [](const std::string& word) { return is_general_noun(word_root(word)) || is_function_word(word); })
            ? 1
            : 0;
    at(v, F::LoneAgain) = again && missing > 0 ? 1 : 0;
    at(v, F::StateAgain) = again && missing > 0 && at(v, F::FirstWord) == 0 && differs ? 1 : 0;
  }

  const Text& text_;
  std::size_t landmark_;
  const CityWords::Names& names_;
  Words words_;  // of the text, as words of this landmark where they stand for such
  std::vector<WordMatch> matches_;
  std::vector<bool> in_name_, in_tags_;
  std::vector<double> rarity_;
  std::vector<Occurrence> occurrences_;
};

}  // namespace

std::vector<MentionPhrase> mention_phrases(const std::vector<std::string>& tokens, const CityWords& city,
                                           const Synonyms& synonyms) {
  const Text text(tokens, city, synonyms);
  std::set<std::size_t> landmarks;
  const auto add = [&](const std::string& word) {
    if (!is_joint(word)) landmarks.insert(city.holders(word).begin(), city.holders(word).end());
  };
  for (std::size_t i = 0; i < text.words().size(); ++i) {
    add(text.words()[i]);
    for (const WordMeaning& meaning : text.meanings(i)) add(meaning.word);
  }
  std::vector<MentionPhrase> out;
  for (const std::size_t landmark : landmarks) PhrasesFor(text, landmark).add_to(out);
  std::stable_sort(out.begin(), out.end(),
                   [](const MentionPhrase& a, const MentionPhrase& b) { return a.end < b.end; });
  return out;
}

}  // namespace waymark::parser

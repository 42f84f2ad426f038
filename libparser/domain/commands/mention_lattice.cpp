#include "libparser/domain/commands/mention_lattice.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <string_view>

namespace waymark::parser {
namespace {

using Words = std::vector<std::string>;

// A text beside the words of a city: what each word is, for each landmark.
class Text {
 public:
  Text(const Words& tokens, const CityWords& city, const Synonyms& synonyms) : city_(city) {
    for (const std::string& token : tokens) words_.push_back(word_root(token));
    misspelled_.assign(words_.size(), false);
    synonym_.assign(words_.size(), false);
    for (std::size_t i = 0; i < words_.size(); ++i)
      if (!city.knows(words_[i])) mend(i, synonyms);
    for (std::size_t i = 0; i + 1 < words_.size(); ++i)  // "tai pan" where a name has "taipan"
      if (city.knows(words_[i] + words_[i + 1])) {
        words_[i] += words_[i + 1];
        words_[i + 1] = words_[i];
      }
    for (const std::string& word : words_) rarity_.push_back(city.rarity(word));
  }

  const Words& words() const { return words_; }
  bool may_end(std::size_t i) const { return !is_joint(words_[i]) && city_.knows(words_[i]); }
  // ", a theatre building": what follows a comma with an article says more of the same place.
  bool separates(std::size_t i) const {
    if (words_[i] == ";") return true;
    if (words_[i] != ",") return false;
    return i + 1 >= words_.size() ||
           (words_[i + 1] != "a" && words_[i + 1] != "an" && words_[i + 1] != "the" && words_[i + 1] != "located");
  }
  const CityWords& city() const { return city_; }
  double rarity(std::size_t i) const { return rarity_[i]; }
  bool is_misspelled(std::size_t i) const { return misspelled_[i]; }
  bool is_synonym(std::size_t i) const { return synonym_[i]; }

 private:
  // A word that the city does not know stands for one that means the same, or for one that it misspells.
  void mend(std::size_t i, const Synonyms& synonyms) {
    if (is_joint(words_[i]) || is_word_of_commands(words_[i])) return;
    for (const std::size_t length : {std::size_t{2}, std::size_t{1}}) {
      if (i + length > words_.size()) continue;
      for (const std::string& other : synonyms.of(length == 2 ? words_[i] + ' ' + words_[i + 1] : words_[i])) {
        const std::string root = word_root(other);
        if (!city_.knows(root)) continue;
        for (std::size_t k = i; k < i + length; ++k) {
          words_[k] = root;
          synonym_[k] = true;
        }
        return;
      }
    }
    if (const auto meant = city_.meant(words_[i])) {
      words_[i] = *meant;
      misspelled_[i] = true;
    }
  }

  const CityWords& city_;
  Words words_;
  std::vector<bool> misspelled_, synonym_;
  std::vector<double> rarity_;
};

// The phrases for one landmark.
class PhrasesFor {
 public:
  PhrasesFor(const Text& text, std::size_t landmark)
      : text_(text), landmark_(landmark), names_(text.city().names(landmark)) {
    for (const std::string& word : text.words()) {
      in_name_.push_back(!is_joint(word) && names_.name_words.contains(word));
      in_tags_.push_back(!is_joint(word) && names_.tag_words.contains(word));
    }
    for (std::size_t i = 0; i < names_.sequences.size(); ++i) find(names_.sequences[i], i < names_.own);
  }

  void add_to(std::vector<MentionPhrase>& out) const {
    const std::size_t n = text_.words().size();
    for (std::size_t begin = 0; begin < n; ++begin) {
      if (!has(begin)) continue;
      std::size_t foreign = 0;
      for (std::size_t end = begin + 1; end <= n && end - begin <= MentionLattice::longest_phrase; ++end) {
        if (text_.separates(end - 1)) break;
        if (is_foreign(end - 1) && ++foreign > MentionLattice::most_foreign) break;
        if (has(end - 1)) out.push_back({begin, end, landmark_, features(begin, end)});
      }
    }
  }

 private:
  struct Occurrence {
    std::size_t begin, end;
    bool own;
  };

  void find(const Words& name, bool own) {
    if (name.empty()) return;
    const Words& words = text_.words();
    for (auto it = words.begin(); (it = std::search(it, words.end(), name.begin(), name.end())) != words.end(); ++it) {
      const auto begin = static_cast<std::size_t>(it - words.begin());
      occurrences_.push_back({begin, begin + name.size(), own});
    }
  }

  bool has(std::size_t i) const { return in_name_[i] || in_tags_[i]; }
  bool is_foreign(std::size_t i) const {
    const std::string& word = text_.words()[i];
    return !has(i) && word != "," && !is_joint(word) && !is_general_noun(word);
  }

  MentionVector features(std::size_t begin, std::size_t end) const {
    using F = MentionFeature;
    MentionVector v{};
    at(v, F::Mention) = 1;
    at(v, F::FollowsArticle) = begin > 0 && is_article(text_.words()[begin - 1]) ? 1 : 0;
    at(v, F::FollowsLink) = begin == 0 || is_link(text_.words()[begin - 1]) ? 1 : 0;
    at(v, F::PrecedesLink) = end == text_.words().size() || is_link(text_.words()[end]) ? 1 : 0;
    at(v, F::EndsWithTag) = in_tags_[end - 1] ? 1 : 0;
    for (std::size_t i = begin; i < end; ++i) {
      if (has(i) && is_repeated(begin, i)) continue;
      add_word(v, i);
    }
    if (end - begin == 1 && in_name_[begin] && in_tags_[begin]) at(v, F::LoneTag) = 1;
    add_names(v, begin, end);
    return v;
  }
  static bool is_article(const std::string& word) { return word == "the" || word == "a" || word == "an"; }
  // A word that no name of a place goes on with, or a mark.
  static bool is_link(const std::string& word) {
    constexpr std::array<std::string_view, 20> links{
        "past", "through", "while", "without", "toward",  "towards",  "into", "via",   "along",  "across",
        "over", "enter",   "leave", "but",     "passing", "avoiding", "when", "until", "unless", "continue"};
    return is_joint(word) || is_word_of_commands(word) || word.find_first_of(",.;:!?'\"()") == 0 ||
           std::find(links.begin(), links.end(), word) != links.end();
  }
  bool is_repeated(std::size_t begin, std::size_t i) const {
    const Words& words = text_.words();
    return std::find(words.begin() + static_cast<std::ptrdiff_t>(begin), words.begin() + static_cast<std::ptrdiff_t>(i),
                     words[i]) != words.begin() + static_cast<std::ptrdiff_t>(i);
  }

  void add_word(MentionVector& v, std::size_t i) const {
    using F = MentionFeature;
    const std::string& word = text_.words()[i];
    if (has(i)) {
      if (text_.is_misspelled(i)) ++at(v, F::Misspelled);
      if (text_.is_synonym(i)) ++at(v, F::Synonym);
      if (is_word_of_commands(word)) {
        ++at(v, F::CommandWord);
      } else {
        ++at(v, in_name_[i] ? F::NameWord : F::TagWord);
        at(v, in_name_[i] ? F::NameRarity : F::TagRarity) += text_.rarity(i);
      }
    } else if (word == ",") {
      ++at(v, F::Comma);
    } else if (is_joint(word)) {
      ++at(v, F::Joint);
    } else {
      ++at(v, is_general_noun(word) ? F::GeneralNoun : F::Foreign);
    }
  }

  void add_names(MentionVector& v, std::size_t begin, std::size_t end) const {
    using F = MentionFeature;
    const Words& words = text_.words();
    for (const Occurrence& o : occurrences_) {
      if (o.begin < begin || o.end > end) continue;
      if (o.own) at(v, F::OwnName) = 1;
      if (!o.own && at(v, F::OwnName) == 0) at(v, F::SharedName) = 1;
      at(v, F::NameLength) = std::max(at(v, F::NameLength), static_cast<double>(o.end - o.begin));
    }
    for (const Words& name : names_.sequences)
      if (end - begin > 1 && end - begin < name.size() &&
          std::equal(name.begin(), name.begin() + static_cast<std::ptrdiff_t>(end - begin),
                     words.begin() + static_cast<std::ptrdiff_t>(begin)))
        at(v, F::NamePrefix) = 1;
    for (const auto& name : names_.words) {
      const auto said = static_cast<double>(std::count_if(name.begin(), name.end(), [&](const std::string& word) {
        return std::find(words.begin() + static_cast<std::ptrdiff_t>(begin),
                         words.begin() + static_cast<std::ptrdiff_t>(end),
                         word) != words.begin() + static_cast<std::ptrdiff_t>(end);
      }));
      at(v, F::NameCoverage) = std::max(at(v, F::NameCoverage), said / static_cast<double>(name.size()));
    }
    if (at(v, F::NameCoverage) == 1 && at(v, F::NameLength) == 0) at(v, F::UnorderedName) = 1;
  }

  const Text& text_;
  std::size_t landmark_;
  const CityWords::Names& names_;
  std::vector<bool> in_name_, in_tags_;
  std::vector<Occurrence> occurrences_;
};

// Where words end that leave a phrase beside the one before: "on", "operated by", ", a".
std::vector<std::size_t> ends_before(const Words& words) {
  constexpr std::array<std::string_view, 15> ties{"operated", "by",   "on",      "at",   "in",
                                                  "of",       "with", "located", "the",  "near",
                                                  "serving",  "west", "north",   "east", "south"};
  std::vector<std::size_t> out;
  for (std::size_t begin = 0; begin < words.size(); ++begin) {
    std::size_t at = begin;
    while (at > 0 && std::find(ties.begin(), ties.end(), words[at - 1]) != ties.end()) --at;
    if (at > 1 && (words[at - 1] == "a" || words[at - 1] == "an") && words[at - 2] == ",") at -= 2;
    out.push_back(at);
  }
  return out;
}

double dot(const MentionVector& a, const MentionVector& b) {
  double sum = 0;
  for (std::size_t i = 0; i < mention_features; ++i) sum += a[i] * b[i];
  return sum;
}

}  // namespace

MentionLattice::MentionLattice(const std::vector<std::string>& tokens, const CityWords& city, const Synonyms& synonyms)
    : tokens_(tokens.size()) {
  const Text text(tokens, city, synonyms);
  before_ = ends_before(text.words());
  std::set<std::size_t> landmarks;
  for (const std::string& word : text.words())
    if (!is_joint(word)) landmarks.insert(city.holders(word).begin(), city.holders(word).end());
  for (const std::size_t landmark : landmarks) PhrasesFor(text, landmark).add_to(phrases_);
  std::stable_sort(phrases_.begin(), phrases_.end(),
                   [](const MentionPhrase& a, const MentionPhrase& b) { return a.end < b.end; });
}

std::vector<Cover> MentionLattice::best(const MentionVector& weights, std::size_t k) const {
  struct Path {
    double score;
    std::size_t ended;     // where the last phrase ended
    std::size_t phrase;    // the last phrase
    std::size_t at, rank;  // the path before it
  };
  constexpr std::size_t none = std::numeric_limits<std::size_t>::max();
  const double adjacent = at(weights, MentionFeature::Adjacent);
  std::vector<std::vector<Path>> paths(tokens_ + 1);
  paths[0].push_back({0, none, none, 0, 0});
  std::size_t next = 0;
  for (std::size_t end = 1; end <= tokens_; ++end) {
    std::vector<Path>& here = paths[end];
    here = paths[end - 1];
    for (; next < phrases_.size() && phrases_[next].end == end; ++next) {
      const std::size_t begin = phrases_[next].begin;
      const double score = dot(weights, phrases_[next].features);
      for (std::size_t i = 0; i < paths[begin].size(); ++i) {
        const Path& path = paths[begin][i];
        here.push_back({path.score + score + (path.ended == before_[begin] ? adjacent : 0), end, next, begin, i});
      }
    }
    std::stable_sort(here.begin(), here.end(), [](const Path& a, const Path& b) { return a.score > b.score; });
    if (here.size() > k) here.resize(k);
  }
  std::vector<Cover> out;
  for (const Path& last : paths[tokens_]) {
    Cover cover{{}, last.score};
    for (const Path* p = &last; p->phrase != none; p = &paths[p->at][p->rank]) cover.phrases.push_back(p->phrase);
    std::reverse(cover.phrases.begin(), cover.phrases.end());
    out.push_back(std::move(cover));
  }
  return out;
}

namespace {

// Sums over covers by dynamic programming, and their derivatives. A cell is a number of tokens and a set of wanted
// landmarks that the covers of these tokens name.
class Sums {
 public:
  Sums(std::size_t tokens, std::size_t masks, std::span<const std::size_t> before, double adjacent)
      : tokens_(tokens), masks_(masks), before_(before), adjacent_(std::exp(adjacent) - 1) {
    for (auto* cells : {&ended_, &all_, &d_ended_, &d_all_}) cells->assign((tokens + 1) * masks, 0);
  }
  void add(const MentionPhrase& phrase, double weight, std::size_t bit) { steps_.push_back({&phrase, weight, bit}); }

  // Σ of the weights of all covers of all tokens. Phrases are added by their ends, before this.
  double total() {
    all_[0] = 1;
    auto step = steps_.begin();
    for (std::size_t p = 1; p <= tokens_; ++p) {
      for (; step != steps_.end() && step->phrase->end == p; ++step)
        for (std::size_t mask = 0; mask < masks_; ++mask)
          ended_[cell(p, mask | step->bit)] += reach(*step, mask) * step->weight;
      for (std::size_t mask = 0; mask < masks_; ++mask)
        all_[cell(p, mask)] = all_[cell(p - 1, mask)] + ended_[cell(p, mask)];
    }
    return all_.back();
  }

  // The derivatives of log total, after total().
  void add_expected(MentionVector& expected) {
    const double total = all_.back();
    d_all_.back() = 1;
    auto step = steps_.rbegin();
    for (std::size_t p = tokens_; p > 0; --p) {
      for (std::size_t mask = 0; mask < masks_; ++mask) {
        d_ended_[cell(p, mask)] += d_all_[cell(p, mask)];
        d_all_[cell(p - 1, mask)] += d_all_[cell(p, mask)];
      }
      for (; step != steps_.rend() && step->phrase->end == p; ++step) {
        double taken = 0;
        for (std::size_t mask = 0; mask < masks_; ++mask) {
          const double d = d_ended_[cell(p, mask | step->bit)] * step->weight;
          const std::size_t begin = step->phrase->begin, beside = cell(before_[begin], mask);
          taken += d * reach(*step, mask);
          at(expected, MentionFeature::Adjacent) += d * (adjacent_ + 1) * ended_[beside] / total;
          d_all_[cell(begin, mask)] += d;
          d_ended_[beside] += d * adjacent_;
        }
        for (std::size_t i = 0; i < mention_features; ++i) expected[i] += step->phrase->features[i] * taken / total;
      }
    }
  }

 private:
  struct Step {
    const MentionPhrase* phrase;
    double weight;
    std::size_t bit;  // of its landmark among the wanted ones
  };
  std::size_t cell(std::size_t p, std::size_t mask) const { return p * masks_ + mask; }
  // The covers that the phrase may follow.
  double reach(const Step& step, std::size_t mask) const {
    const std::size_t begin = step.phrase->begin;
    return all_[cell(begin, mask)] + adjacent_ * ended_[cell(before_[begin], mask)];
  }

  std::size_t tokens_, masks_;
  std::span<const std::size_t> before_;
  double adjacent_;  // what the weight of a phrase gains when it stands beside the one before
  std::vector<Step> steps_;
  std::vector<double> ended_, all_;  // covers whose last phrase ends with the last token; all covers
  std::vector<double> d_ended_, d_all_;
};

}  // namespace

double MentionLattice::log_sum(const MentionVector& weights, MentionVector& expected,
                               const std::vector<std::size_t>* wanted) const {
  Sums sums(tokens_, wanted ? std::size_t{1} << wanted->size() : 1, before_, at(weights, MentionFeature::Adjacent));
  for (const MentionPhrase& phrase : phrases_) {
    std::size_t bit = 0;
    if (wanted) {
      const auto it = std::find(wanted->begin(), wanted->end(), phrase.landmark);
      if (it == wanted->end()) continue;
      bit = std::size_t{1} << (it - wanted->begin());
    }
    sums.add(phrase, std::exp(dot(weights, phrase.features)), bit);
  }
  const double total = sums.total();
  if (!(total > 0)) return -std::numeric_limits<double>::infinity();
  sums.add_expected(expected);
  return std::log(total);
}

}  // namespace waymark::parser

#include "libparser/domain/commands/mention_lattice.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string_view>

namespace waymark::parser {
namespace {

using Tokens = std::vector<std::string>;

// Where words end that leave a phrase beside the one before: "on", "operated by", ", a".
std::vector<std::size_t> ends_before(const Tokens& words) {
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
  Tokens words;
  for (const std::string& token : tokens) words.push_back(word_root(token));
  before_ = ends_before(words);
  phrases_ = mention_phrases(tokens, city, synonyms);
}

MentionVector MentionLattice::features(std::span<const std::size_t> phrases) const {
  MentionVector sum{};
  std::size_t ended = std::numeric_limits<std::size_t>::max();
  for (const std::size_t p : phrases) {
    const MentionPhrase& phrase = phrases_[p];
    for (std::size_t i = 0; i < mention_features; ++i) sum[i] += phrase.features[i];
    if (is_beside(phrase, ended)) ++at(sum, MentionFeature::Adjacent);
    ended = phrase.end;
  }
  return sum;
}

namespace {

struct Path {            // covers of the first tokens, the last phrase of which ends with the last of them
  double score;          // log of its weight
  std::size_t phrase;    // the last one
  std::size_t at, rank;  // the path before it, among those that end there
};

void keep_best(std::vector<Path>& paths, std::size_t k) {
  std::stable_sort(paths.begin(), paths.end(), [](const Path& a, const Path& b) { return a.score > b.score; });
  if (paths.size() > k) paths.resize(k);
}

}  // namespace

std::vector<Cover> MentionLattice::best(const MentionVector& weights, std::size_t k) const {
  constexpr std::size_t none = std::numeric_limits<std::size_t>::max();
  std::vector<std::vector<Path>> ended(tokens_ + 1);
  ended[0].push_back({0, none, 0, 0});
  // The k best paths that end with token `end` or before it; those that end at `beside` gain the weight Adjacent.
  const auto reached = [&](std::size_t end, std::size_t beside) {
    std::vector<Path> out;
    for (std::size_t at = 0; at <= end; ++at)
      for (std::size_t rank = 0; rank < ended[at].size(); ++rank) {
        const double gain = at == beside && at > 0 ? parser::at(weights, MentionFeature::Adjacent) : 0;
        out.push_back({ended[at][rank].score + gain, none, at, rank});
      }
    keep_best(out, k);
    return out;
  };
  std::vector<std::array<std::vector<Path>, 2>> before(tokens_ + 1);  // of phrases that begin here; of clauses
  std::size_t next = 0;
  for (std::size_t end = 1; end <= tokens_; ++end) {
    for (; next < phrases_.size() && phrases_[next].end == end; ++next) {
      const MentionPhrase& phrase = phrases_[next];
      std::vector<Path>& paths = before[phrase.begin][phrase.clause ? 1 : 0];
      if (paths.empty()) paths = reached(phrase.begin, phrase.clause ? none : before_[phrase.begin]);
      const double score = dot(weights, phrase.features);
      for (const Path& path : paths) ended[end].push_back({path.score + score, next, path.at, path.rank});
    }
    keep_best(ended[end], k);
  }
  std::vector<Cover> out;
  for (const Path& last : reached(tokens_, none)) {
    Cover cover{{}, last.score};
    for (const Path* p = &ended[last.at][last.rank]; p->phrase != none; p = &ended[p->at][p->rank])
      cover.phrases.push_back(p->phrase);
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
          d_all_[cell(begin, mask)] += d;
          if (step->phrase->clause) continue;
          at(expected, MentionFeature::Adjacent) += d * (adjacent_ + 1) * ended_[beside] / total;
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
    if (step.phrase->clause) return all_[cell(begin, mask)];
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

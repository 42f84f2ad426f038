#include "libparser/mention/mention.hpp"

#include <algorithm>
#include <array>
#include <string_view>

namespace waymark::parser {
namespace {

constexpr std::size_t least_for_misspelling = 5, most_slots = 12;

}  // namespace

bool is_misspelled(std::string_view a, std::string_view b) {
  if (a.size() > b.size()) std::swap(a, b);
  if (b.size() - a.size() > 1) return false;
  std::size_t i = 0;
  while (i < a.size() && a[i] == b[i]) ++i;
  if (i == a.size()) return true;
  if (a.size() < b.size()) return a.substr(i) == b.substr(i + 1);
  if (a.substr(i + 1) == b.substr(i + 1)) return true;
  return i + 1 < a.size() && a[i] == b[i + 1] && a[i + 1] == b[i] && a.substr(i + 2) == b.substr(i + 2);
}

namespace {

class Finder {
 public:
  Finder(const std::vector<std::string>& tokens, const std::vector<NamedThing>& things, const WordVectors* known)
      : things_(things), known_(known) {
    for (const std::string& token : tokens) words_.push_back(singular(token));
  }

  std::vector<Mention> all() const {
    std::vector<Mention> found;
    for (std::size_t at = 0; at < words_.size();) {
      Mention best = longest(at, false);
      const bool is_word = known_ != nullptr && known_->find(words_[at]);
      if (best.end == 0 && !is_word && words_[at].size() >= least_for_misspelling) best = longest(at, true);
      if (best.end == 0) {
        ++at;
        continue;
      }
      found.push_back(best);
      at = best.end;
    }
    return found;
  }

 private:
  Mention longest(std::size_t at, bool misspelled) const {
    Mention best{at, 0, 0};
    for (std::size_t t = 0; t < things_.size(); ++t)
      for (const auto& phrase : things_[t].phrases)
        if (at + phrase.size() > std::max(best.end, at) && matches(at, phrase, misspelled))
          best = {at, at + phrase.size(), t};
    return best;
  }
  bool matches(std::size_t at, const std::vector<std::string>& phrase, bool misspelled) const {
    if (at + phrase.size() > words_.size()) return false;
    for (std::size_t i = 0; i < phrase.size(); ++i) {
      const std::string& word = words_[at + i];
      if (word == phrase[i]) continue;
      const bool long_enough = std::min(word.size(), phrase[i].size()) >= least_for_misspelling;
      if (!misspelled || !long_enough || !is_misspelled(word, phrase[i])) return false;
    }
    return true;
  }

  std::vector<std::string> words_;
  const std::vector<NamedThing>& things_;
  const WordVectors* known_;
};

bool is_article(const std::string& word) {
  constexpr std::array<std::string_view, 6> articles{"the", "a", "an", "your", "that", "this"};
  return std::find(articles.begin(), articles.end(), word) != articles.end();
}

}  // namespace

std::string singular(std::string word) {
  if (word.size() > 3 && word.back() == 's' && word[word.size() - 2] != 's') word.pop_back();
  return word;
}

std::vector<Mention> find_mentions(const std::vector<std::string>& tokens, const std::vector<NamedThing>& things,
                                   const WordVectors* words) {
  return Finder(tokens, things, words).all();
}

LiftedMentions lift(const std::vector<std::string>& tokens, const std::vector<Mention>& mentions, Articles articles,
                    Names names) {
  LiftedMentions out;
  auto next = mentions.begin();
  for (std::size_t at = 0; at < tokens.size();) {
    if (next == mentions.end() || next->begin != at) {
      out.text.tokens.push_back(tokens[at++]);
      continue;
    }
    while (articles == Articles::Go && !out.text.tokens.empty() && is_article(out.text.tokens.back()))
      out.text.tokens.pop_back();
    auto slot_at = std::find(out.things.begin(), out.things.end(), next->thing);
    if (slot_at == out.things.end() && out.things.size() < most_slots)
      slot_at = out.things.insert(out.things.end(), next->thing);
    if (slot_at != out.things.end() && next->negated) out.text.tokens.emplace_back("not");
    if (slot_at != out.things.end())
      out.text.tokens.push_back(name(slot(static_cast<std::size_t>(slot_at - out.things.begin()) + 1)));
    if (names == Names::Stay)
      out.text.tokens.insert(out.text.tokens.end(), tokens.begin() + static_cast<std::ptrdiff_t>(at),
                             tokens.begin() + static_cast<std::ptrdiff_t>(next->end));
    at = next++->end;
  }
  out.text.scope.slots = out.things.size();
  return out;
}

}  // namespace waymark::parser

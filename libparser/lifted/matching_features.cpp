#include "libparser/lifted/matching_features.hpp"

#include <algorithm>
#include <array>
#include <set>
#include <string>
#include <string_view>

namespace waymark::parser {
namespace {

constexpr std::size_t longest_ngram = 4, letters = 4;

// FNV-1a over the kind of the feature and its parts.
class Key {
 public:
  explicit Key(char kind) { add({&kind, 1}); }
  Key& add(std::string_view part) {
    for (const char c : part) hash_ = (hash_ ^ static_cast<unsigned char>(c)) * 1099511628211ULL;
    hash_ = (hash_ ^ 0x1FU) * 1099511628211ULL;
    return *this;
  }
  Key& add(LiftedSymbol s) {
    const char c = static_cast<char>(s);
    return add({&c, 1});
  }
  std::uint64_t value() const { return hash_; }

 private:
  std::uint64_t hash_ = 14695981039346656037ULL;
};

bool names_slot(std::string_view token) { return token.size() > 1 && token[0] == '#'; }

class TextFeatures {
 public:
  explicit TextFeatures(const LiftedText& text) {
    words_.emplace_back("<s>");
    words_.insert(words_.end(), text.tokens.begin(), text.tokens.end());
    words_.emplace_back("</s>");
  }

  std::vector<std::uint64_t> all() {
    ngrams();
    around_slots();
    order();
    for (const std::string_view word : words_)
      if (!names_slot(word)) letters_of(word);
    std::sort(out_.begin(), out_.end());
    out_.erase(std::unique(out_.begin(), out_.end()), out_.end());
    return std::move(out_);
  }

 private:
  void ngrams() {
    for (std::size_t i = 0; i < words_.size(); ++i) {
      Key key('n');
      for (std::size_t n = 0; n < longest_ngram && i + n < words_.size(); ++n)
        out_.push_back(key.add(words_[i + n]).value());
      if (i + 2 < words_.size()) out_.push_back(Key('s').add(words_[i]).add(words_[i + 2]).value());
    }
  }
  void around_slots() {
    std::string_view slot = "<s>";
    for (const std::string_view word : words_)
      if (names_slot(word))
        slot = word;
      else
        out_.push_back(Key('a').add(slot).add(word).value());
    slot = "</s>";
    for (std::size_t i = words_.size(); i-- > 0;)
      if (names_slot(words_[i]))
        slot = words_[i];
      else
        out_.push_back(Key('b').add(slot).add(words_[i]).value());
  }
  void order() {
    Key key('o');
    std::set<std::string_view> slots;
    for (const std::string_view word : words_)
      if (names_slot(word)) {
        key.add(word);
        slots.insert(word);
      }
    out_.push_back(key.value());
    out_.push_back(Key('c').add(std::to_string(slots.size())).value());
  }
  void letters_of(std::string_view word) {
    const std::string bounded = '^' + std::string(word) + '$';
    for (std::size_t i = 0; i + letters <= bounded.size(); ++i)
      out_.push_back(Key('l').add(std::string_view(bounded).substr(i, letters)).value());
  }

  std::vector<std::string_view> words_;
  std::vector<std::uint64_t> out_;
};

}  // namespace

std::vector<std::uint64_t> matching_features(const LiftedText& text) { return TextFeatures(text).all(); }

std::vector<std::uint64_t> matching_features(std::span<const LiftedSymbol> formula) {
  std::vector<std::uint64_t> out;
  Key whole('W'), kind('K'), order('O');
  std::vector<LiftedSymbol> renamed;
  LiftedPrefix prefix;
  for (std::size_t i = 0; i < formula.size(); ++i) {
    const LiftedSymbol s = formula[i];
    whole.add(s);
    out.push_back(Key('U').add(s).value());
    if (i > 0) out.push_back(Key('B').add(formula[i - 1]).add(s).value());
    if (i > 1) out.push_back(Key('T').add(formula[i - 2]).add(formula[i - 1]).add(s).value());
    if (is_thing(s)) {
      order.add(s);
      auto at = std::find(renamed.begin(), renamed.end(), s);
      if (at == renamed.end()) at = renamed.insert(at, s);
      kind.add("#").add(std::to_string(at - renamed.begin()));
      Key path('P');
      for (const LiftedPrefix::Frame& frame : prefix.open()) {
        path.add(frame.symbol);
        if (operands_of(frame.symbol) != any_number) path.add(std::to_string(frame.operands));
      }
      out.push_back(path.add(s).value());
    } else {
      kind.add(s);
    }
    prefix.append(s);
  }
  out.insert(out.end(),
             {whole.value(), kind.value(), order.value(), Key('N').add(std::to_string(renamed.size())).value()});
  return out;
}

}  // namespace waymark::parser

// The distinct letters of a model. Each letter has a small number, its LetterId, which indexes tables over letters.
#pragma once
#include <compare>
#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "libltl/diagnostic.hpp"
#include "libltl/vocabulary.hpp"
#include "libltl/word.hpp"

namespace waymark::plan {

struct LetterId {           // of one model
  std::uint32_t index = 0;  // from 0
  friend auto operator<=>(const LetterId&, const LetterId&) = default;
};

class Letters {
 public:
  explicit Letters(ltl::Vocabulary vocabulary = {}) : vocabulary_(std::move(vocabulary)) {}

  // The number of the letter; a new letter gets the next number.
  LetterId intern(const ltl::Letter& letter);
  const ltl::Vocabulary& vocabulary() const { return vocabulary_; }
  std::size_t size() const { return letters_.size(); }
  const ltl::Letter& operator[](LetterId id) const { return letters_[id.index]; }
  const std::vector<ltl::Letter>& all() const { return letters_; }  // by LetterId

 private:
  ltl::Vocabulary vocabulary_;
  std::vector<ltl::Letter> letters_;
  std::map<std::vector<ltl::Proposition>, std::uint32_t> index_;
};

// The error for a proposition that no letter over the vocabulary can carry, with the nearest name as a hint.
ltl::FormatError unknown_proposition(const std::string& owner, const ltl::Vocabulary& vocabulary,
                                     const std::string& name);

}  // namespace waymark::plan

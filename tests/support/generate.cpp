#include "tests/support/generate.hpp"

#include <algorithm>
#include <unordered_set>

#include "libltl/text/print.hpp"

namespace waymark::testing {
namespace {

using ltl::Formula;
using ltl::Letter;

std::vector<Letter> all_letters(std::size_t atoms) {
  std::vector<Letter> out;
  for (std::uint32_t bits = 0; bits < (1U << atoms); ++bits) {
    Letter letter;
    for (std::uint32_t p = 0; p < atoms; ++p)
      if (((bits >> p) & 1U) != 0) letter.insert(ltl::Proposition{p});
    out.push_back(letter);
  }
  return out;
}

// Every sequence of exactly `length` letters.
std::vector<std::vector<Letter>> sequences(std::size_t length, std::size_t atoms) {
  const std::vector<Letter> letters = all_letters(atoms);
  std::vector<std::vector<Letter>> out{{}};
  for (std::size_t i = 0; i < length; ++i) {
    std::vector<std::vector<Letter>> longer;
    for (const auto& word : out)
      for (const Letter& letter : letters) {
        longer.push_back(word);
        longer.back().push_back(letter);
      }
    out = std::move(longer);
  }
  return out;
}

// Formulas in the order in which they were found, by the number of constructors it took.
class Enumeration {
 public:
  Enumeration(std::size_t size, bool past) : past_(past), by_size_(size + 1) {}

  void add(std::size_t size, Formula f) {
    if (seen_.insert(f).second) by_size_[size].push_back(f);
  }
  void extend(std::size_t size) {
    for (Formula f : by_size_[size - 1]) {
      add(size, negate(f));
      add(size, next(f));
      add(size, weak_next(f));
      if (past_) add(size, yesterday(f));
    }
    for (std::size_t left = 1; left + 1 < size; ++left)
      for (Formula f : by_size_[left])
        for (Formula g : by_size_[size - 1 - left]) combine(size, f, g);
  }
  std::vector<Formula> all() const {
    std::vector<Formula> out;
    for (const auto& formulas : by_size_) out.insert(out.end(), formulas.begin(), formulas.end());
    return out;
  }

 private:
  void combine(std::size_t size, Formula f, Formula g) {
    if (!(g < f)) {  // these three commute
      add(size, conjunction(f, g));
      add(size, disjunction(f, g));
      add(size, iff(f, g));
    }
    add(size, until(f, g));
    add(size, release(f, g));
    if (past_) add(size, since(f, g));
  }
  bool past_;
  std::vector<std::vector<Formula>> by_size_;
  std::unordered_set<Formula> seen_;
};

}  // namespace

ltl::Vocabulary letters_vocabulary(std::size_t atoms) {
  ltl::Vocabulary out;
  for (std::size_t i = 0; i < atoms; ++i) out.add(std::string(1, static_cast<char>('a' + i)));
  return out;
}

std::vector<Formula> all_formulas(ltl::Arena& arena, const FormulaSpace& space) {
  const ltl::Vocabulary names = letters_vocabulary(space.atoms);
  for (std::size_t i = arena.vocabulary().size(); i < space.atoms; ++i) arena.add_proposition(names.names()[i]);
  Enumeration formulas(space.size, space.past);
  formulas.add(1, arena.constant(false));
  formulas.add(1, arena.constant(true));
  for (std::uint32_t p = 0; p < space.atoms; ++p) formulas.add(1, arena.atom(ltl::Proposition{p}));
  for (std::size_t size = 2; size <= space.size; ++size) formulas.extend(size);
  return formulas.all();
}

std::vector<ltl::Trace> all_traces(const WordSpace& space) {
  std::vector<ltl::Trace> out;
  for (std::size_t length = 1; length <= space.length; ++length)
    for (auto& word : sequences(length, space.atoms)) out.emplace_back(std::move(word));
  return out;
}

std::vector<ltl::Lasso> all_lassos(const WordSpace& space) {
  std::vector<ltl::Lasso> out;
  for (std::size_t length = 1; length <= space.length; ++length)
    for (const auto& word : sequences(length, space.atoms))
      for (std::size_t loop = 0; loop < length; ++loop) {
        const auto middle = word.begin() + static_cast<std::ptrdiff_t>(loop);
        out.emplace_back(std::vector<Letter>(word.begin(), middle), std::vector<Letter>(middle, word.end()));
      }
  return out;
}

std::string show(Formula f) { return "formula: " + ltl::print(f); }
std::string show(Formula f, const ltl::Trace& word) {
  return show(f) + "   word: " + ltl::show(word, f.arena().vocabulary());
}
std::string show(Formula f, const ltl::Lasso& word) {
  return show(f) + "   lasso: " + ltl::show(word, f.arena().vocabulary());
}

}  // namespace waymark::testing

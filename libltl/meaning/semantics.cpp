// The definition, line by line, as a table: truth[f][i] is  w,i ⊨ f. Filled from the subformulas up, so that depth
// of the formula is not depth of the call stack; for the rest nothing is clever here.
#include "libltl/meaning/semantics.hpp"

#include <algorithm>
#include <unordered_map>
#include <utility>
#include <vector>

namespace waymark::ltl {
namespace {

using Row = std::vector<bool>;  // by position

// The positions read from i on, in order, each once: on a trace i, i+1, …; on a lasso until the first repetition.
std::vector<std::size_t> from(const Trace& word, std::size_t i) {
  std::vector<std::size_t> out;
  for (; i < word.size(); ++i) out.push_back(i);
  return out;
}

std::vector<std::size_t> from(const Lasso& word, std::size_t i) {
  std::vector<std::size_t> out;
  std::vector<bool> seen(word.size());
  for (; !seen[i]; i = word.successor(i)) {
    seen[i] = true;
    out.push_back(i);
  }
  return out;
}

// w,i ⊨ φ U ψ iff there is a k from i on with w,k ⊨ ψ, and w,j ⊨ φ for every j from i on before k.
bool until_holds(const std::vector<std::size_t>& positions, const Row& left, const Row& right) {
  for (std::size_t k : positions) {
    if (right[k]) return true;
    if (!left[k]) return false;
  }
  return false;
}

// φ R ψ is ¬(¬φ U ¬ψ): ψ holds at every k from i on unless φ held before k.
bool release_holds(const std::vector<std::size_t>& positions, const Row& left, const Row& right) {
  for (std::size_t k : positions) {
    if (!right[k]) return false;
    if (left[k]) return true;
  }
  return true;
}

// w,i ⊨ φ S ψ iff there is a k up to i with w,k ⊨ ψ, and w,j ⊨ φ for every j behind k up to i.
bool since_holds(std::size_t i, const Row& left, const Row& right) {
  for (std::size_t k = i + 1; k-- > 0;) {
    if (right[k]) return true;
    if (!left[k]) return false;
  }
  return false;
}

bool next_holds(const Trace& word, std::size_t i, const Row& row) { return i + 1 < word.size() && row[i + 1]; }
bool weak_next_holds(const Trace& word, std::size_t i, const Row& row) { return i + 1 == word.size() || row[i + 1]; }
bool next_holds(const Lasso& word, std::size_t i, const Row& row) { return row[word.successor(i)]; }
bool weak_next_holds(const Lasso& word, std::size_t i, const Row& row) { return row[word.successor(i)]; }

bool all_hold(const std::vector<const Row*>& rows, std::size_t i) {
  for (const Row* row : rows)
    if (!(*row)[i]) return false;
  return true;
}

bool any_holds(const std::vector<const Row*>& rows, std::size_t i) {
  for (const Row* row : rows)
    if ((*row)[i]) return true;
  return false;
}

template <class Word>
bool holds_at(const Word& word, std::size_t i, Formula f, const std::vector<const Row*>& rows) {
  switch (f.op()) {
    case Op::False: return false;
    case Op::True: return true;
    case Op::Atom: return word[i].contains(f.proposition());
    case Op::Not: return !(*rows[0])[i];
    case Op::And: return all_hold(rows, i);
    case Op::Or: return any_holds(rows, i);
    case Op::Iff: return (*rows[0])[i] == (*rows[1])[i];
    case Op::Next: return next_holds(word, i, *rows[0]);
    case Op::WeakNext: return weak_next_holds(word, i, *rows[0]);
    case Op::Until: return until_holds(from(word, i), *rows[0], *rows[1]);
    case Op::Release: return release_holds(from(word, i), *rows[0], *rows[1]);
    case Op::Yesterday: return i > 0 && (*rows[0])[i - 1];
    case Op::Since: return since_holds(i, *rows[0], *rows[1]);
  }
  return false;  // unreachable: -Werror=switch
}

template <class Word>
Row truth_by_definition(const Word& word, Formula f) {
  std::unordered_map<Formula, Row> truth;
  for (Formula g : subformulas(f)) {
    std::vector<const Row*> rows;
    for (Formula operand : g.operands()) rows.push_back(&truth.at(operand));
    Row row(word.size());
    for (std::size_t i = 0; i < word.size(); ++i) row[i] = holds_at(word, i, g, rows);
    truth.emplace(g, std::move(row));
  }
  return truth.at(f);
}

// Past operators below each other, at most.
std::size_t past_depth(Formula f) {
  std::unordered_map<Formula, std::size_t> depth;
  for (Formula g : subformulas(f)) {
    std::size_t below = 0;
    for (Formula operand : g.operands()) below = std::max(below, depth.at(operand));
    depth.emplace(g, below + (is_past(g.op()) ? 1 : 0));
  }
  return depth.at(f);
}

// u·vⁿ·vʷ. Where the operands of S repeat with the cycle, S does so one cycle later at most: what a cycle makes of its
// truth before the cycle is monotone, so the truth after one cycle is the truth after all. Y repeats one letter later.
Lasso unrolled(const Lasso& word, std::size_t n) {
  std::vector<Letter> prefix, cycle;
  for (std::size_t i = 0; i < word.size(); ++i) (i < word.loop_start() ? prefix : cycle).push_back(word[i]);
  for (std::size_t i = 0; i < n; ++i) prefix.insert(prefix.end(), cycle.begin(), cycle.end());
  return Lasso(std::move(prefix), std::move(cycle));
}

}  // namespace

bool holds(const Trace& word, Formula f) { return truth_by_definition(word, f)[0]; }
bool holds(const Lasso& word, Formula f) {
  const std::size_t depth = past_depth(f);
  return depth == 0 ? truth_by_definition(word, f)[0] : truth_by_definition(unrolled(word, depth), f)[0];
}
std::vector<bool> truth(const Trace& word, Formula f) { return truth_by_definition(word, f); }

}  // namespace waymark::ltl

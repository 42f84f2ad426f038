// The definition, line by line, as a table: truth[f][i] is  w,i ⊨ f. Filled from the subformulas up, so that depth
// of the formula is not depth of the call stack; for the rest nothing is clever here.
#include "libltl/meaning/semantics.hpp"

#include <unordered_map>
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
  }
  return false;  // unreachable: -Werror=switch
}

template <class Word>
bool holds_by_definition(const Word& word, Formula f) {
  std::unordered_map<Formula, Row> truth;
  for (Formula g : subformulas(f)) {
    std::vector<const Row*> rows;
    for (Formula operand : g.operands()) rows.push_back(&truth.at(operand));
    Row row(word.size());
    for (std::size_t i = 0; i < word.size(); ++i) row[i] = holds_at(word, i, g, rows);
    truth.emplace(g, std::move(row));
  }
  return truth.at(f)[0];
}

}  // namespace

bool holds(const Trace& word, Formula f) { return holds_by_definition(word, f); }
bool holds(const Lasso& word, Formula f) { return holds_by_definition(word, f); }

}  // namespace waymark::ltl

#include "libltl/word.hpp"

#include <algorithm>
#include <bit>
#include <stdexcept>
#include <utility>

namespace waymark::ltl {

void Letter::insert(Proposition p) {
  const std::size_t block = p.index / 64;
  const std::uint64_t bit = std::uint64_t{1} << (p.index % 64);
  if (block == 0) {
    first_ |= bit;
    return;
  }
  if (rest_.size() < block) rest_.resize(block);
  rest_[block - 1] |= bit;
}

void Letter::erase(Proposition p) {
  const std::size_t block = p.index / 64;
  const std::uint64_t bit = std::uint64_t{1} << (p.index % 64);
  if (block == 0) {
    first_ &= ~bit;
    return;
  }
  if (rest_.size() < block) return;
  rest_[block - 1] &= ~bit;
  while (!rest_.empty() && rest_.back() == 0) rest_.pop_back();
}

void Letter::insert_all(const Letter& other) {
  first_ |= other.first_;
  if (rest_.size() < other.rest_.size()) rest_.resize(other.rest_.size());
  for (std::size_t i = 0; i < other.rest_.size(); ++i) rest_[i] |= other.rest_[i];
}

bool Letter::includes(const Letter& other) const {
  if ((other.first_ & ~first_) != 0 || other.rest_.size() > rest_.size()) return false;
  for (std::size_t i = 0; i < other.rest_.size(); ++i)
    if ((other.rest_[i] & ~rest_[i]) != 0) return false;
  return true;
}

std::vector<Proposition> Letter::members() const {
  std::vector<Proposition> out;
  for (std::size_t i = 0; i <= rest_.size(); ++i)
    for (std::uint64_t bits = block(i); bits != 0; bits &= bits - 1)
      out.push_back(
          Proposition{static_cast<std::uint32_t>(64 * i) + static_cast<std::uint32_t>(std::countr_zero(bits))});
  return out;
}

Trace::Trace(std::vector<Letter> letters) : letters_(std::move(letters)) {
  if (letters_.empty()) throw std::invalid_argument("a finite word has at least one letter");
}

Lasso::Lasso(std::vector<Letter> prefix, std::vector<Letter> cycle)
    : letters_(std::move(prefix)), loop_start_(letters_.size()) {
  if (cycle.empty()) throw std::invalid_argument("the cycle of a lasso has at least one letter");
  letters_.insert(letters_.end(), std::make_move_iterator(cycle.begin()), std::make_move_iterator(cycle.end()));
}

namespace {

// As read_word reads it: an identifier, or in double quotes.
std::string shown_name(const std::string& name) {
  const auto is_letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; };
  const auto is_plain = [&](char c) { return is_letter(c) || (c >= '0' && c <= '9'); };
  if (is_letter(name[0]) && std::all_of(name.begin(), name.end(), is_plain)) return name;
  std::string out = "\"";
  for (const char c : name) {
    if (c == '"' || c == '\\') out += '\\';
    out += c == '\n' ? "\\n" : std::string(1, c);
  }
  return out + '"';
}

}  // namespace

std::string show(const Letter& letter, const Vocabulary& vocabulary) {
  std::string out = "{";
  for (Proposition p : letter.members()) {
    if (out.size() > 1) out += ", ";
    out += shown_name(vocabulary.name(p));
  }
  return out + "}";
}

std::string show(const Trace& word, const Vocabulary& vocabulary) {
  std::string out;
  for (const Letter& letter : word) out += (out.empty() ? "" : "; ") + show(letter, vocabulary);
  return out;
}

std::string show(const Lasso& word, const Vocabulary& vocabulary) {
  std::string out;
  for (std::size_t i = 0; i < word.size(); ++i) {
    if (i > 0) out += "; ";
    if (i == word.loop_start()) out += "(";
    out += show(word[i], vocabulary);
  }
  return out + ")ʷ";
}

}  // namespace waymark::ltl

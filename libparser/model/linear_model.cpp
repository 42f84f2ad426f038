#include "libparser/model/linear_model.hpp"

#include <algorithm>
#include <cassert>

#include "libltl/diagnostic.hpp"

namespace waymark::parser {
namespace {

// "ahead_chair" → {"ahead", "chair"}, "chair" → {"here", "chair"}, "dead_end" → {"here", "dead_end"}.
std::pair<std::string, std::string> parts_of(const std::string& literal) {
  for (const char* direction : {"ahead", "left", "right", "behind", "next", "turned", "place"}) {
    const std::string prefix = std::string(direction) + "_";
    if (literal.rfind(prefix, 0) == 0) return {direction, literal.substr(prefix.size())};
  }
  return {"here", literal};
}

}  // namespace

Columns::Columns(const PostfixGrammar& grammar) : tokens(grammar.tokens()) {
  std::unordered_map<std::string, std::uint16_t> index;
  const auto part = [&](const std::string& part_name) {
    const auto [it, is_new] = index.try_emplace(part_name, static_cast<std::uint16_t>(size()));
    if (is_new) parts.push_back(part_name);
    return it->second;
  };
  mention = part("mention");
  for (std::size_t t = 0; t < tokens; ++t) {
    const std::string& token_name = grammar.name(static_cast<Token>(t));
    if (grammar.is_literal(static_cast<Token>(t))) {
      const auto [d, o] = parts_of(token_name);
      direction.push_back(part("direction " + d));
      thing.push_back(part("thing " + o));
    } else {
      const bool forward = t >= PostfixGrammar::first_forward && t < PostfixGrammar::first_literal;
      direction.push_back(part(forward ? "forward" : "operator"));
      thing.push_back(part(forward ? "count " + token_name.substr(8) : "operator " + token_name));
    }
  }
}

WordTable::WordTable() {
  add("<unknown>");
  add("<s>");
  add("</s>");
}

std::uint32_t WordTable::find(std::string_view word) const {
  const auto it = index_.find(std::string(word));
  return it == index_.end() ? unknown : it->second;
}

std::uint32_t WordTable::add(std::string_view word) {
  const auto [it, is_new] = index_.try_emplace(std::string(word), static_cast<std::uint32_t>(words_.size()));
  if (is_new) words_.emplace_back(word);
  return it->second;
}

// Where the feature stands, or the empty slot where it would.
std::size_t WeightTable::slot_of(std::uint64_t feature) const {
  std::uint64_t hash = (feature ^ feature >> 31U) * 0x9E3779B97F4A7C15ULL;
  hash ^= hash >> 32U;
  std::size_t slot = hash & (slots_.size() - 1);
  while (slots_[slot] != absent && keys_[slots_[slot]] != feature) slot = (slot + 1) & (slots_.size() - 1);
  return slot;
}

std::uint32_t WeightTable::find(std::uint64_t feature) const { return slots_[slot_of(feature)]; }

std::uint32_t WeightTable::add(std::uint64_t feature) {
  const std::size_t slot = slot_of(feature);
  if (slots_[slot] != absent) return slots_[slot];
  assert(dense());
  const std::uint32_t row = new_row(slot, feature);
  weights_.resize(weights_.size() + columns_, 0.0F);
  return row;
}

std::uint32_t WeightTable::new_row(std::size_t slot, std::uint64_t feature) {
  const auto row = static_cast<std::uint32_t>(keys_.size());
  slots_[slot] = row;
  keys_.push_back(feature);
  if (2 * keys_.size() > slots_.size()) reserve(keys_.size());
  return row;
}

bool WeightTable::add_row(std::uint64_t feature, std::span<const Weight> weights) {
  assert(weights_.empty());
  const std::size_t slot = slot_of(feature);
  if (slots_[slot] != absent) return false;
  new_row(slot, feature);
  if (begin_.empty()) begin_.push_back(0);
  sparse_.insert(sparse_.end(), weights.begin(), weights.end());
  begin_.push_back(static_cast<std::uint32_t>(sparse_.size()));
  return true;
}

float WeightTable::weight(std::uint32_t r, std::size_t column) const {
  if (dense()) return weights_[r * columns_ + column];
  for (std::size_t i = begin_[r]; i < begin_[r + 1]; ++i)
    if (sparse_[i].column == column) return sparse_[i].value;
  return 0;
}

void WeightTable::add_to(std::uint32_t r, float* sums) const {
  if (dense()) {
    const float* const row = weights_.data() + r * columns_;
    for (std::size_t c = 0; c < columns_; ++c) sums[c] += row[c];
  } else {
    for (std::size_t i = begin_[r]; i < begin_[r + 1]; ++i) sums[sparse_[i].column] += sparse_[i].value;
  }
}

void WeightTable::reserve(std::size_t rows) {
  keys_.reserve(rows);
  std::size_t size = slots_.size();
  while (size < 4 * rows) size *= 2;
  slots_.assign(size, absent);
  for (std::uint32_t row = 0; row < keys_.size(); ++row) slots_[slot_of(keys_[row])] = row;
}

LinearModel::LinearModel(const ltl::Vocabulary& vocabulary, Dialect dialect)
    : reader(Columns(PostfixGrammar(vocabulary, dialect)).size()),
      reranker(1),
      start_pose_model(1),
      vocabulary_(vocabulary),
      grammar_(vocabulary, dialect),
      columns_(grammar_) {}

void LinearModel::check_vocabulary(const ltl::Vocabulary& vocabulary, std::string_view whose) const {
  if (vocabulary == vocabulary_) return;
  std::string message =
      "the model was trained on another vocabulary than that of " + std::string(whose) + ": ";
  for (const std::string& name : vocabulary_.names()) {
    if (vocabulary.find(name)) continue;
    throw ltl::FormatError("", 0, 0, message + "'" + name + "' is missing there");
  }
  for (const std::string& name : vocabulary.names()) {
    if (vocabulary_.find(name)) continue;
    throw ltl::FormatError("", 0, 0, message + "the model does not know '" + name + "'");
  }
  throw ltl::FormatError("", 0, 0, message + "the same names stand in another order");
}

}  // namespace waymark::parser

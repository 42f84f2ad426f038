// The rows of PRISM's explicit transitions, sorted by state and choice.
#pragma once
#include <algorithm>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "libplan/model/model.hpp"

namespace waymark::plan {

struct ExplicitRow {                                             // an outcome
  std::uint32_t source = 0, choice = 0, target = 0, action = 0;  // action: its number
  double probability = 0;                                        // of the target
};

// Rows as they are read: sixteen bytes a row and a choice while they come in order, and they do from PRISM.
class ExplicitRows {
 public:
  struct Choice {                                     // of a state
    std::uint32_t source, number, action, first_row;  // its rows end where those of the next one begin
  };
  void add(const ExplicitRow& row) {  // in any order
    if (in_order_ && !choices_.empty() && place(row) < place(choices_.back())) spread();
    if (in_order_)
      append(row);
    else
      rows_.push_back(row);
  }
  void sort() {  // once all were added
    std::stable_sort(rows_.begin(), rows_.end(),
                     [](const ExplicitRow& a, const ExplicitRow& b) { return place(a) < place(b); });
    for (const ExplicitRow& row : rows_) append(row);
    rows_ = {};
  }
  std::size_t size() const { return outcomes_.size() + rows_.size(); }
  // Once they are sorted: by source and number; their outcomes, without letters.
  const std::vector<Choice>& choices() const { return choices_; }
  std::vector<ModelOutcome>& outcomes() { return outcomes_; }
  std::span<const ModelOutcome> outcomes(std::size_t choice) const {
    const std::size_t end = choice + 1 < choices_.size() ? choices_[choice + 1].first_row : outcomes_.size();
    return {outcomes_.data() + choices_[choice].first_row, outcomes_.data() + end};
  }

 private:
  static std::pair<std::uint32_t, std::uint32_t> place(const ExplicitRow& row) { return {row.source, row.choice}; }
  static std::pair<std::uint32_t, std::uint32_t> place(const Choice& c) { return {c.source, c.number}; }
  void append(const ExplicitRow& row) {
    if (choices_.empty() || place(choices_.back()) != place(row))
      choices_.push_back({row.source, row.choice, row.action, static_cast<std::uint32_t>(outcomes_.size())});
    outcomes_.push_back({row.target, LetterId{}, row.probability});
  }
  void spread() {  // back into rows
    in_order_ = false;
    for (std::size_t c = 0; c < choices_.size(); ++c)
      for (const ModelOutcome& o : outcomes(c))
        rows_.push_back({choices_[c].source, choices_[c].number, o.target, choices_[c].action, o.probability});
    choices_.clear();
    outcomes_.clear();
  }

  bool in_order_ = true;
  std::vector<ExplicitRow> rows_;  // once one was out of order
  std::vector<Choice> choices_;
  std::vector<ModelOutcome> outcomes_;
};

}  // namespace waymark::plan

#include "tools/progression_values.hpp"

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

namespace waymark::tools {
namespace {

using Pairs = std::vector<bool>;
using Values = std::vector<double>;
using Choice = ProgressionProduct::Choice;

class Bellman {
 public:
  Bellman(const ProgressionProduct& product, Optimum what, const std::stop_token& stop)
      : product_(product), what_(what), stop_(stop), size_(product.goal.size()) {}

  Bracket bracket() {
    allow_all();
    if (is_cost() && is_infinite()) return {INFINITY, INFINITY};
    const Values low = raised(Values(size_, 0));
    Bracket out{low[0], what_ == Optimum::LeastCost ? of_a_strategy(low) : from_above(low)};
    if (!is_cost()) out.above = std::min(out.above, 1.0);
    return out;
  }

 private:
  bool is_cost() const { return what_ == Optimum::LeastCost || what_ == Optimum::GreatestCost; }
  bool is_greatest() const { return what_ == Optimum::GreatestProbability || what_ == Optimum::GreatestCost; }

  void allow_all() {
    for (const auto& row : product_.choices) allowed_.emplace_back(row.size(), true);
  }

  static bool all_in(const Choice& c, const Pairs& set) {
    return std::all_of(c.outcomes.begin(), c.outcomes.end(), [&](const auto& o) { return set[o.first]; });
  }
  static bool some_in(const Choice& c, const Pairs& set) {
    return std::any_of(c.outcomes.begin(), c.outcomes.end(), [&](const auto& o) { return set[o.first]; });
  }

  // Pairs added one after the other that have an allowed choice for which `leads` holds.
  template <class Leads>
  void close(Pairs& set, const Leads& leads) const {
    for (bool more = true; more;) {
      more = false;
      for (std::size_t at = size_; at-- > 0;) {
        if (set[at]) continue;
        for (std::size_t k = 0; k < product_.choices[at].size() && !set[at]; ++k)
          if (allowed_[at][k] && leads(product_.choices[at][k])) set[at] = more = true;
      }
    }
  }

  // The pairs from which the goal can be avoided for ever.
  Pairs avoiding() const {
    Pairs set(size_);
    for (std::size_t at = 0; at < size_; ++at) set[at] = !product_.goal[at];
    for (bool more = true; more;) {
      more = false;
      for (std::size_t at = 0; at < size_; ++at) {
        const auto& row = product_.choices[at];
        if (!set[at] || row.empty()) continue;
        if (std::none_of(row.begin(), row.end(), [&](const Choice& c) { return all_in(c, set); }))
          set[at] = false, more = true;
      }
    }
    return set;
  }

  bool is_infinite() {
    if (what_ == Optimum::GreatestCost) {
      Pairs missed = avoiding();
      close(missed, [&](const Choice& c) { return some_in(c, missed); });
      return missed[0];
    }
    Pairs sure(size_, true);
    for (bool more = true; more;) {
      Pairs next = product_.goal;  // from which the goal is reached without leaving `sure`
      close(next, [&](const Choice& c) { return all_in(c, sure) && some_in(c, next); });
      more = next != sure;
      sure = std::move(next);
    }
    for (std::size_t at = 0; at < size_; ++at)
      for (std::size_t k = 0; k < allowed_[at].size(); ++k)
        allowed_[at][k] = sure[at] && all_in(product_.choices[at][k], sure);
    return !sure[0];
  }

  double value(const Choice& c, const Values& values) const {
    double sum = is_cost() ? c.cost : 0;
    for (const auto& [to, p] : c.outcomes) sum += p * values[to];
    return sum;
  }

  double swept(std::size_t at, const Values& values) const {
    if (product_.goal[at]) return is_cost() ? 0 : 1;
    std::optional<double> best;
    for (std::size_t k = 0; k < allowed_[at].size(); ++k) {
      if (!allowed_[at][k]) continue;
      const double now = value(product_.choices[at][k], values);
      best = !best ? now : is_greatest() ? std::max(*best, now) : std::min(*best, now);
    }
    return best.value_or(0);
  }

  Values raised(Values values) const {
    constexpr int most = 1'000'000;
    for (int i = 0; i < most && !stop_.stop_requested(); ++i) {
      bool changed = false;
      for (std::size_t at = size_; at-- > 0;) {
        const double now = swept(at, values);
        if (now > values[at] + 1e-15 * std::max(1.0, values[at])) values[at] = now, changed = true;
      }
      if (!changed) break;
    }
    return values;
  }

  // Where the value is 0 whatever is tried, nothing is added.
  double from_above(const Values& low) const {
    Pairs none = what_ == Optimum::LeastProbability ? avoiding() : Pairs(size_, false);
    if (what_ == Optimum::GreatestProbability) {
      Pairs some = product_.goal;
      close(some, [&](const Choice& c) { return some_in(c, some); });
      for (std::size_t at = 0; at < size_; ++at) none[at] = !some[at];
    }
    Values high(size_);
    for (std::size_t at = 0; at < size_; ++at) high[at] = none[at] || product_.goal[at] ? low[at] : more_than(low[at]);
    for (int i = 0; i < 10'000 && !stop_.stop_requested(); ++i) {
      Values next(size_);
      bool proved = true;
      for (std::size_t at = 0; at < size_; ++at) {
        next[at] = none[at] ? 0 : swept(at, high);
        proved = proved && next[at] <= high[at] + 1e-13 * std::max(1.0, high[at]);
      }
      if (proved) return high[0];
      high = std::move(next);
    }
    return INFINITY;
  }

  static double more_than(double low) { return low + 4e-7 * std::max(1.0, low); }

  // Only the choices that are as good as the best; nearest to the goal first, so that the strategy goes there.
  double of_a_strategy(const Values& low) {
    Pairs reached = product_.goal;
    for (const double slack : {1e-9, static_cast<double>(INFINITY)})
      for (bool more = true; more;) {
        more = false;
        for (std::size_t at = 0; at < size_; ++at)
          for (std::size_t k = 0; k < allowed_[at].size() && !reached[at]; ++k) {
            const Choice& c = product_.choices[at][k];
            if (!allowed_[at][k] || !some_in(c, reached)) continue;
            if (value(c, low) > low[at] + slack * std::max(1.0, low[at])) continue;
            reached[at] = more = true;
            chosen_.emplace_back(at, k);
          }
      }
    for (auto& row : allowed_) row.assign(row.size(), false);
    for (const auto& [at, k] : chosen_) allowed_[at][k] = true;
    return from_above(raised(low));
  }

  const ProgressionProduct& product_;
  Optimum what_;
  const std::stop_token& stop_;
  std::size_t size_;
  std::vector<std::vector<bool>> allowed_;                   // by pair and choice
  std::vector<std::pair<std::size_t, std::size_t>> chosen_;  // of the strategy
};

}  // namespace

Bracket bracket(const ProgressionProduct& product, Optimum what, const std::stop_token& stop) {
  return Bellman(product, what, stop).bracket();
}

}  // namespace waymark::tools

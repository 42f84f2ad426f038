#include "tools/progression_product.hpp"

#include <cmath>
#include <functional>
#include <map>
#include <queue>
#include <unordered_map>
#include <unordered_set>
#include <variant>

#include "libltl/meaning/progress.hpp"
#include "libltl/rewriting/simplify.hpp"

namespace waymark::tools {
namespace {

using Product = ProgressionProduct;

struct GaveUpOnPairs {};  // thrown

constexpr std::size_t largest_remainder = 2'000;  // subformulas
constexpr std::size_t most_propositions = 12;     // of a formula whose validity is asked for

std::vector<ltl::Letter> letters_of(ltl::Formula f) {
  const std::vector<ltl::Proposition> asked = ltl::propositions(f);
  if (asked.size() > most_propositions) throw GaveUpOnPairs{};
  std::vector<ltl::Letter> out(std::size_t{1} << asked.size());
  for (std::size_t bits = 0; bits < out.size(); ++bits)
    for (std::size_t i = 0; i < asked.size(); ++i)
      if ((bits >> i & 1U) != 0) out[bits].insert(asked[i]);
  return out;
}

class Remainders {
 public:
  explicit Remainders(ltl::Semantics semantics) : semantics_(semantics) {}

  ltl::Formula after(ltl::Formula f, const ltl::Letter& letter) {
    const bool finite = semantics_ == ltl::Semantics::Finite;
    const ltl::Formula rest = ltl::progress(f, letter, semantics_);
    if (const auto known = simple_.find(rest); known != simple_.end()) return known->second;
    if (ltl::subformulas(rest).size() > largest_remainder) throw GaveUpOnPairs{};
    return simple_.emplace(rest, ltl::simplify(rest, finite ? ltl::Over::Rest : ltl::Over::Infinite)).first->second;
  }

  bool settles(ltl::Formula rest) {
    return semantics_ == ltl::Semantics::Finite ? ltl::accepts_empty(rest) : is_valid(rest);
  }

 private:
  // Depth first; what is on the path is open, and to come back there is a cycle that avoids `true`.
  bool is_valid(ltl::Formula f) {
    if (f.op() == ltl::Op::True) return true;
    if (f.op() == ltl::Op::False) return false;
    const auto [known, fresh] = valid_.emplace(f, false);
    if (!fresh) return known->second;
    for (const ltl::Letter& letter : letters_of(f))
      if (!is_valid(after(f, letter))) return false;
    return valid_[f] = true;
  }

  ltl::Semantics semantics_;
  std::unordered_map<ltl::Formula, ltl::Formula> simple_;
  std::unordered_map<ltl::Formula, bool> valid_;
};

template <class Model>
class Explorer {
 public:
  Explorer(const Model& model, ltl::Semantics semantics, const ltl::Limits& limits)
      : model_(model), limits_(limits), remainders_(semantics) {}

  Product explore(ltl::Formula formula) {
    meet(model_.initial(), remainders_.after(formula, model_.letters()[model_.initial_letter()]));
    for (std::size_t at = 0; at < pairs_.size(); ++at) {
      if (pairs_.size() > limits_.states || limits_.stop.stop_requested()) throw GaveUpOnPairs{};
      const auto [state, rest] = pairs_[at];
      out_.goal.push_back(remainders_.settles(rest));
      std::vector<Product::Choice> row;
      const bool ends = out_.goal.back() || rest.op() == ltl::Op::False;
      for (std::uint32_t k = 0; !ends && k < model_.choices(state); ++k) {
        row.push_back({model_.cost(state, k)});
        model_.for_each_outcome(state, k, [&, from = rest](std::uint32_t to, plan::LetterId letter, double p) {
          row.back().outcomes.emplace_back(meet(to, remainders_.after(from, model_.letters()[letter])), p);
        });
      }
      out_.choices.push_back(std::move(row));
    }
    return std::move(out_);
  }

 private:
  std::uint32_t meet(std::uint32_t state, ltl::Formula rest) {
    const auto [at, fresh] = numbers_.emplace(std::pair(state, rest), static_cast<std::uint32_t>(pairs_.size()));
    if (fresh) pairs_.emplace_back(state, rest);
    return at->second;
  }

  const Model& model_;
  const ltl::Limits& limits_;
  Remainders remainders_;
  std::map<std::pair<std::uint32_t, ltl::Formula>, std::uint32_t> numbers_;
  std::vector<std::pair<std::uint32_t, ltl::Formula>> pairs_;
  Product out_;
};

using CostAt = std::pair<double, std::uint32_t>;
using Queue = std::priority_queue<CostAt, std::vector<CostAt>, std::greater<>>;

// By pair: the least cost from there to a goal.
std::vector<double> costs_to_go(const Product& product) {
  std::vector<std::vector<CostAt>> back(product.goal.size());
  for (std::uint32_t at = 0; at < product.goal.size(); ++at)
    for (const Product::Choice& c : product.choices[at]) back[c.outcomes[0].first].emplace_back(c.cost, at);
  std::vector<double> cost(product.goal.size(), INFINITY);
  Queue open;
  for (std::uint32_t at = 0; at < product.goal.size(); ++at)
    if (product.goal[at]) open.emplace(cost[at] = 0, at);
  while (!open.empty()) {
    const auto [now, at] = open.top();
    open.pop();
    if (now > cost[at]) continue;
    for (const auto& [step, from] : back[at])
      if (now + step < cost[from]) open.emplace(cost[from] = now + step, from);
  }
  return cost;
}

}  // namespace

std::optional<ProgressionProduct> product_by_progression(const plan::PlanningCase& model, ltl::Formula formula,
                                                         ltl::Semantics semantics, const ltl::Limits& limits) {
  try {
    return std::visit([&](const auto& m) { return Explorer(m, semantics, limits).explore(formula); }, model.model);
  } catch (const GaveUpOnPairs&) {
    return std::nullopt;
  }
}

double least_cost(const ProgressionProduct& product) { return costs_to_go(product)[0]; }

double count_walks(const ProgressionProduct& product) {
  const std::vector<double> to_go = costs_to_go(product);
  const auto each_step = [&](std::uint32_t at, const auto& visit) {
    for (const ProgressionProduct::Choice& c : product.choices[at])
      if (std::isfinite(to_go[c.outcomes[0].first])) visit(c.outcomes[0].first);
  };
  std::vector<std::size_t> steps_into(product.goal.size(), 0);
  std::size_t left = 0;
  for (std::uint32_t at = 0; at < product.goal.size(); ++at) {
    if (std::isinf(to_go[at])) continue;
    ++left;
    each_step(at, [&](std::uint32_t to) { ++steps_into[to]; });
  }
  if (left == 0) return 0;
  if (steps_into[0] > 0) return INFINITY;
  std::vector<double> walks(product.goal.size(), 0);
  walks[0] = 1;
  double found = 0;
  for (std::vector<std::uint32_t> open{0}; !open.empty(); --left) {
    const std::uint32_t at = open.back();
    open.pop_back();
    if (product.goal[at]) found += walks[at];
    each_step(at, [&](std::uint32_t to) {
      walks[to] += walks[at];
      if (--steps_into[to] == 0) open.push_back(to);
    });
  }
  return left == 0 ? found : INFINITY;
}

std::optional<bool> has_finite_word(ltl::Formula formula, const ltl::Limits& limits) {
  Remainders remainders(ltl::Semantics::Finite);
  std::vector<ltl::Formula> met{formula};
  std::unordered_set<ltl::Formula> known;  // the empty word is none: the formula counts once it is come back to
  try {
    for (std::size_t at = 0; at < met.size(); ++at) {
      if (met.size() > limits.states || limits.stop.stop_requested()) return std::nullopt;
      for (const ltl::Letter& letter : letters_of(met[at])) {
        const ltl::Formula rest = remainders.after(met[at], letter);
        if (remainders.settles(rest)) return true;
        if (known.insert(rest).second) met.push_back(rest);
      }
    }
  } catch (const GaveUpOnPairs&) {
    return std::nullopt;
  }
  return false;
}

std::optional<double> count_walks(const ProgressionProduct& product, double below, std::size_t most) {
  const std::vector<double> to_go = costs_to_go(product);
  const double limit = below - 1e-9 * std::max(1.0, below);
  std::map<CostAt, double> open{{{0, 0}, 1}};  // walks, by cost and end
  double found = 0;
  for (std::size_t entries = 0; !open.empty(); ++entries) {
    if (entries > most) return std::nullopt;
    const auto [at, walks] = *open.begin();
    open.erase(open.begin());
    const auto [cost, pair] = at;
    if (!(cost + to_go[pair] < limit)) continue;
    if (product.goal[pair]) found += walks;
    for (const ProgressionProduct::Choice& c : product.choices[pair]) {
      if (c.cost == 0) return std::nullopt;
      open[{cost + c.cost, c.outcomes[0].first}] += walks;
    }
  }
  return found;
}

}  // namespace waymark::tools

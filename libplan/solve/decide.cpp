// A strategy must make progress: among choices that are worth the same, one that never arrives must not be taken. So it
// is read off backwards from the targets: a state joins by a choice that is worth its value and has an outcome that has
// attracted before. What counts as the same action value is made no wider than it takes for every state to be
// attracted.
#include "libplan/solve/decide.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <deque>
#include <span>
#include <stdexcept>
#include <utility>

#include "libplan/solve/end_components.hpp"
#include "libplan/solve/least_steps.hpp"
#include "libplan/solve/reachability.hpp"
#include "libplan/solve/value_iteration.hpp"

namespace waymark::plan {
namespace {

template <class Product>
StateSet goals(const Product& product, std::size_t threads) {
  StateSet out(product.states());
  for_each_state(product, threads, [&](const auto& s) { out.set(s.index, product.is_goal(s)); });
  return out;
}

// Does the choice take a marked edge and stay in its end component?
template <class Product>
bool meets_mark(const Product& product, const typename Product::State& s, std::uint32_t k,
                const EndComponents& components) {
  bool mark = false;
  product.for_each_outcome(s, k, [&](std::uint32_t, double, bool marked) { mark = mark || marked; });
  return mark && stays(product, s, k, components);
}

// What is winning once it is reached: goals, and end components in which a marked edge can be met for ever.
template <class Product>
struct WinningRegion {
  explicit WinningRegion(const Product& product, std::size_t threads = 1) : states(goals(product, threads)) {
    if (!product.has_marks()) return;
    StateSet open(product.states());
    for_each_state(product, threads, [&](const auto& s) { open.set(s.index, !states[s.index]); });
    components = end_components(
        product, open, [](const auto&, std::uint32_t) { return true; }, threads);
    StateSet accepting(components.count);
    for_each_state(product, threads, [&](const auto& s) {
      const std::uint32_t c = components.of[s.index];
      for (std::uint32_t k = 0; c != EndComponents::none && k < product.choices(s) && !accepting[c]; ++k)
        if (meets_mark(product, s, k, components)) accepting.join(c);
    });
    for (std::uint32_t i = 0; i < product.states(); ++i)
      if (components.of[i] != EndComponents::none && accepting[components.of[i]]) states.insert(i);
  }
  StateSet states;
  EndComponents components;
};

// Backwards from `from`, nearest first: a state joins by that choice among the `good` ones which most likely leads to
// what was attracted before it. (Some chance would do for arriving in the end; against the drift it may take for ever.)
// `order`: the states in the order in which they join.
template <class Product, class Good>
StateSet attractor(const Product& product, const StateSet& from, Strategy& strategy, const Good& good,
                   SweepOrder<std::uint32_t>* order = nullptr) {
  StateSet attracted = from;
  std::deque<typename Product::Compact> queue;  // of those whose predecessors have not been looked at
  product.for_each_state([&](const auto& s) {
    if (from[s.index]) queue.push_back(product.compact(s));
  });
  const auto look_at = [&](const typename Product::State& s) {
    double best = 0;
    for (std::uint32_t k = 0; k < product.choices(s); ++k) {
      double nearer = 0;
      product.for_each_outcome(s, k, [&](std::uint32_t t, double p, bool) {
        if (t != Product::trap && attracted[t]) nearer += p;
      });
      if (nearer <= best || !good(s, k)) continue;
      best = nearer;
      strategy.choice.set(s.index, k);
    }
    return best > 0;
  };
  for (std::size_t left = queue.size(); !queue.empty(); queue.pop_front(), --left) {
    if (left == 0) {  // a layer is done
      left = queue.size();
      if (order != nullptr) ++order->layers;
    }
    product.for_each_predecessor(product.state(queue.front()), [&](const auto& source) {
      if (attracted[source.index] || !look_at(source)) return;
      attracted.insert(source.index);
      if (order != nullptr) order->states.push_back(source.index);
      queue.push_back(product.compact(source));
    });
  }
  return attracted;
}

// Inside the end components that are winning: to a marked edge and through it, again and again.
template <class Product>
void play_for_ever(const Product& product, const WinningRegion<Product>& winning, Strategy& strategy,
                   std::size_t threads) {
  if (winning.components.count == 0) return;
  StateSet at_mark(product.states());
  for_each_state(product, threads, [&](const auto& s) {
    if (!winning.states[s.index] || product.is_goal(s)) return;
    for (std::uint32_t k = 0; k < product.choices(s) && !at_mark[s.index]; ++k)
      at_mark.set(s.index, meets_mark(product, s, k, winning.components));
  });
  product.for_each_state([&](const auto& s) {
    for (std::uint32_t k = 0; at_mark[s.index]; ++k)
      if (meets_mark(product, s, k, winning.components)) return strategy.choice.set(s.index, k);
  });
  attractor(product, at_mark, strategy, [&](const auto& s, std::uint32_t k) {
    return winning.states[s.index] && stays(product, s, k, winning.components);
  });
}

template <Measure measure, class Product>
double action_value(const Product& product, const typename Product::State& s, std::uint32_t k, const Unknowns& unknowns,
                    std::span<const double> values) {
  double sum = measure == Measure::MinCost ? product.cost(s, k) : 0;
  product.for_each_outcome(s, k, [&](std::uint32_t t, double p, bool) {
    if (t != Product::trap && (measure == Measure::MaxProbability || unknowns.unknown[t] || unknowns.targets[t]))
      sum += p * values[t];
    else if (measure == Measure::MinCost)
      sum = INFINITY;
  });
  return sum;
}

enum class Among : std::uint8_t { Nearest, Swiftest };  // which of the good choices

// The choices of the unknown states: worth their value but for a little slack, and making progress. False: there are
// states from which no such choice does.
template <Measure measure, class Product>
bool choose(const Product& product, const Unknowns& unknowns, std::span<const double> values, Among among, double slack,
            const IterationOptions& limits, Strategy& strategy) {
  const auto good = [&](const auto& s, std::uint32_t k) {
    if (!unknowns.unknown[s.index]) return false;
    const double value = values[s.index], offered = action_value<measure>(product, s, k, unknowns, values);
    return measure == Measure::MaxProbability ? offered >= value * (1 - slack) : offered <= value * (1 + slack);
  };
  SweepOrder<std::uint32_t> order;
  const StateSet attracted =
      attractor(product, unknowns.targets, strategy, good, among == Among::Swiftest ? &order : nullptr);
  for (std::uint32_t i = 0; i < product.states(); ++i)
    if (unknowns.unknown[i] && !attracted[i]) return false;
  return among == Among::Nearest || hurry(product, order, good, limits, strategy);
}

template <class Product, class Value>
std::uint32_t first_of_best(const Product& product, const Value& value, bool least) {
  std::uint32_t best = product.starts().front();
  for (std::uint32_t i : product.starts())
    if (least ? value(i).lower < value(best).lower : value(i).lower > value(best).lower) best = i;
  return best;
}

// Between which unknown states one moves at will (probabilities), or at will and for nothing (costs).
template <Measure measure, class Product>
EndComponents merged(const Product& product, const StateSet& unknown, std::size_t threads) {
  const auto moves = [&](const auto& s, std::uint32_t k) {
    return measure == Measure::MaxProbability || product.cost(s, k) == 0;
  };
  std::atomic<bool> any{false};
  for_each_state(product, threads, [&](const auto& s) {
    const std::uint32_t choices = unknown[s.index] && !any.load(std::memory_order_relaxed) ? product.choices(s) : 0;
    for (std::uint32_t k = 0; k < choices; ++k)
      if (moves(s, k)) any.store(true, std::memory_order_relaxed);
  });
  return any ? end_components(product, unknown, moves, threads) : EndComponents{};
}

// But for what is to be merged.
template <Measure measure, class Product>
Unknowns unknowns_in(const Product& product, const StateSet& targets, std::size_t threads) {
  Reaching from = reaching(product, targets, threads);
  Unknowns out;
  out.targets = measure == Measure::MaxProbability ? from.sure : targets;
  out.unknown = std::move(measure == Measure::MaxProbability ? from.some : from.sure);
  out.unknown -= out.targets;
  return out;
}

template <Measure measure, class Product>
Unknowns unknowns_of(const Product& product, const StateSet& targets, std::size_t threads) {
  Unknowns out = unknowns_in<measure>(product, targets, threads);
  out.merged = merged<measure>(product, out.unknown, threads);
  if (out.merged.count == 0) out.merged.of = std::vector<std::uint32_t>();
  return out;
}

// What the strategy is worth, from its start. Nothing is merged: from what is unknown of a chain it leaves by itself.
// `kept`: the entries of the product, its starts among them. `claimed`: values of the best strategy, to begin with.
template <Measure measure, class Product>
std::optional<Bounds> evaluate(const Product& product, const Strategy& strategy, const StateSet& kept,
                               const IterationOptions& options, std::span<const double> claimed = {}) {
  using Chain = StrategyChain<Product>;
  const Chain chain(product, strategy);
  const std::size_t threads = options.sweepers.free();
  const Unknowns unknowns = unknowns_in<measure>(chain, WinningRegion<Chain>(chain, threads).states, threads);
  const std::uint32_t start = strategy.start;
  if (measure == Measure::MinCost && !unknowns.unknown[start] && !unknowns.targets[start])
    return Bounds{INFINITY, INFINITY};
  const auto values = ValueIteration<Chain, measure>(chain, unknowns, options, {.bounds = &kept}, claimed).run();
  if (!values) return std::nullopt;
  return Bounds{values->bounds.lower(start), values->bounds.upper(start)};
}

// Does the strategy deliver what was claimed, up to the tolerance?
template <Measure measure>
bool delivers(const Decided& decided, double tolerance) {
  const Bounds& claimed = decided.value;
  const Bounds& found = decided.re_evaluated;
  return measure == Measure::MaxProbability ? found.lower >= claimed.lower - tolerance
                                            : found.upper <= claimed.upper + tolerance * std::max(1.0, claimed.upper);
}

// What a strategy attains bounds the value too.
template <Measure measure>
void tighten(Decided& decided) {
  if (measure == Measure::MaxProbability)
    decided.value.lower = std::max(decided.value.lower, std::min(decided.re_evaluated.lower, decided.value.upper));
  else
    decided.value.upper = std::min(decided.value.upper, std::max(decided.re_evaluated.upper, decided.value.lower));
}

// The strategy of the unknown states: by the bounds that some choice of every state attains. Slack costs at most so
// much in every step, but with too little of it the only way on may be one that drift makes endless: so it is a
// strategy that was evaluated and found good that counts. A good one is evaluated in about as many sweeps as the values
// took; those that take many more are looked at again when there is no such.
template <Measure measure, class Product>
bool choose_and_evaluate(const Product& product, const Unknowns& unknowns, std::span<const double> attained,
                         const StateSet& kept, const IterationOptions& limits, bool last, Decided& out) {
  IterationOptions limited = limits;
  constexpr std::uint64_t most_sweeps = 20'000;
  const std::uint64_t few_sweeps = std::min(most_sweeps, 1'000 + 4 * out.sweeps);
  Strategy tried = out.strategy;
  constexpr std::pair<Among, double> attempts[] = {
      {Among::Nearest, 1e-10}, {Among::Swiftest, 1e-10}, {Among::Swiftest, 1e-12}, {Among::Swiftest, 1e-8},
      {Among::Nearest, 1e-12}, {Among::Nearest, 1e-14},  {Among::Nearest, 1e-15},  {Among::Nearest, 1e-8},
      {Among::Nearest, 1e-7},  {Among::Nearest, 1e-6},   {Among::Nearest, 1e-5}};
  const auto succeeds = [&](Among among, double slack) {
    if (!choose<measure>(product, unknowns, attained, among, slack, limits, tried)) return false;
    const auto found = evaluate<measure>(product, tried, kept, limited, attained);
    if (!found) return false;
    const bool better = measure == Measure::MaxProbability ? found->lower > out.re_evaluated.lower
                                                           : found->upper < out.re_evaluated.upper;
    if (!better) return false;
    out.re_evaluated = *found;
    out.strategy = tried;
    if (!delivers<measure>(out, limits.tolerance)) return false;
    tighten<measure>(out);
    out.attained = true;
    return true;
  };
  for (limited.sweeps = few_sweeps;; limited.sweeps = most_sweeps) {
    limited.second_way = limited.sweeps == most_sweeps;
    for (const auto& [among, slack] : std::span(attempts).first(last ? std::size(attempts) : 2))
      if (!limits.stop.stop_requested() && succeeds(among, slack)) return true;
    if (limited.sweeps == most_sweeps || limits.stop.stop_requested()) return false;
  }
}

// Are bounds of a cost, this great, safe without a strategy that attains them? Where every step costs something, a run
// has at most value/least of them, and what a sweep rounds in each, a share of 1e-15, is less than a tenth of the
// tolerance in all.
template <class Product>
bool needs_no_strategy(const Product& product, const StateSet& unknown, double value, double tolerance) {
  double least = INFINITY;
  product.for_each_state([&](const auto& s) {
    const std::uint32_t choices = unknown[s.index] ? product.choices(s) : 0;
    for (std::uint32_t k = 0; k < choices; ++k) least = std::min(least, product.cost(s, k));
  });
  return value < 1e14 * tolerance * least;
}

// Where bounds of the tolerance that was asked for do not meet in doubles, coarser ones may; but not where it was time
// or a count of sweeps that ended.
constexpr double coarsest = 1e-2;
bool may_go_on(const IterationOptions& limits) { return !limits.stop.stop_requested() && limits.sweeps == UINT64_MAX; }

template <Measure measure, class Product>
std::optional<Decided> decide(const Product& product, const WinningRegion<Product>& winning,
                              const IterationOptions& asked) {
  const Unknowns unknowns = unknowns_of<measure>(product, winning.states, asked.sweepers.free());
  const StateSet kept = entries(product, unknowns.unknown, product.starts(), asked.sweepers.free());
  IterationOptions limits = asked;
  bool attained = asked.strategy || asked.keep_values || measure != Measure::MinCost;  // by state
  const auto run = [&] {
    return ValueIteration<Product, measure>(product, unknowns, limits, {.bounds = &kept, .attained = attained}).run();
  };
  auto values = run();
  for (; !values && limits.tolerance < coarsest && may_go_on(limits); values = run()) limits.tolerance *= 10;
  if (!values) return std::nullopt;
  Decided out;
  out.tolerance = limits.tolerance;
  out.sweeps = values->sweeps;
  if (attained) out.strategy.choice = Choices(product.states());
  const auto value = [&](std::uint32_t i) {
    const bool never = measure == Measure::MinCost && !unknowns.unknown[i] && !unknowns.targets[i];
    return never ? Bounds{INFINITY, INFINITY} : Bounds{values->bounds.lower(i), values->bounds.upper(i)};
  };
  out.strategy.start = first_of_best(product, value, measure != Measure::MaxProbability);
  out.value = value(out.strategy.start);
  if (std::isinf(out.value.lower)) {
    out.re_evaluated = out.value;
    return out;
  }
  if (!attained) {
    if (needs_no_strategy(product, unknowns.unknown, out.value.upper, limits.tolerance)) {
      out.re_evaluated = out.value;
      return out;
    }
    attained = true;
    out.strategy.choice = Choices(product.states());
    values = run();
    if (!values) return std::nullopt;
  }
  play_for_ever(product, winning, out.strategy, limits.sweepers.free());
  if (measure == Measure::MaxProbability)  // almost surely: to what is winning, never leaving what is sure
    attractor(product, winning.states, out.strategy,
              [&](const auto& s, std::uint32_t k) { return all_outcomes_in(product, s, k, unknowns.targets); });
  // What any strategy is worth, until one is evaluated.
  out.attained = false;
  out.re_evaluated = is_probability(measure) ? Bounds{-1, out.value.upper} : Bounds{out.value.lower, INFINITY};
  if (!choose_and_evaluate<measure>(product, unknowns, values->attained, kept, limits, false, out)) {
    // Values that are not final slope the wrong way where they are all but equal.
    IterationOptions finer = limits;
    finer.tolerance = std::max(1e-12, limits.tolerance * 1e-4);
    auto final = ValueIteration<Product, measure>(product, unknowns, finer, {.bounds = &kept, .attained = true}).run();
    if (final) values = std::move(final);
    if (!choose_and_evaluate<measure>(product, unknowns, values->attained, kept, limits, true, out) &&
        limits.stop.stop_requested())
      return std::nullopt;
    out.re_evaluated.lower = std::max(0.0, out.re_evaluated.lower);
  }
  if (limits.keep_values) out.values.assign(values->attained.begin(), values->attained.end());
  return out;
}

}  // namespace

template <class Model>
Qualitative qualitative(const ProductMdp<Model>& product) {
  const StateSet winning = WinningRegion<ProductMdp<Model>>(product).states;
  const auto [some, sure] = reaching(product, winning);
  const auto any = [&](const StateSet& set) {
    return std::any_of(product.starts().begin(), product.starts().end(), [&](std::uint32_t i) { return set[i]; });
  };
  return any(sure) ? Qualitative::Sure : any(some) ? Qualitative::Some : Qualitative::None;
}

template <class Model>
std::optional<Decided> greatest_probability(const ProductMdp<Model>& product, const IterationOptions& limits) {
  if (product.starts().empty()) return Decided{};
  return decide<Measure::MaxProbability>(product, WinningRegion<ProductMdp<Model>>(product, limits.sweepers.free()),
                                         limits);
}

template <class Model>
std::optional<Decided> least_cost(const ProductMdp<Model>& product, const IterationOptions& limits) {
  if (product.starts().empty()) return Decided{{INFINITY, INFINITY}, {}, {INFINITY, INFINITY}, 0, {}};
  return decide<Measure::MinCost>(product, WinningRegion<ProductMdp<Model>>(product, limits.sweepers.free()), limits);
}

template Qualitative qualitative(const ProductMdp<Mdp>&);
template Qualitative qualitative(const ProductMdp<GridWorld>&);
template std::optional<Decided> greatest_probability(const ProductMdp<Mdp>&, const IterationOptions&);
template std::optional<Decided> greatest_probability(const ProductMdp<GridWorld>&, const IterationOptions&);
template std::optional<Decided> least_cost(const ProductMdp<Mdp>&, const IterationOptions&);
template std::optional<Decided> least_cost(const ProductMdp<GridWorld>&, const IterationOptions&);

}  // namespace waymark::plan

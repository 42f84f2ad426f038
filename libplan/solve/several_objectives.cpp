#include "libplan/solve/several_objectives.hpp"

#include <cmath>
#include <cstdint>
#include <limits>
#include <stdexcept>

#include "libplan/solve/pareto_product.hpp"

namespace waymark::plan {
namespace {

struct BestStopped {};  // thrown

constexpr double rounding = 1e-9, infinite = std::numeric_limits<double>::infinity();

bool is_loss(const Objective& o) { return o.costs != nullptr && !o.greatest; }
double oriented(const Objective& o, double value) { return o.greatest ? value : -value; }  // more is better

// The product in which a run may also say that it earns objective `gain` for ever, in the states where it can without
// losing the other one: of that objective, and of the chance to say so.
ParetoProduct with_earning_for_ever(const ParetoProduct& from, const std::vector<Objective>& objectives,
                                    std::size_t gain) {
  const std::size_t other = 1 - gain;
  const Mdp& mdp = from.mdp;
  const auto states = static_cast<std::uint32_t>(mdp.states());
  const auto free = [&](std::uint32_t s, std::uint32_t k) {
    return !is_loss(objectives[other]) || from.rewards[other][from.first[s] + k] == 0;
  };
  const EndComponents components = end_components_of(mdp, free);
  std::vector<bool> earns(components.count, false);
  for (std::uint32_t s = 0; s < states; ++s)
    for (std::uint32_t k = 0; k < mdp.choices(s); ++k)
      if (from.rewards[gain][from.first[s] + k] > 0 && free(s, k) && !leaves(mdp, s, k, components))
        earns[components.of[s]] = true;
  MdpBuilder builder(ltl::Vocabulary({"goal 0", "goal 1"}));
  const auto letter = [&](LetterId of) {
    ltl::Letter out;
    if (mdp.letters()[of].contains(ltl::Proposition{static_cast<std::uint32_t>(other)}))
      out.insert(ltl::Proposition{0});
    return builder.letter(out);
  };
  ParetoProduct out;
  out.rewards.resize(2);
  out.origin = from.origin, out.memory = from.memory;
  out.complemented = {from.complemented[other], false};
  const auto choice = [&](std::string_view action, double of_other, double chance) {
    builder.add_choice(action, 0);
    out.rewards[0].push_back(of_other);
    out.rewards[1].push_back(chance);
  };
  for (std::uint32_t s = 0; s <= states; ++s) {
    builder.add_state();
    out.first.push_back(static_cast<std::uint32_t>(out.rewards[0].size()));
    for (std::uint32_t k = 0; s < states && k < mdp.choices(s); ++k) {
      choice(mdp.action(s, k), from.rewards[other][from.first[s] + k], 0);
      for (const ModelOutcome& o : mdp.outcomes(s, k)) builder.add_outcome(o.target, letter(o.letter), o.probability);
    }
    const bool here = s < states && components.of[s] != EndComponents::none && earns[components.of[s]];
    if (s < states && !here) continue;
    choice("for ever", 0, here ? 1 : 0);
    builder.add_outcome(states, builder.letter({}), 1);
  }
  out.origin.push_back(0);
  out.memory.emplace_back();
  const LetterId first = letter(mdp.initial_letter());
  out.mdp = std::move(builder).build(0, first);
  return out;
}

class Several {
 public:
  Several(const Mdp& model, const std::vector<BoundedObjective>& all, double precision, const std::stop_token& stop)
      : model_(model), all_(all), precision_(precision), stop_(stop) {}

  SeveralAnswer answer() {
    std::vector<const BoundedObjective*> asked;
    for (const BoundedObjective& o : all_)
      if (!o.bound) asked.push_back(&o);
    SeveralAnswer out;
    if (asked.size() == 2) {
      out.curve =
          curve(*pareto_product_of({all_[0].objective, all_[1].objective}), {all_[0].objective, all_[1].objective});
      return out;
    }
    const BoundedObjective& wanted = asked.empty() ? all_.back() : *asked[0];
    const BoundedObjective* other = all_.size() == 1 ? nullptr : &wanted == all_.data() ? &all_[1] : all_.data();
    const Best best = best_of(wanted.objective, other);
    out.curve = std::move(curve_);
    if (asked.empty()) {
      out.kind = SeveralAnswer::Kind::Truth;
      out.value = best.possible && best.value >= oriented(wanted.objective, *wanted.bound) - rounding ? 1 : 0;
    } else if (best.possible) {
      out.kind = SeveralAnswer::Kind::Value;
      out.value = oriented(wanted.objective, best.value);
    } else {
      out.kind = SeveralAnswer::Kind::Infeasible;
    }
    return out;
  }

 private:
  struct Best {  // of what meets the bound
    bool possible = false;
    double value = 0;  // more is better; of a cost that is infinite −∞
  };

  std::optional<ParetoProduct> pareto_product_of(const std::vector<Objective>& objectives) const {
    auto out = pareto_product(model_, objectives, {.states = 10'000'000, .stop = stop_});
    if (!out) throw BestStopped{};
    return out;
  }
  std::vector<ParetoPoint> curve(const ParetoProduct& product, const std::vector<Objective>& objectives) const {
    auto out = pareto(product, objectives, precision_, stop_);
    if (!out) throw BestStopped{};
    return std::move(out->points);
  }

  // The greatest of objective 0 where objective 1 meets the bound, on the segments between points.
  static Best along(const std::vector<ParetoPoint>& points, const std::vector<Objective>& objectives,
                    std::optional<double> bound) {
    Best out;
    const auto offer = [&](double value) {
      out.value = out.possible ? std::max(out.value, value) : value;
      out.possible = true;
    };
    const auto at = [&](const ParetoPoint& p, std::size_t i) { return oriented(objectives[i], p.values[i]); };
    for (const ParetoPoint& a : points) {
      if (!bound || at(a, 1) >= *bound - rounding) offer(at(a, 0));
      for (const ParetoPoint& b : points) {
        if (!bound || at(a, 1) >= *bound || at(b, 1) < *bound) continue;
        const double share = (*bound - at(a, 1)) / (at(b, 1) - at(a, 1));
        offer(at(a, 0) + share * (at(b, 0) - at(a, 0)));
      }
    }
    return out;
  }

  // The greatest chance to earn objective `gain` for ever, where the other one is finite and meets the bound, if any.
  Best chance(const ParetoProduct& product, const std::vector<Objective>& objectives, std::size_t gain,
              std::optional<double> bound) const {
    const std::vector<Objective> pair{objectives[1 - gain], {"", &model_, true}};
    std::vector<ParetoPoint> points = curve(with_earning_for_ever(product, objectives, gain), pair);
    for (ParetoPoint& p : points) std::swap(p.values[0], p.values[1]);
    return along(points, {pair[1], pair[0]}, bound);
  }

  Best best_of(const Objective& wanted, const BoundedObjective* other) {
    std::vector<Objective> objectives{wanted};
    if (other != nullptr) objectives.push_back(other->objective);
    const ParetoProduct product = *pareto_product_of(objectives);
    const auto bound = other == nullptr ? std::nullopt : std::optional(oriented(other->objective, *other->bound));
    if (other != nullptr && earns_for_ever(product, objectives, 1)) return under_an_endless_gain(product, objectives);
    if (earns_for_ever(product, objectives, 0)) return endless_gain(product, objectives, bound);
    curve_ = curve(product, objectives);
    const Best finite = along(curve_, objectives, bound);
    if (finite.possible || !is_loss(wanted)) return finite;
    if (other == nullptr) return {true, -infinite};
    std::vector<ParetoPoint> before = std::move(curve_);
    const Best at_any_cost = best_of(other->objective, nullptr);
    curve_ = std::move(before);
    return {at_any_cost.possible && at_any_cost.value >= *bound - rounding, -infinite};
  }

  static Best endless_gain_refused() { throw std::invalid_argument("a reward that is to be great may be infinite"); }

  Best endless_gain(const ParetoProduct& product, const std::vector<Objective>& objectives,
                    std::optional<double> bound) const {
    if (!bound) return {true, infinite};
    const Best found = chance(product, objectives, 0, bound);
    if (!found.possible) return found;
    return found.value > rounding ? Best{true, infinite} : endless_gain_refused();
  }

  // The bound is on a gain: any chance to earn for ever, however small, meets it.
  Best under_an_endless_gain(const ParetoProduct& product, const std::vector<Objective>& objectives) {
    const Best alone = best_of(objectives[0], nullptr);
    if (std::isinf(alone.value)) return alone;
    const Best found = chance(product, objectives, 1, std::nullopt);
    return found.possible && found.value > rounding ? alone : endless_gain_refused();
  }

  const Mdp& model_;
  const std::vector<BoundedObjective>& all_;
  double precision_;
  const std::stop_token& stop_;
  std::vector<ParetoPoint> curve_;
};

}  // namespace

std::optional<SeveralAnswer> several_objectives(const Mdp& model, const std::vector<BoundedObjective>& objectives,
                                                double precision, const std::stop_token& stop) {
  if (objectives.empty() || objectives.size() > 2) throw std::invalid_argument("one objective or two");
  try {
    return Several(model, objectives, precision, stop).answer();
  } catch (const BestStopped&) {
    return std::nullopt;
  }
}

}  // namespace waymark::plan

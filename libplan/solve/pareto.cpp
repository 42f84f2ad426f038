#include "libplan/solve/pareto.hpp"

#include <Eigen/SparseLU>
#include <algorithm>
#include <cmath>
#include <deque>
#include <memory>
#include <stdexcept>

#include "libplan/solve/case_task.hpp"
#include "libplan/solve/pareto_product.hpp"

namespace waymark::plan {
namespace {

using ObjectiveValues = std::vector<double>;        // by objective; more is better
using QuotientPolicy = std::vector<std::uint32_t>;  // by state of the quotient

struct Stopped {};  // thrown

struct WeightedBest {  // for some weights
  ObjectiveValues values;
  QuotientPolicy policy;
};

class WeightedSolver {
 public:
  WeightedSolver(const ParetoProduct& product, const EndingQuotient& quotient, const std::vector<Objective>& objectives,
                 double precision, const std::stop_token& stop)
      : product_(product), quotient_(quotient), objectives_(objectives), precision_(precision), stop_(stop) {
    number_.assign(quotient.choices.size(), UINT32_MAX);
    for (std::uint32_t i = 0; i < quotient.choices.size(); ++i)
      if (!quotient.choices[i].empty()) {
        number_[i] = static_cast<std::uint32_t>(kept_.size());
        kept_.push_back(i);
      }
  }

  Pareto solve() {
    std::vector<WeightedBest> found;
    if (objectives_.size() == 1) {
      found.push_back(best({1}));
    } else {
      const WeightedBest right = best({1, 0}), up = best({0, 1});
      found = {right, up};
      between(right, up, found);
    }
    for (const WeightedBest& candidate : found)
      if (std::none_of(found.begin(), found.end(), [&](const WeightedBest& o) { return better(o, candidate); }) &&
          std::none_of(out_.points.begin(), out_.points.end(),
                       [&](const ParetoPoint& p) { return same(p, candidate); }))
        out_.points.push_back(point(candidate));
    std::sort(out_.points.begin(), out_.points.end(),
              [](const ParetoPoint& a, const ParetoPoint& b) { return a.values < b.values; });
    return std::move(out_);
  }

 private:
  double small(double a) const { return precision_ * std::max(1.0, std::abs(a)); }
  bool better(const WeightedBest& a, const WeightedBest& b) const {  // in one objective, and not worse in the other
    bool more = false;
    for (std::size_t i = 0; i < a.values.size(); ++i) {
      if (a.values[i] < b.values[i] - small(b.values[i])) return false;
      more = more || a.values[i] > b.values[i] + small(b.values[i]);
    }
    return more;
  }
  bool same(const ParetoPoint& p, const WeightedBest& f) const {
    for (std::size_t i = 0; i < f.values.size(); ++i)
      if (std::abs(p.values[i] - shown(f.values[i], i)) > small(p.values[i])) return false;
    return true;
  }
  double shown(double value, std::size_t i) const {
    const bool negative = objectives_[i].greatest == product_.complemented[i];
    const double sum = (negative ? -value : value) + (begins_decided(i) ? 1 : 0);
    return product_.complemented[i] ? 1 - sum : sum;
  }
  bool begins_decided(std::size_t i) const {
    return product_.mdp.letters()[product_.mdp.initial_letter()].contains(
        ltl::Proposition{static_cast<std::uint32_t>(i)});
  }

  void between(const WeightedBest& p, const WeightedBest& q, std::vector<WeightedBest>& all) {
    const double right = p.values[0] - q.values[0], up = q.values[1] - p.values[1];
    if (right <= small(p.values[0]) || up <= small(q.values[1])) return;
    const ObjectiveValues weights{up / (right + up), right / (right + up)};
    WeightedBest middle = best(weights);
    const auto along = [&](const WeightedBest& f) { return weights[0] * f.values[0] + weights[1] * f.values[1]; };
    if (along(middle) <= along(p) + small(along(p))) return;
    all.push_back(middle);
    between(p, middle, all);
    between(middle, q, all);
  }

  // ---- policy iteration: from a policy that ends, by strict improvements, all policies end [BT91, Prop. 2]

  double reward(const EndingQuotient::Choice& c, const ObjectiveValues& weights) const {
    if (c.ends) return 0;
    double sum = 0;
    for (std::size_t i = 0; i < weights.size(); ++i)
      sum += weights[i] * product_.rewards[i][product_.first[c.state] + c.choice];
    return sum;
  }

  WeightedBest best(const ObjectiveValues& weights) {
    ++out_.solutions;
    if (last_.empty()) last_ = quotient_.proper;
    for (;;) {
      if (stop_.stop_requested()) throw Stopped{};
      const Eigen::MatrixXd values = evaluate(last_);
      Eigen::VectorXd sum = Eigen::VectorXd::Zero(values.rows());
      for (std::size_t i = 0; i < weights.size(); ++i) sum += weights[i] * values.col(static_cast<Eigen::Index>(i));
      if (!improve(sum, weights)) {
        WeightedBest out{{}, last_};
        for (std::size_t i = 0; i < weights.size(); ++i)
          out.values.push_back(values(number_[quotient_.start], static_cast<Eigen::Index>(i)));
        return out;
      }
    }
  }

  // By kept state and objective: what the policy earns until it ends.
  Eigen::MatrixXd evaluate(const QuotientPolicy& policy) const {
    const auto n = static_cast<Eigen::Index>(kept_.size());
    const auto k = static_cast<Eigen::Index>(objectives_.size());
    std::vector<Eigen::Triplet<double>> entries;
    Eigen::MatrixXd right = Eigen::MatrixXd::Zero(n, k);
    for (Eigen::Index i = 0; i < n; ++i) {
      const std::uint32_t state = kept_[static_cast<std::size_t>(i)];
      const EndingQuotient::Choice& c = quotient_.choices[state][policy[state]];
      entries.emplace_back(i, i, 1);
      for (const auto& [target, p] : c.outcomes) entries.emplace_back(i, number_[target], -p);
      for (Eigen::Index o = 0; o < k && !c.ends; ++o)
        right(i, o) = product_.rewards[static_cast<std::size_t>(o)][product_.first[c.state] + c.choice];
    }
    Eigen::SparseMatrix<double> matrix(n, n);
    matrix.setFromTriplets(entries.begin(), entries.end());
    Eigen::SparseLU<Eigen::SparseMatrix<double>> factors;
    factors.compute(matrix);
    if (factors.info() != Eigen::Success) throw Stopped{};
    return factors.solve(right);
  }

  bool improve(const Eigen::VectorXd& values, const ObjectiveValues& weights) {
    bool changed = false;
    for (const std::uint32_t state : kept_) {
      const double now = values[number_[state]];
      double most = now + 1e-11 * std::max(1.0, std::abs(now));
      for (std::uint32_t k = 0; k < quotient_.choices[state].size(); ++k) {
        const EndingQuotient::Choice& c = quotient_.choices[state][k];
        double sum = reward(c, weights);
        for (const auto& [target, p] : c.outcomes) sum += p * values[number_[target]];
        if (sum <= most) continue;
        most = sum;
        last_[state] = k;
        changed = true;
      }
    }
    return changed;
  }

  // ---- the strategy of a policy, and its Markov chain

  bool stays_free(std::uint32_t s, std::uint32_t k) const {
    for (const ObjectiveValues& rewards : product_.rewards)
      if (rewards[product_.first[s] + k] != 0) return false;
    return !leaves(product_.mdp, s, k, quotient_.free);
  }

  // By state of the product. Within an end component: towards the state that leaves it, or about.
  std::vector<std::uint32_t> strategy(const QuotientPolicy& policy) const {
    const auto states = static_cast<std::uint32_t>(product_.mdp.states());
    std::vector<std::uint32_t> out(states, UINT32_MAX);
    for (std::uint32_t s = 0; s < states; ++s) {
      const std::uint32_t at = quotient_.of[s];
      if (quotient_.choices[at].empty()) continue;
      const EndingQuotient::Choice& c = quotient_.choices[at][policy[at]];
      if (!c.ends && c.state == s) out[s] = c.choice;
      if (!c.ends) continue;
      for (std::uint32_t k = 0; k < product_.mdp.choices(s) && out[s] == UINT32_MAX; ++k)
        if (stays_free(s, k)) out[s] = k;
    }
    for (bool more = true; more;) {
      more = false;
      for (std::uint32_t s = 0; s < states; ++s)
        for (std::uint32_t k = 0; k < product_.mdp.choices(s) && out[s] == UINT32_MAX; ++k) {
          if (quotient_.free.of[s] == EndComponents::none || !stays_free(s, k)) continue;
          for (const ModelOutcome& o : product_.mdp.outcomes(s, k))
            if (out[o.target] != UINT32_MAX) out[s] = k, more = true;
        }
    }
    return out;
  }

  ParetoPoint point(const WeightedBest& found) const {
    ParetoPoint out;
    const std::vector<std::uint32_t> choice = strategy(found.policy);
    std::vector<std::uint32_t> number(product_.mdp.states(), UINT32_MAX), met{0};
    number[0] = 0;
    for (std::uint32_t i = 0; i < met.size(); ++i) {
      const std::uint32_t s = met[i];
      out.decisions.push_back({product_.origin[s], std::string(product_.mdp.action(s, choice[s])), product_.memory[s]});
      for (const ModelOutcome& o : product_.mdp.outcomes(s, choice[s]))
        if (number[o.target] == UINT32_MAX) {
          number[o.target] = static_cast<std::uint32_t>(met.size());
          met.push_back(o.target);
        }
    }
    for (std::size_t i = 0; i < objectives_.size(); ++i) {
      out.values.push_back(shown(found.values[i], i));
      out.re_evaluated.push_back(re_evaluated(i, met, number, choice));
      const Bounds& again = out.re_evaluated.back();
      const double slack = 1e-5 * std::max(1.0, std::abs(again.upper));
      if (out.values[i] < again.lower - slack || out.values[i] > again.upper + slack)
        throw std::logic_error("a point of two objectives whose strategy does not attain it");
      out.values[i] = std::clamp(out.values[i], again.lower, again.upper);
    }
    return out;
  }

  // By the solvers of formulas and costs, on the chain alone.
  Bounds re_evaluated(std::size_t i, const std::vector<std::uint32_t>& met, const std::vector<std::uint32_t>& number,
                      const std::vector<std::uint32_t>& choice) const {
    const bool cost = objectives_[i].costs != nullptr;
    MdpBuilder builder(product_.mdp.letters().vocabulary());
    const auto copied = [&](LetterId letter) { return builder.letter(product_.mdp.letters()[letter]); };
    for (const std::uint32_t s : met) {
      builder.add_state();
      builder.add_choice("go", cost ? std::abs(product_.rewards[i][product_.first[s] + choice[s]]) : 0);
      for (const ModelOutcome& o : product_.mdp.outcomes(s, choice[s]))
        builder.add_outcome(number[o.target], copied(o.letter), o.probability);
    }
    const LetterId first = copied(product_.mdp.initial_letter());
    Mdp chain = std::move(builder).build(0, first);
    CaseTask task{"", "F \"goal " + std::to_string(i) + '"', CaseTask::Logic::Ltl, CaseTask::Query::MaxProbability};
    if (cost) {
      task = {"", "F \"free of costs\"", CaseTask::Logic::Ltl, CaseTask::Query::MinCost};
      chain = beginning_at(chain, 0, letters_of_states(chain), {{"free of costs", free_for_ever(chain)}});
    }
    const Bounds value =
        answer(PlanningCase{"", std::move(chain), {}}, task, {.tolerance = 1e-9, .explain = false, .stop = stop_})
            .value;
    return product_.complemented[i] ? Bounds{1 - value.upper, 1 - value.lower} : value;
  }

  const ParetoProduct& product_;
  const EndingQuotient& quotient_;
  const std::vector<Objective>& objectives_;
  double precision_;
  const std::stop_token& stop_;
  std::vector<std::uint32_t> kept_, number_;  // states of the quotient that can end; by state: among them
  QuotientPolicy last_;
  Pareto out_;
};

}  // namespace

std::optional<Pareto> pareto(const Mdp& model, const std::vector<Objective>& objectives, double precision,
                             const std::stop_token& stop) {
  if (objectives.empty() || objectives.size() > 2) throw std::invalid_argument("one objective or two");
  const auto product = pareto_product(model, objectives, {.states = 10'000'000, .stop = stop});
  if (!product) return std::nullopt;
  return pareto(*product, objectives, precision, stop);
}

std::optional<Pareto> pareto(const ParetoProduct& product, const std::vector<Objective>& objectives, double precision,
                             const std::stop_token& stop) {
  for (std::size_t i = 0; i < objectives.size(); ++i)
    if (earns_for_ever(product, objectives, i))
      throw std::invalid_argument("a reward that is to be great may be infinite");
  const EndingQuotient quotient = ending_quotient(product);
  if (quotient.choices[quotient.start].empty()) return Pareto{};
  try {
    return WeightedSolver(product, quotient, objectives, precision, stop).solve();
  } catch (const Stopped&) {
    return std::nullopt;
  }
}

}  // namespace waymark::plan

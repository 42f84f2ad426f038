#include "libplan/learn/policy_value.hpp"

#include <Eigen/SparseCore>
#include <Eigen/SparseLU>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <unordered_map>

namespace waymark::plan {
namespace {

bool is_path(const PolicyChain& chain) {
  for (std::size_t s = 0; s < chain.states(); ++s)
    if (chain.first[s + 1] - chain.first[s] > 1) return false;
  return true;
}

// {probability, probability · cost, value} of one start.
Eigen::Vector3d walk(const PolicyChain& chain, std::uint32_t s, double discount) {
  double cost = 0, value = 1 / discount;
  for (std::size_t steps = 0; steps <= chain.states(); ++steps) {
    if (chain.ending[s] == Ending::Accepting) return {1, cost, steps == 0 ? 1 : value};
    if (chain.first[s] == chain.first[s + 1]) return {0, 0, 0};
    cost += chain.cost[s];
    value *= discount;
    s = chain.outcomes[chain.first[s]].target;
  }
  return {0, 0, 0};  // round in a circle
}

// By state: can an accepting state be reached?
std::vector<bool> hopeful(const PolicyChain& chain) {
  std::vector<std::vector<std::uint32_t>> sources(chain.states());
  std::vector<std::uint32_t> todo;
  std::vector<bool> reaches(chain.states(), false);
  for (std::uint32_t s = 0; s < chain.states(); ++s) {
    for (std::uint32_t i = chain.first[s]; i < chain.first[s + 1]; ++i) sources[chain.outcomes[i].target].push_back(s);
    if (chain.ending[s] != Ending::Accepting) continue;
    reaches[s] = true;
    todo.push_back(s);
  }
  while (!todo.empty()) {
    const std::uint32_t s = todo.back();
    todo.pop_back();
    for (const std::uint32_t source : sources[s])
      if (!reaches[source]) {
        reaches[source] = true;
        todo.push_back(source);
      }
  }
  return reaches;
}

// The states to solve for, numbered, and the equations between them.
struct System {
  std::vector<Eigen::Index> row;  // by state, −1 for those that are not solved for
  Eigen::SparseMatrix<double> steps;
  Eigen::VectorXd accepting;  // the probability of accepting with the next step
  Eigen::VectorXd cost;
};

System system_of(const PolicyChain& chain) {
  System system;
  const std::vector<bool> reaches = hopeful(chain);
  Eigen::Index rows = 0;
  for (std::size_t s = 0; s < chain.states(); ++s)
    system.row.push_back(reaches[s] && chain.ending[s] == Ending::Open ? rows++ : -1);
  system.accepting = system.cost = Eigen::VectorXd::Zero(rows);
  std::vector<Eigen::Triplet<double>> entries;
  for (std::size_t s = 0; s < chain.states(); ++s) {
    const Eigen::Index row = system.row[s];
    if (row < 0) continue;
    system.cost[row] = chain.cost[s];
    for (std::uint32_t i = chain.first[s]; i < chain.first[s + 1]; ++i) {
      const auto& [target, probability] = chain.outcomes[i];
      if (chain.ending[target] == Ending::Accepting)
        system.accepting[row] += probability;
      else if (system.row[target] >= 0)
        entries.emplace_back(row, system.row[target], probability);
    }
  }
  system.steps.resize(rows, rows);
  system.steps.setFromTriplets(entries.begin(), entries.end());
  return system;
}

// Solves (I − scale · P) x = b for several b.
class Solver {
 public:
  Solver(const Eigen::SparseMatrix<double>& steps, double scale) {
    Eigen::SparseMatrix<double> identity(steps.rows(), steps.cols());
    identity.setIdentity();
    const Eigen::SparseMatrix<double> matrix = identity - scale * steps;
    lu_.compute(matrix);
    if (lu_.info() != Eigen::Success) throw std::logic_error("the equations of a Markov chain are singular");
  }
  Eigen::VectorXd operator()(const Eigen::VectorXd& b) const { return lu_.solve(b); }

 private:
  Eigen::SparseLU<Eigen::SparseMatrix<double>> lu_;
};

Eigen::Vector3d solve(const PolicyChain& chain, double discount) {
  const System system = system_of(chain);
  Eigen::VectorXd probability, cost, value;
  if (system.accepting.size() > 0) {
    const Solver undiscounted(system.steps, 1);
    probability = undiscounted(system.accepting);
    cost = undiscounted(system.cost.cwiseProduct(probability));
    value = discount == 1 ? probability : Solver(system.steps, discount)(system.accepting);
  }
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const auto& [s, weight] : chain.starts) {
    if (chain.ending[s] == Ending::Accepting) sum += weight * Eigen::Vector3d(1, 0, 1);
    if (const Eigen::Index row = system.row[s]; row >= 0)
      sum += weight * Eigen::Vector3d(probability[row], cost[row], value[row]);
  }
  return sum;
}

}  // namespace

PolicyValue value_of(const PolicyChain& chain, double discount) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  if (is_path(chain)) {
    for (const auto& [s, weight] : chain.starts) sum += weight * walk(chain, s, discount);
  } else {
    sum = solve(chain, discount);
  }
  return {sum[0], sum[0] > 0 ? sum[1] / sum[0] : std::numeric_limits<double>::infinity(), sum[2]};
}

PolicyChain chain_of(const TabularProduct& product, const ActionTable& policy) {
  PolicyChain chain;
  std::unordered_map<std::uint32_t, std::uint32_t> number;
  std::vector<std::uint32_t> met;
  const auto meet = [&](std::uint32_t state) {
    const auto [it, is_new] = number.try_emplace(state, static_cast<std::uint32_t>(met.size()));
    if (is_new) met.push_back(state);
    return it->second;
  };
  for (const TabularProduct::Start& start : product.starts)
    chain.starts.push_back({meet(start.state), start.probability});
  for (std::size_t i = 0; i < met.size(); ++i) {  // grows while we look
    const std::uint32_t state = met[i], position = product.position_of(state), q = product.task_of(state);
    const std::uint8_t action = policy[state];
    chain.ending.push_back(product.ending(state));
    chain.cost.push_back(0);
    if (chain.ending.back() == Ending::Open && action != no_action) {
      chain.cost.back() = product.cost[std::size_t{position} * product.actions + action];
      double before = 0;
      for (const TabularProduct::Outcome& o : product.outcomes_of(position, action)) {
        const std::uint32_t target = meet(product.state(o.position, product.task.after(q, o.letter)));
        chain.outcomes.push_back({target, o.up_to - before});
        before = o.up_to;
      }
    }
    chain.first.push_back(static_cast<std::uint32_t>(chain.outcomes.size()));
  }
  return chain;
}

}  // namespace waymark::plan

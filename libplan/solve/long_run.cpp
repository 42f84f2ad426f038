#include "libplan/solve/long_run.hpp"

#include <Eigen/SparseLU>
#include <stdexcept>

#include "libplan/solve/state_model.hpp"

namespace waymark::plan {
namespace {

using Matrix = Eigen::SparseMatrix<double>;

std::optional<Eigen::VectorXd> solution(const Matrix& matrix, const Eigen::VectorXd& right) {
  Eigen::SparseLU<Matrix> factors;
  factors.compute(matrix);
  if (factors.info() != Eigen::Success) return std::nullopt;
  Eigen::VectorXd out = factors.solve(right);
  if (factors.info() != Eigen::Success || !out.allFinite()) return std::nullopt;
  return out;
}

// The mean of the values over the stationary distribution of a component: π P = π, Σ π = 1. One of the first equations
// follows from the others.
std::optional<double> mean(const Mdp& chain, const std::vector<std::uint32_t>& members,
                           const std::vector<std::uint32_t>& place, const std::vector<double>& values) {
  const auto n = static_cast<Eigen::Index>(members.size());
  std::vector<Eigen::Triplet<double>> entries;
  for (Eigen::Index i = 0; i < n; ++i) {
    entries.emplace_back(n - 1, i, 1);
    if (i < n - 1) entries.emplace_back(i, i, -1);
    for (const ModelOutcome& o : chain.outcomes(members[static_cast<std::size_t>(i)], 0))
      if (const auto row = static_cast<Eigen::Index>(place[o.target]); row < n - 1)
        entries.emplace_back(row, i, o.probability);
  }
  Matrix matrix(n, n);
  matrix.setFromTriplets(entries.begin(), entries.end());
  Eigen::VectorXd right = Eigen::VectorXd::Zero(n);
  right[n - 1] = 1;
  const auto found = solution(matrix, right);
  if (!found) return std::nullopt;
  double out = 0;
  for (Eigen::Index i = 0; i < n; ++i) out += (*found)[i] * values[members[static_cast<std::size_t>(i)]];
  return out;
}

}  // namespace

std::optional<std::vector<double>> long_run(const Mdp& chain, const std::vector<double>& values,
                                            const std::stop_token& stop) {
  const auto states = static_cast<std::uint32_t>(chain.states());
  for (std::uint32_t s = 0; s < states; ++s)
    if (chain.choices(s) != 1) throw std::invalid_argument("the long run of a decision process");
  const EndComponents components = end_components_of(chain);  // bottom ones: there is no choice
  std::vector<std::vector<std::uint32_t>> members(components.count);
  std::vector<std::uint32_t> place(states, 0), others;
  for (std::uint32_t s = 0; s < states; ++s) {
    auto& group = components.of[s] == EndComponents::none ? others : members[components.of[s]];
    place[s] = static_cast<std::uint32_t>(group.size());
    group.push_back(s);
  }
  std::vector<double> out(states, 0);
  for (const std::vector<std::uint32_t>& component : members) {
    if (stop.stop_requested()) return std::nullopt;
    const auto found = mean(chain, component, place, values);
    if (!found) return std::nullopt;
    for (const std::uint32_t s : component) out[s] = *found;
  }
  if (others.empty()) return out;
  const auto n = static_cast<Eigen::Index>(others.size());
  std::vector<Eigen::Triplet<double>> entries;
  Eigen::VectorXd right = Eigen::VectorXd::Zero(n);
  for (Eigen::Index i = 0; i < n; ++i) {
    entries.emplace_back(i, i, 1);
    for (const ModelOutcome& o : chain.outcomes(others[static_cast<std::size_t>(i)], 0)) {
      if (components.of[o.target] == EndComponents::none)
        entries.emplace_back(i, static_cast<Eigen::Index>(place[o.target]), -o.probability);
      else
        right[i] += o.probability * out[o.target];
    }
  }
  Matrix matrix(n, n);
  matrix.setFromTriplets(entries.begin(), entries.end());
  const auto found = solution(matrix, right);
  if (!found) return std::nullopt;
  for (Eigen::Index i = 0; i < n; ++i) out[others[static_cast<std::size_t>(i)]] = (*found)[i];
  return out;
}

}  // namespace waymark::plan

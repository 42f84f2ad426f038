// `discounted` beside inexact policy iteration over PETSc, written apart [GLZL23]: policies are evaluated by GMRES on
// (I − γ P_π) v = r_π, and improved until no choice is better.
#include <gtest/gtest.h>
#include <petscksp.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <string>
#include <variant>
#include <vector>

#include "libltl/structure/random.hpp"
#include "libltl/text/parse.hpp"
#include "libplan/product/product_mdp.hpp"
#include "libplan/solve/discounted.hpp"
#include "libplan/solve/task_automaton.hpp"
#include "tests/libplan/solve/random_models.hpp"

namespace waymark::plan {
namespace {

using Product = ProductMdp<Mdp>;

void check(PetscErrorCode code) {
  if (code != 0) throw std::runtime_error("PETSc: error " + std::to_string(code));
}

class PetscEnvironment : public ::testing::Environment {
 public:
  void SetUp() override {
    static std::string name = "test", no_file = "-skip_petscrc", no_signals = "-no_signal_handler";
    static std::array<char*, 4> arguments{name.data(), no_file.data(), no_signals.data(), nullptr};
    int count = 3;
    char** given = arguments.data();
    check(PetscInitialize(&count, &given, nullptr, nullptr));
  }
  void TearDown() override { PetscFinalize(); }
};
const auto* const environment = ::testing::AddGlobalTestEnvironment(new PetscEnvironment);

// Rewards of 1 on entering a goal; goals and the trap end a run.
class PolicyIteration {
 public:
  PolicyIteration(const Product& product, double discount)
      : product_(product), discount_(discount), policy_(product.states(), 0), values_(product.states(), 0) {}

  std::vector<double> run() {
    for (double residual = 1; residual > 1e-14;) {
      evaluate(residual * 1e-3);
      residual = improve();
    }
    return values_;
  }

 private:
  template <class Visit>
  double outcomes(const Product::State& s, std::uint32_t k, const Visit& visit) const {
    double reward = 0;
    product_.for_each_outcome(s, k, [&](std::uint32_t t, double p, bool) {
      if (t == Product::trap) return;
      if (product_.is_goal(product_.state(t)))
        reward += p;
      else
        visit(t, p);
    });
    return reward;
  }

  // Up to a residual: what makes policy iteration inexact.
  void evaluate(double residual) {
    const auto n = static_cast<PetscInt>(product_.states());
    Mat matrix = nullptr;
    Vec right = nullptr, values = nullptr;
    check(MatCreateSeqAIJ(PETSC_COMM_SELF, n, n, 16, nullptr, &matrix));
    check(MatSetOption(matrix, MAT_NEW_NONZERO_ALLOCATION_ERR, PETSC_FALSE));
    check(MatCreateVecs(matrix, &values, &right));
    product_.for_each_state([&](const Product::State& s) {
      const auto row = static_cast<PetscInt>(s.index);
      check(MatSetValue(matrix, row, row, 1, ADD_VALUES));
      check(VecSetValue(values, row, values_[s.index], INSERT_VALUES));
      double reward = 0;
      if (product_.choices(s) > 0)
        reward = outcomes(s, policy_[s.index], [&](std::uint32_t t, double p) {
          check(MatSetValue(matrix, row, static_cast<PetscInt>(t), -discount_ * p, ADD_VALUES));
        });
      check(VecSetValue(right, row, reward, INSERT_VALUES));
    });
    check(MatAssemblyBegin(matrix, MAT_FINAL_ASSEMBLY));
    check(MatAssemblyEnd(matrix, MAT_FINAL_ASSEMBLY));
    for (Vec vector : {values, right}) {
      check(VecAssemblyBegin(vector));
      check(VecAssemblyEnd(vector));
    }
    KSP solver = nullptr;
    check(KSPCreate(PETSC_COMM_SELF, &solver));
    check(KSPSetOperators(solver, matrix, matrix));
    check(KSPSetType(solver, KSPGMRES));
    check(KSPSetInitialGuessNonzero(solver, PETSC_TRUE));
    check(KSPSetTolerances(solver, 1e-16, residual, PETSC_DEFAULT, 10'000));
    check(KSPSolve(solver, right, values));
    const double* found = nullptr;
    check(VecGetArrayRead(values, &found));
    values_.assign(found, found + n);
    check(VecRestoreArrayRead(values, &found));
    check(KSPDestroy(&solver));
    check(VecDestroy(&right));
    check(VecDestroy(&values));
    check(MatDestroy(&matrix));
  }

  // The greedy policy; returns the greatest difference that one step of the optimality operator makes.
  double improve() {
    double residual = 0;
    product_.for_each_state([&](const Product::State& s) {
      double best = product_.choices(s) > 0 ? -1 : 0;
      for (std::uint32_t k = 0; k < product_.choices(s); ++k) {
        double later = 0;
        const double reward = outcomes(s, k, [&](std::uint32_t t, double p) { later += p * values_[t]; });
        const double value = reward + discount_ * later;
        if (value <= best + 1e-15) continue;
        best = value;
        policy_[s.index] = k;
      }
      residual = std::max(residual, std::abs(best - values_[s.index]));
    });
    return residual;
  }

  const Product& product_;
  double discount_;
  std::vector<std::uint32_t> policy_;
  std::vector<double> values_;
};

TEST(Discounted, AgreesWithPolicyIterationOverPetsc) {
  ltl::Random random(20);
  for (int i = 0; i < 400; ++i) {
    const Mdp mdp = testing::random_model(random, {.states = i % 4 == 3 ? 400U : 6U});
    ltl::Arena arena(testing::vocabulary_ab());
    const char* const text = std::array{"F a", "F (a & X b)", "(!a) U b", "F (a & X F b)"}[random.below(4)];
    const auto automaton =
        task_automaton(ltl::parse(text, arena), CaseTask::Logic::Ltl, CaseTask::Query::Discounted, {});
    const TaskTable task(std::get<automata::Dfa>(*automaton), mdp.letters());
    const auto product = Product::explore(mdp, task);
    ASSERT_TRUE(product);
    if (product->starts().empty() || product->is_goal(product->state(product->starts().front()))) continue;
    const double discount = std::array{0.5, 0.9, 0.99}[random.below(3)];
    const auto found = greatest_discounted(*product, discount, {.tolerance = 1e-11});
    ASSERT_TRUE(found);
    const double expected = PolicyIteration(*product, discount).run()[product->starts().front()];
    EXPECT_NEAR(found->value.middle(), expected, 1e-9) << text << ", discount " << discount << ", model " << i << "\n"
                                                       << (mdp.states() < 10 ? testing::show(mdp) : "");
  }
}

}  // namespace
}  // namespace waymark::plan

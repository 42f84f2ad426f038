#include "libplan/learn/hierarchical.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <unordered_map>

#include "libplan/learn/environment.hpp"

namespace waymark::plan {
namespace {

constexpr double not_offered = -std::numeric_limits<double>::infinity();

// By option and letter: does the option end with it? One for each proposition that some letter carries; where the task
// reads none, a single one that ends with every letter.
std::vector<std::vector<bool>> options_of(const TaskRows& task) {
  std::vector<std::vector<bool>> options;
  for (std::uint32_t p = 0; p < task.vocabulary.size(); ++p) {
    std::vector<bool> ends;
    for (const ltl::Letter& letter : task.carried) ends.push_back(letter.contains(ltl::Proposition{p}));
    if (std::find(ends.begin(), ends.end(), true) != ends.end()) options.push_back(std::move(ends));
  }
  if (options.empty()) options.emplace_back(task.letters, true);
  return options;
}

class Table {  // of values, with the number of updates of each
 public:
  Table(std::size_t rows, std::size_t columns, double decay)
      : columns_(columns), decay_(decay), values_(rows * columns, 1), counts_(rows * columns, 0) {}
  void forbid(std::size_t row, std::size_t column) { values_[row * columns_ + column] = not_offered; }
  double best(std::size_t row) const { return *std::max_element(begin(row), begin(row + 1)); }
  std::uint32_t best_column(std::size_t row) const {
    return static_cast<std::uint32_t>(std::max_element(begin(row), begin(row + 1)) - begin(row));
  }
  void update(std::size_t row, std::size_t column, double target) {
    double& value = values_[row * columns_ + column];
    value += std::pow(++counts_[row * columns_ + column], -decay_) * (target - value);
  }

 private:
  std::vector<double>::const_iterator begin(std::size_t row) const {
    return values_.begin() + static_cast<std::ptrdiff_t>(row * columns_);
  }
  std::size_t columns_;
  double decay_;
  std::vector<double> values_;
  std::vector<std::uint32_t> counts_;
};

class Learner {
 public:
  Learner(const TabularProduct& product, const Hierarchical& method, const Training& training)
      : product_(product),
        method_(method),
        training_(training),
        options_(options_of(product.task)),
        random_(training.seed),
        environment_(product, training.horizon, random_),
        controller_(product.states(), options_.size(), decay()),
        walks_(options_.size(), Table(product.positions, product.actions, decay())) {
    for (std::uint32_t position = 0; position < product.positions; ++position)
      for (std::uint32_t a = 0; a < product.actions; ++a)
        if (!product.is_offered(position, a))
          for (Table& walk : walks_) walk.forbid(position, a);
  }

  LearningCurve run() {
    begin_option(0);
    take_steps(
        training_, [&](std::size_t step) { act(step); }, [&](std::size_t step) { checkpoint(step); });
    return std::move(curve_);
  }

 private:
  double decay() const { return method_.decay.value_or(product_.is_deterministic() ? 0 : 0.77); }

  void begin_option(std::size_t step) {
    begun_at_ = environment_.state();
    age_ = 0;
    option_ = random_.chance(training_.epsilon(step))
                  ? static_cast<std::uint32_t>(random_.below(options_.size()))
                  : controller_.best_column(begun_at_);
  }

  void act(std::size_t step) {
    const std::uint32_t state = environment_.state(), position = product_.position_of(state);
    const std::uint32_t action = random_.chance(training_.epsilon(step))
                                     ? environment_.random_action()
                                     : walks_[option_].best_column(position);
    const Environment::Step taken = environment_.step(action);
    for (std::size_t o = 0; o < options_.size(); ++o) {
      const double target =
          options_[o][taken.letter] ? 1 : training_.discount * walks_[o].best(taken.position);
      walks_[o].update(position, action, target);
    }
    curve_.updates += options_.size();
    ++age_;
    const bool moved_on = product_.task_of(taken.state) != product_.task_of(state);
    if (!moved_on && !options_[option_][taken.letter] && age_ < method_.patience && !taken.is_last()) return;
    end_option(taken);
    if (taken.is_last()) {
      ++curve_.episodes;
      environment_.reset();
    }
    begin_option(step);
  }

  void end_option(const Environment::Step& taken) {
    const double discount = std::pow(training_.discount, age_ - 1);
    double target = 0;
    switch (taken.ending) {
      case Ending::Accepting: target = discount; break;
      case Ending::Trap: break;
      case Ending::Open: target = discount * training_.discount * controller_.best(taken.state); break;
    }
    controller_.update(begun_at_, option_, target);
    ++curve_.updates;
  }

  void checkpoint(std::size_t step) {
    curve_.checkpoints.push_back({step, value_of(chain(), training_.discount)});
  }

  // The chain over (state, option) that greedy choices on both levels leave.
  PolicyChain chain() const {
    PolicyChain chain;
    std::unordered_map<std::uint64_t, std::uint32_t> number;
    std::vector<std::pair<std::uint32_t, std::uint32_t>> met;  // state, option
    const auto meet = [&](std::uint32_t state, std::uint32_t option) {
      const auto [it, is_new] = number.try_emplace(std::uint64_t{state} * options_.size() + option,
                                                   static_cast<std::uint32_t>(met.size()));
      if (is_new) met.emplace_back(state, option);
      return it->second;
    };
    for (const TabularProduct::Start& start : product_.starts)
      chain.starts.push_back({meet(start.state, controller_.best_column(start.state)), start.probability});
    for (std::size_t i = 0; i < met.size(); ++i) {  // grows while we look
      const auto [state, option] = met[i];
      const std::uint32_t position = product_.position_of(state), q = product_.task_of(state);
      chain.ending.push_back(product_.ending(state));
      chain.cost.push_back(0);
      if (chain.ending.back() == Ending::Open) {
        const std::uint32_t action = walks_[option].best_column(position);
        chain.cost.back() = product_.cost[std::size_t{position} * product_.actions + action];
        double before = 0;
        for (const TabularProduct::Outcome& o : product_.outcomes_of(position, action)) {
          const std::uint32_t next = product_.state(o.position, product_.task.after(q, o.letter));
          const bool ends = options_[option][o.letter] || product_.task_of(next) != q;
          chain.outcomes.push_back(
              {meet(next, ends ? controller_.best_column(next) : option), o.up_to - before});
          before = o.up_to;
        }
      }
      chain.first.push_back(static_cast<std::uint32_t>(chain.outcomes.size()));
    }
    return chain;
  }

  const TabularProduct& product_;
  const Hierarchical& method_;
  const Training& training_;
  std::vector<std::vector<bool>> options_;
  ltl::Random random_;
  Environment environment_;
  Table controller_;          // by state and option
  std::vector<Table> walks_;  // by option; by position and action
  std::uint32_t begun_at_ = 0, option_ = 0;
  std::size_t age_ = 0;  // of the option, in steps
  LearningCurve curve_;
};

}  // namespace

LearningCurve learn(const TabularProduct& product, const Hierarchical& method, const Training& training) {
  if (product.is_over()) throw std::invalid_argument("the task is over where it begins");
  return Learner(product, method, training).run();
}

}  // namespace waymark::plan

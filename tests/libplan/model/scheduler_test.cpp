// Schedulers of PRISM and Storm: what was written is read again, and has the value that the solver found.
#include "libplan/model/formats/scheduler.hpp"

#include <gtest/gtest.h>

#include <random>

#include "libltl/diagnostic.hpp"
#include "libplan/solve/case_task.hpp"
#include "tests/libplan/model/models.hpp"

namespace waymark::plan {
namespace {

// A choice for some of the states, drawn or not.
Scheduler random_scheduler(const Mdp& model, bool draws, std::mt19937& random) {
  Scheduler out;
  out.choices.resize(model.states());
  for (std::uint32_t s = 0; s < model.states(); ++s) {
    if (model.choices(s) == 0 || random() % 5 == 0) continue;
    if (draws && model.choices(s) > 1 && random() % 2 == 0)
      out.choices[s] = {{1, 0.25}, {0, 0.75}};
    else
      out.choices[s] = {{static_cast<std::uint32_t>(random() % model.choices(s)), 1}};
  }
  return out;
}

void expect_same(const Scheduler& a, const Scheduler& b, const std::string& text) {
  ASSERT_EQ(a.choices.size(), b.choices.size());
  for (std::size_t s = 0; s < a.choices.size(); ++s) {
    ASSERT_EQ(a.choices[s].size(), b.choices[s].size()) << "state " << s << " of\n" << text;
    for (std::size_t i = 0; i < a.choices[s].size(); ++i) {
      EXPECT_EQ(a.choices[s][i].choice, b.choices[s][i].choice) << "state " << s << " of\n" << text;
      EXPECT_EQ(a.choices[s][i].probability, b.choices[s][i].probability) << "state " << s << " of\n" << text;
    }
  }
}

TEST(Scheduler, WhatIsWrittenIsReadAgain) {
  std::mt19937 random(3);
  for (int i = 0; i < 300; ++i) {
    const Mdp model = test::random_mdp(random);
    const Scheduler drawn = random_scheduler(model, true, random), fixed = random_scheduler(model, false, random);
    const std::string storm = write_scheduler(drawn, SchedulerFormat::Storm, model),
                      prism = write_scheduler(fixed, SchedulerFormat::Prism, model);
    expect_same(parse_scheduler(storm, "s.json", model), drawn, storm);
    expect_same(parse_scheduler(prism, "s.txt", model), fixed, prism);
    if (HasFailure()) return;
  }
}

CaseAnswer solve(const Mdp& model, CaseTask::Query query, bool strategy = false) {
  return answer({"", model, {}}, {.id = "", .formula = "F b", .query = query},
                {.tolerance = 1e-9, .explain = false, .strategy = strategy});
}

// The best strategy of F b needs no memory; its chain has the value that was proved, and no chain has a greater one.
TEST(Scheduler, HasTheValueOfItsMarkovChain) {
  using Query = CaseTask::Query;
  std::mt19937 random(4);
  int found = 0, chains = 0;
  for (int i = 0; i < 300; ++i) {
    const Mdp model = test::random_mdp(random);
    const CaseAnswer best = solve(model, Query::MaxProbability, true);
    if (best.status != CaseAnswer::Status::Solved) continue;
    ++found;
    if (found == 1) {
      EXPECT_FALSE(solve(model, Query::MaxProbability).strategy.has_value()) << "it was not asked for";
    }
    Scheduler scheduler;
    scheduler.choices.resize(model.states());
    for (const Decision& d : best.strategy->decisions) {
      auto& chosen = scheduler.choices[d.state];
      if (!chosen.empty()) {
        ASSERT_EQ(chosen.front().choice, d.choice) << "trial " << i;
      }
      chosen = {{d.choice, 1}};
    }
    const CaseAnswer chain = solve(induced(model, scheduler), Query::MaxProbability);
    ASSERT_NEAR(chain.value.middle(), best.value.middle(), 1e-8) << "trial " << i;
    const Mdp other = induced(model, random_scheduler(model, true, random));
    EXPECT_LE(solve(other, Query::MaxProbability).value.middle(), best.value.upper + 1e-9) << "trial " << i;
    bool ends = false;  // where a run ends, no formula holds, and the least probability is another
    for (std::uint32_t s = 0; s < other.states(); ++s) ends = ends || other.choices(s) == 0;
    if (ends) continue;
    ++chains;
    EXPECT_NEAR(solve(other, Query::MaxProbability).value.middle(), solve(other, Query::MinProbability).value.middle(),
                1e-8)
        << "trial " << i;
  }
  EXPECT_GT(found, 100);
  EXPECT_GT(chains, 10);
}

Mdp corridor() {  // 0 "here": left into 1 or right into 1 and 0; 1 "(1,2)": stays
  MdpBuilder builder{ltl::Vocabulary({"a"})};
  const LetterId none = builder.letter({}), a = builder.letter({{0}});
  builder.add_state("here");
  builder.add_choice("left", 2);
  builder.add_outcome(1, a);
  builder.add_choice("right", 4);
  builder.add_outcome(0, none, 0.5);
  builder.add_outcome(1, a, 0.5);
  builder.add_state("(1,2)");
  builder.add_choice("stay");
  builder.add_outcome(1, a);
  return std::move(builder).build(0, none);
}

TEST(Scheduler, ReadsWhatPrismAndStormWrite) {
  const Mdp model = corridor();
  for (const char* text :
       {"0=right\n(1,2)=stay\n", "0:right\r\n1:stay", "0=1\n1=0\n", "# a note\n here = right\n1=?\n"})
    EXPECT_EQ(parse_scheduler(text, "", model).choices.at(0).at(0).choice, 1U) << text;
  const Scheduler drawn = parse_scheduler(
      R"([{"s": 0, "c": [{"index": 0, "prob": "1/2", "labels": ["left"]}, {"index": 1, "prob": 0.5}]},
          {"s": 1, "c": "undefined"}])",
      "", model);
  const Mdp chain = induced(model, drawn);
  EXPECT_EQ(chain.choices(0), 1U);
  EXPECT_EQ(chain.choices(1), 1U);  // the only one that there is
  EXPECT_EQ(chain.cost(0, 0), 3);
  ASSERT_EQ(chain.outcome_count(0, 0), 2U);
  EXPECT_EQ(chain.outcome(0, 0, 0).target, 0U);
  EXPECT_EQ(chain.outcome(0, 0, 0).probability, 0.25);
  EXPECT_EQ(chain.outcome(0, 0, 1).probability, 0.75);
  EXPECT_EQ(induced(model, parse_scheduler("1=stay", "", model)).choices(0), 0U);
  EXPECT_THROW(write_scheduler(drawn, SchedulerFormat::Prism, model), std::invalid_argument);
}

TEST(Scheduler, ErrorsNameThePlace) {
  const Mdp model = corridor();
  struct Row {
    const char *text, *message;
    std::size_t line;
  };
  const Row table[] = {
      {"0=left\n0=left", "a second choice for state 0", 2},
      {"0=left\n7=left", "no state '7'", 2},
      {"0=up", "no choice 'up'", 1},
      {"\n0", "expected STATE=ACTION", 2},
      {"0 {1}=left", "has memory", 1},
      {"[{\"s\": 9, \"c\": []}]", "no such state", 1},
      {"[{\"s\": 0, \"c\": [{\"index\": 2, \"prob\": 1}]}]", "no choice of state 0", 1},
      {"[{\"s\": 0, \"c\": [\n{\"index\": 0, \"prob\": 2}]}]", "expected a probability", 2},
      {"[{\"s\": 0, \"c\": [{\"index\": 0, \"prob\": 0.5}]}]", "do not add up", 1},
      {"[{\"s\": 0, \"m\": 1, \"c\": []}]", "has memory", 1},
      {"[{\"s\": {\"x\": 1}, \"c\": []}]", "expected the number of a state", 1},
  };
  for (const Row& row : table) {
    try {
      parse_scheduler(row.text, "s", model);
      ADD_FAILURE() << row.text << " was read";
    } catch (const ltl::FormatError& error) {
      EXPECT_NE(std::string(error.what()).find(row.message), std::string::npos) << error.what();
      EXPECT_EQ(error.line(), row.line) << error.what();
    }
  }
}

}  // namespace
}  // namespace waymark::plan

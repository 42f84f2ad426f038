// The fewest conjuncts to drop, against all sets of them.
#include "libplan/solve/drop_conjuncts.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "libltl/structure/random.hpp"
#include "libltl/text/parse.hpp"
#include "libplan/model/mdp.hpp"

namespace waymark::plan {
namespace {

// F p0 & F p1 & …, of which sets are possible that include none of the conflicts.
class Conjuncts {
 public:
  Conjuncts(std::size_t size, std::vector<std::uint32_t> conflicts) : conflicts_(std::move(conflicts)) {
    for (std::size_t i = 0; i < size; ++i) parts_.push_back(ltl::parse("F p" + std::to_string(i), arena_));
  }
  ltl::Formula all() { return ltl::conjunction(arena_, parts_); }
  std::uint32_t set_of(const std::vector<ltl::Formula>& formulas) const {
    std::uint32_t set = 0;
    for (ltl::Formula f : formulas)
      set |= std::uint32_t{1} << (std::find(parts_.begin(), parts_.end(), f) - parts_.begin());
    return set;
  }
  bool is_possible(std::uint32_t set) const {
    return std::none_of(conflicts_.begin(), conflicts_.end(),
                        [&](std::uint32_t conflict) { return (conflict & ~set) == 0; });
  }
  Violation violation(std::size_t& asked) {
    return fewest_dropped(all(), [&](ltl::Formula f) {
      ++asked;
      if (f.op() == ltl::Op::And) return is_possible(set_of({f.operands().begin(), f.operands().end()}));
      return is_possible(f.op() == ltl::Op::True ? 0 : set_of({f}));
    });
  }

 private:
  ltl::Arena arena_;
  std::vector<ltl::Formula> parts_;
  std::vector<std::uint32_t> conflicts_;
};

TEST(DropConjuncts, DropsTheFewestAndNamesASmallestConflict) {
  ltl::Random random(31);
  std::size_t several = 0;
  for (int i = 0; i < 300; ++i) {
    const std::size_t size = 2 + random.below(5);
    const std::uint32_t everything = (1U << size) - 1;
    std::vector<std::uint32_t> conflicts;
    for (std::size_t k = 1 + random.below(4); k > 0; --k)
      conflicts.push_back(1 + static_cast<std::uint32_t>(random.below(everything)));
    Conjuncts conjuncts(size, conflicts);
    std::size_t asked = 0;
    const Violation found = conjuncts.violation(asked);

    const std::uint32_t conflict = conjuncts.set_of(found.conflict);
    EXPECT_FALSE(conjuncts.is_possible(conflict));
    for (std::size_t p = 0; p < size; ++p) {
      if (((conflict >> p) & 1U) != 0) {
        EXPECT_TRUE(conjuncts.is_possible(conflict & ~(1U << p))) << "one less can";
      }
    }

    int fewest = static_cast<int>(size);
    for (std::uint32_t dropped = 0; dropped < everything; ++dropped)
      if (conjuncts.is_possible(everything & ~dropped)) fewest = std::min(fewest, std::popcount(dropped));
    const std::uint32_t dropped = conjuncts.set_of(found.dropped);
    EXPECT_EQ(std::popcount(dropped), fewest == static_cast<int>(size) ? 0 : fewest);
    EXPECT_TRUE(dropped == 0 || conjuncts.is_possible(everything & ~dropped));
    several += fewest > 1 && dropped != 0 ? 1 : 0;
  }
  EXPECT_GT(several, 50U);
}

TEST(DropConjuncts, OneConjunctIsTheConflictItself) {
  Conjuncts one(1, {1});
  std::size_t asked = 0;
  const Violation found = one.violation(asked);
  EXPECT_EQ(one.set_of(found.conflict), 1U);
  EXPECT_TRUE(found.dropped.empty());
  EXPECT_EQ(asked, 0U) << "that it is impossible is known";
}

// All pairs are conflicts, so all but one of twelve are dropped, which the first 512 sets do not show.
TEST(DropConjuncts, DropsOneAfterTheOtherWhereSetsAreTooMany) {
  std::vector<std::uint32_t> pairs;
  for (std::uint32_t p = 0; p < 12; ++p)
    for (std::uint32_t q = 0; q < p; ++q) pairs.push_back(1U << p | 1U << q);
  Conjuncts conjuncts(12, pairs);
  std::size_t asked = 0;
  const Violation found = conjuncts.violation(asked);
  EXPECT_EQ(found.conflict.size(), 2U);
  EXPECT_EQ(found.dropped.size(), 11U);
  EXPECT_GE(asked, most_sets);
  EXPECT_LE(asked, most_sets + 12 + std::size_t{11} * 13);
}

// Each of four conjuncts is in the way of two others. Sets of one, two and three are 298, and the four come as the
// 214th set of four: the last that is asked about. One after the other, more are dropped.
TEST(DropConjuncts, TheLastSetThatIsAskedAboutCounts) {
  static_assert(most_sets == 298 + 214);
  const std::uint32_t four = 1U << 1U | 1U << 3U | 1U << 5U | 1U << 11U;
  Conjuncts conjuncts(12, {1U << 1U | 1U << 0U, 1U << 1U | 1U << 2U, 1U << 3U | 1U << 4U, 1U << 3U | 1U << 6U,
                           1U << 5U | 1U << 7U, 1U << 5U | 1U << 8U, 1U << 11U | 1U << 9U, 1U << 11U | 1U << 10U});
  std::size_t asked = 0;
  EXPECT_EQ(conjuncts.set_of(conjuncts.violation(asked).dropped), four);
}

TEST(DropConjuncts, ConflictsAreListedInWords) {
  ltl::Arena arena;
  const auto conflict = [&](std::initializer_list<const char*> texts) {
    Violation out;
    for (const char* text : texts) out.conflict.push_back(ltl::parse(text, arena));
    return out;
  };
  EXPECT_EQ(in_words(conflict({"F a"}), false), "no strategy has a chance to satisfy F a");
  EXPECT_EQ(in_words(conflict({"F a", "G b"}), true), "no strategy is sure to satisfy F a and G b together");
  EXPECT_EQ(in_words(conflict({"F a", "G b", "F c", "X d"}), false),
            "no strategy has a chance to satisfy F a, G b, F c and X d together");
}

TEST(DropConjuncts, WhatIsSeenOnAnyMoveIsSeen) {
  const ltl::Vocabulary names({"a", "b", "c", "e"});
  MdpBuilder builder(names);
  const LetterId a = builder.letter({ltl::Proposition{0}}), none = builder.letter({}),
                 b = builder.letter({ltl::Proposition{1}}), c = builder.letter({ltl::Proposition{2}}),
                 e = builder.letter({ltl::Proposition{3}});
  builder.add_state();
  builder.add_choice("on");
  builder.add_outcome(1, a);
  builder.add_choice("stay");
  builder.add_outcome(0, e);
  builder.add_state();
  builder.add_choice("back");
  builder.add_outcome(0, none);
  builder.add_state();  // nothing leads here
  builder.add_choice("stay");
  builder.add_outcome(2, c);
  const Mdp model = std::move(builder).build(0, b);
  ltl::Arena arena;
  const std::vector<ltl::Formula> formulas{ltl::parse("F c & F a", arena), ltl::parse("F b & F (d | c) & F e", arena)};
  EXPECT_EQ(never_seen(model, formulas), (std::vector<std::string>{"c", "d"}));
}

}  // namespace
}  // namespace waymark::plan

// The matcher of whole formulas: its features, its scores against the definition in the header, learning, its file.
#include "libparser/lifted/formula_matcher.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <sstream>

#include "libltl/diagnostic.hpp"
#include "libparser/lifted/learn_matcher.hpp"
#include "libparser/lifted/matching_features.hpp"

namespace waymark::parser {
namespace {

LiftedText text_of(const std::string& words) {
  LiftedText out;
  std::istringstream in(words);
  for (std::string word; in >> word; out.tokens.push_back(word))
    if (word[0] == '#') out.scope.slots = std::max(out.scope.slots, static_cast<std::size_t>(word[1] - '0'));
  return out;
}

std::vector<LiftedExample> some_examples() {
  std::vector<LiftedExample> out;
  for (const auto& [words, lifted] : std::initializer_list<std::pair<const char*, const char*>>{
           {"go to #1", "eventually #1"},
           {"walk to #1", "eventually #1"},
           {"never go to #1", "never #1 end"},
           {"keep off #1", "never #1 end"},
           {"go to #1 then to #2", "sequence #1 #2 end"},
           {"walk to #1 and then go to #2", "sequence #1 #2 end"},
           {"before #1 go to #2", "sequence #2 #1 end"},
           {"go to #1 and to #2", "visit #1 #2 end"}})
    out.push_back({text_of(words), parse_lifted(lifted)});
  return out;
}

MatcherTraining small() {
  return {.width = 12,
          .seed = 2,
          .draws = 4000,
          .batch = 8,
          .rate = 1e-2,
          .feature_dropout = 0,
          .dropout = 0,
          .smoothing = 0,
          .least_texts = 1};
}

TEST(MatchingFeatures, AreSetsThatTellTextsApart) {
  const auto a = matching_features(text_of("go to #1 then #2")), b = matching_features(text_of("go to #2 then #1"));
  EXPECT_TRUE(std::is_sorted(a.begin(), a.end()));
  EXPECT_EQ(std::set(a.begin(), a.end()).size(), a.size());
  EXPECT_NE(a, b);
  EXPECT_EQ(a, matching_features(text_of("go to #1 then #2")));
}

// A formula with its slots exchanged shares the kind and no order; the features of symbols count each occurrence.
TEST(MatchingFeatures, OfFormulasShareKindsButNotOrders) {
  const auto a = matching_features(parse_lifted("sequence #1 #2 end")),
             b = matching_features(parse_lifted("sequence #2 #1 end"));
  std::vector<std::uint64_t> shared;
  const std::set<std::uint64_t> first(a.begin(), a.end()), second(b.begin(), b.end());
  std::set_intersection(first.begin(), first.end(), second.begin(), second.end(), std::back_inserter(shared));
  EXPECT_GE(shared.size(), 4U);  // kind, number, two symbols and more
  EXPECT_LT(shared.size(), first.size());
  const auto twice = matching_features(parse_lifted("or #1 not #1 end"));
  const auto once = matching_features(parse_lifted("or #1 not #2 end"));
  EXPECT_EQ(twice.size(), once.size());
}

TEST(FormulaMatcher, LearnsItsExamplesAndWhatSharesTheirParts) {
  const auto examples = some_examples();
  const auto matcher = learn_matcher(examples, small());
  for (const LiftedExample& e : examples) {
    const auto matches = matcher->best(matcher->encode(e.text), e.text.scope, 3);
    ASSERT_FALSE(matches.best.empty());
    EXPECT_EQ(*matches.best.front().lifted, e.lifted) << print(*matches.best.front().lifted);
  }
  const LiftedText unseen = text_of("walk to #1 then walk to #2");
  EXPECT_EQ(print(*matcher->best(matcher->encode(unseen), unseen.scope, 1).best.front().lifted), "sequence #1 #2 end");
}

TEST(FormulaMatcher, ProbabilitiesAreASoftmaxOfScoresOverWhatTheScopeAllows) {
  const auto matcher = learn_matcher(some_examples(), small());
  const LiftedText text = text_of("go to #1");
  const neural::Vector encoded = matcher->encode(text);
  EXPECT_EQ(encoded(encoded.size() - 1), 1);
  const auto matches = matcher->best(encoded, text.scope, 100);
  double sum = 0;
  for (const auto& match : matches.best) {
    EXPECT_LE(needed_scope(*match.lifted).slots, 1U);
    EXPECT_NEAR(match.log_probability, matcher->score(encoded, *match.lifted) - matches.log_total, 1e-4);
    sum += std::exp(match.log_probability);
  }
  EXPECT_NEAR(sum, 1, 1e-6);
  EXPECT_EQ(matches.best.size(), 2U);  // of one slot: once, never
}

TEST(FormulaMatcher, TheSameSeedTheSameBytesAndTheFileGivesItBack) {
  const auto bytes_of = [](const FormulaMatcher& matcher) {
    WeightsWriter out({});
    matcher.write(out);
    return out.finish();
  };
  const auto one = learn_matcher(some_examples(), small()), other = learn_matcher(some_examples(), small());
  const std::string bytes = bytes_of(*one);
  EXPECT_EQ(bytes, bytes_of(*other));
  const auto file = std::make_shared<const MappedFile>(std::string_view(bytes));
  WeightsReader in(file, "here");
  const FormulaMatcher read = FormulaMatcher::read(in, file);
  EXPECT_EQ(bytes_of(read), bytes);
  const LiftedText text = text_of("keep off #1");
  EXPECT_EQ(read.score(read.encode(text), parse_lifted("never #1 end")),
            one->score(one->encode(text), parse_lifted("never #1 end")));
}

TEST(FormulaMatcher, FilesThatAreNoneAreRefused) {
  const neural::Matrix columns = neural::Matrix::Ones(3, 2);
  const FormulaMatcher towers_that_do_not_meet(FeatureTable({1, 2}, columns), FeatureTable({3, 4}, columns), {});
  WeightsWriter out({});
  towers_that_do_not_meet.write(out);
  const std::string bytes = out.finish();
  const auto file = std::make_shared<const MappedFile>(std::string_view(bytes));
  WeightsReader in(file, "here");
  EXPECT_THROW(FormulaMatcher::read(in, file), ltl::FormatError);
}

TEST(FormulaMatcher, NeedsExamples) { EXPECT_THROW(learn_matcher({}, small()), std::invalid_argument); }

// |a - q| ≤ scale / 2 for each entry: the highest entry of a column is 127 scales.
TEST(FeatureTable, EntriesAreRoundedToEightBits) {
  neural::Matrix columns(2, 2);
  columns << 1, 0, -0.5F, 0;
  const FeatureTable table({5, 9}, columns);
  neural::Vector sum = neural::Vector::Zero(2);
  EXPECT_EQ(table.add(std::vector<std::uint64_t>{5, 7, 9}, 2, sum), 2U);
  EXPECT_NEAR(sum(0), 2, 2.0 / 127);
  EXPECT_NEAR(sum(1), -1, 2.0 / 127);
}

}  // namespace
}  // namespace waymark::parser

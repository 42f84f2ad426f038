#include "libparser/model_file.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <memory>
#include <random>
#include <variant>

#include "libltl/diagnostic.hpp"
#include "libltl/text/xxhash.hpp"
#include "libparser/model/weights_bytes.hpp"

namespace waymark::parser {
namespace {

// A linear model and what ranks beside it, while they are made.
struct Parts {
  explicit Parts(const std::vector<std::string>& names)
      : linear(std::make_shared<LinearModel>(ltl::Vocabulary(names))),
        ranking(std::make_shared<RankingModel>(ltl::Vocabulary(names))) {}
  operator Grounder() const { return {linear, ranking}; }
  std::shared_ptr<LinearModel> linear;
  std::shared_ptr<RankingModel> ranking;
};

Parts some_model() {
  Parts model({"chair", "ahead_chair", "moved"});
  for (const char* word : {"walk", "the"}) {
    model.ranking->words.add(word);
    model.linear->words.add(word);
  }
  std::mt19937_64 random(1);
  WeightTable &weights = model.linear->weights, &reranker = model.ranking->reranker,
              &start_pose_model = model.ranking->start_pose_model;
  for (std::uint64_t f = 0; f < 40; ++f) {
    float* const row = weights.row(weights.add(f * f));
    for (std::size_t c = 0; c < weights.columns(); c += 1 + f % 3)
      row[c] = static_cast<float>(static_cast<double>(random() % 10'000) / 1000.0 - 5.0);
    *reranker.row(reranker.add(f + 7)) = static_cast<float>(f) - 20.0F;
    *start_pose_model.row(start_pose_model.add(f + 9)) = static_cast<float>(f) - 30.5F;
  }
  return model;
}

const LinearModel& linear_of(const Grounder& grounder) {
  return *std::get<std::shared_ptr<const LinearModel>>(grounder.word_model);
}

TEST(WeightsFile, KeepsWordsAndWeightsToHalfPrecision) {
  const Parts model = some_model();
  const Grounder read = parse_grounder(serialize(model));
  EXPECT_EQ(read.ranking->language.vocabulary(), model.ranking->language.vocabulary());
  EXPECT_EQ(read.ranking->words.words(), model.ranking->words.words());
  EXPECT_EQ(linear_of(read).words.words(), model.linear->words.words());
  for (std::uint64_t f = 0; f < 40; ++f) {
    const auto r = model.linear->weights.find(f * f), there = linear_of(read).weights.find(f * f);
    ASSERT_TRUE(r && there);
    for (std::size_t c = 0; c < model.linear->weights.columns(); ++c) {
      const double want = static_cast<double>(model.linear->weights.weight(*r, c)),
                   got = static_cast<double>(linear_of(read).weights.weight(*there, c));
      EXPECT_NEAR(got, want, got == 0.0 ? least_weight : 0.0005 * std::abs(want));
    }
  }
  EXPECT_EQ(read.ranking->reranker.rows(), 39U);  // the zero weight needs no row
  ASSERT_EQ(read.ranking->start_pose_model.rows(), 40U);
  model.ranking->start_pose_model.each([&](std::uint64_t feature, std::size_t column, float weight) {
    EXPECT_EQ(read.ranking->start_pose_model.weight(read.ranking->start_pose_model.find(feature).value(), column),
              weight);
  });
}

TEST(WeightsFile, WritingWhatWasReadGivesTheSameBytes) {
  const std::string bytes = serialize(some_model());
  EXPECT_EQ(serialize(parse_grounder(bytes)), bytes);
}

std::string message_of(const std::string& bytes) {
  try {
    parse_grounder(bytes, "a.waymark");
  } catch (const ltl::FormatError& error) {
    return error.what();
  }
  return {};
}

TEST(WeightsFile, FeaturesThatAreNeighboursTakeThreeBytesAndTheIndexLessThanOne) {
  const Parts model({"chair"});
  const auto add = [&](std::uint64_t from, std::uint64_t step) {
    for (std::uint64_t k = 0; k < 1600; ++k)
      *model.ranking->reranker.row(model.ranking->reranker.add(from + k * step)) = 0.5F;
    return serialize(model).size();
  };
  const std::size_t none = serialize(model).size(), near = add(1, 127), far = add(UINT64_MAX / 2, 1U << 20U);
  EXPECT_EQ(near - none, 1600 * 3 + 100 * 12U);
  EXPECT_EQ(far - near, (5 * 1599U + 11U + 7U) / 8 * 8 + 100 * 12U);
}

// A table that lies in a file and the learned one it was made of answer alike, at every edge of every block.
TEST(WeightsFile, FindsTheFeaturesThatAreThereAndNoOthers) {
  std::mt19937_64 random(2);
  for (const std::size_t rows : {0U, 1U, 15U, 16U, 17U, 32U, 500U}) {
    const Parts model({"chair"});
    for (std::size_t r = 0; r < rows; ++r) {
      const std::uint64_t feature = r == 0 ? 0 : r == 1 ? UINT64_MAX : random() >> random() % 64;
      *model.ranking->reranker.row(model.ranking->reranker.add(feature)) = 1.0F + static_cast<float>(r % 7);
      float* const row = model.linear->weights.row(model.linear->weights.add(feature));
      for (std::size_t c = random() % 3; c < model.linear->weights.columns(); c += 1 + random() % 9) row[c] = 2.0F;
    }
    const Grounder read = parse_grounder(serialize(model));
    std::vector<float> sums(model.linear->weights.columns()), wanted(model.linear->weights.columns());
    const auto expect_same = [&](std::uint64_t feature) {
      const auto r = read.ranking->reranker.find(feature), w = model.ranking->reranker.find(feature);
      ASSERT_EQ(r.has_value(), w.has_value()) << feature;
      if (!r) return;
      EXPECT_EQ(read.ranking->reranker.weight(*r, 0), model.ranking->reranker.weight(*w, 0));
      std::fill(sums.begin(), sums.end(), 1.0F);
      std::fill(wanted.begin(), wanted.end(), 1.0F);
      model.linear->weights.add_to(model.linear->weights.find(feature).value(), wanted.data());
      if (const auto row = linear_of(read).weights.find(feature)) linear_of(read).weights.add_to(*row, sums.data());
      EXPECT_EQ(sums, wanted);
    };
    model.ranking->reranker.each([&](std::uint64_t feature, std::size_t, float) {
      for (const std::uint64_t near : {feature - 1, feature, feature + 1}) expect_same(near);
    });
    for (const std::uint64_t feature : {std::uint64_t{0}, UINT64_MAX, UINT64_MAX / 2}) expect_same(feature);
  }
}

TEST(WeightsFile, TheChecksumIsXxh64) {  // against values of the reference implementation
  EXPECT_EQ(ltl::xxh64(""), 0xEF46DB3751D8E999U);
  EXPECT_EQ(ltl::xxh64("a"), 0xD24EC4F1A98C6E5BU);
  EXPECT_EQ(ltl::xxh64("abc"), 0x44BC2CF5AD770999U);
  EXPECT_EQ(ltl::xxh64("Nobody inspects the spammish repetition"), 0xFBCEA83C8A378BF1U);
}

TEST(WeightsFile, WithoutAThresholdWhatIsNotZeroIsKept) {
  const Parts model({"chair"});
  for (const float weight : {0.0F, 1e-4F, -0.01F, 0.02F})
    *model.ranking->start_pose_model.row(model.ranking->start_pose_model.add(model.ranking->start_pose_model.rows())) =
        weight;
  model.linear->weights.row(model.linear->weights.add(5))[2] = 1e-3F;
  const Grounder all = parse_grounder(serialize(model, 0)), some = parse_grounder(serialize(model, 0.02));
  EXPECT_EQ(all.ranking->start_pose_model.rows(), 3U);
  EXPECT_FALSE(all.ranking->start_pose_model.find(0));
  EXPECT_EQ(linear_of(all).weights.rows(), 1U);
  EXPECT_EQ(some.ranking->start_pose_model.rows(), 1U);  // 0.012 and more
  EXPECT_EQ(linear_of(some).weights.rows(), 0U);
}

// What no writer writes, under a checksum that fits.
TEST(WeightsFile, TablesThatCannotBeAreRefused) {
  const RankingModel empty(ltl::Vocabulary({"chair"}));
  const std::uint64_t columns = empty.language.columns().size();
  struct Rows {
    std::string bytes;
    std::vector<std::uint64_t> last;
    std::vector<std::uint32_t> end;
    std::uint64_t rows;
  };
  const auto message = [&](const Rows& rows) {
    WeightsWriter out({.kind = LinearModel::file_kind});
    out.strings(empty.language.vocabulary().names());
    out.strings(empty.words.words());
    out.number(columns);
    out.number(rows.rows);
    out.list(rows.last);
    out.list(rows.end);
    out.list(rows.bytes);
    out.table(WeightTable(1), 0);
    out.table(WeightTable(1), 0);
    out.number(0);  // no reader of commands
    return message_of(out.finish());
  };
  const std::string top = "\xFF\xFF\xFF\xFF\xFF\xFF\xFF\xFF\xFF";  // 2⁶³ − 1, and a last byte to come
  const auto row = [](char gap, char column) { return std::string{gap, 1, column, 0, 0x3C}; };
  const auto last_column = static_cast<char>(columns - 1), next_column = static_cast<char>(columns);
  ASSERT_LT(columns, 128U);
  EXPECT_EQ(message({"", {}, {}, 0}), "");
  EXPECT_EQ(message({row(5, last_column), {5}, {5}, 1}), "");
  EXPECT_EQ(message({top + row(1, 0), {UINT64_MAX}, {14}, 1}), "");
  const auto refused = [&](const std::string& why, const Rows& rows) {
    EXPECT_NE(message(rows).find(why), std::string::npos) << message(rows);
  };
  refused("outside its table", {row(5, next_column), {5}, {5}, 1});
  refused("stands twice", {row(5, 0) + row(0, 0), {5}, {10}, 2});
  refused("a feature takes more than 64 bits", {row(5, 0) + top + row(1, 0), {4}, {19}, 2});
  refused("in a table takes more than 64 bits", {top + row(2, 0), {0}, {14}, 1});
  refused("no finite number", {std::string{5, 1, 0, 0, 0x7C}, {5}, {5}, 1});
  refused("cut short", {row(5, 0).substr(0, 4), {5}, {4}, 1});
  refused("goes on after its end", {row(5, 0) + "x", {5}, {5}, 1});
  refused("index", {row(5, 0), {6}, {5}, 1});
  refused("index", {row(5, 0), {5}, {4}, 1});
  refused("index", {row(5, 0), {}, {}, 1});
  refused("index", {row(5, 0), {5}, {5}, UINT64_MAX});
}

TEST(WeightsFile, EveryCutAndEveryFlippedBitIsNoticed) {
  const std::string bytes = serialize(some_model());
  for (std::size_t n = 0; n < bytes.size(); n += 1 + n / 50)
    EXPECT_THROW(parse_grounder(bytes.substr(0, n)), ltl::FormatError) << n;
  EXPECT_THROW(parse_grounder(bytes + "x"), ltl::FormatError);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::string altered = bytes;
    altered[i] = static_cast<char>(altered[i] ^ 1 << i % 8);
    EXPECT_THROW(parse_grounder(altered), ltl::FormatError) << i;
  }
}

TEST(WeightsFile, MessagesSayWhatIsWrong) {
  const std::string bytes = serialize(some_model());
  std::string version = bytes;
  version[8] = 12;
  EXPECT_NE(message_of("no such thing").find("no model file"), std::string::npos);
  EXPECT_NE(message_of(version).find("version 12"), std::string::npos);
  EXPECT_NE(message_of(version).find("waymark train"), std::string::npos);  // the remedy
  EXPECT_NE(message_of(bytes.substr(0, 100)).find("damaged"), std::string::npos);
  EXPECT_NE(message_of(bytes.substr(0, 10)).find("cut short"), std::string::npos);
  EXPECT_NE(message_of(bytes.substr(0, 10)).find("a.waymark"), std::string::npos);
}

TEST(WeightsFile, APropositionOfNoFormAndAnUnknownKindAreErrorsOfTheFile) {
  const auto message = [](const ModelHeader& header, const std::string& proposition) {
    WeightsWriter out(header);
    out.strings({proposition});
    out.strings(WordTable().words());
    return message_of(out.finish());
  };
  EXPECT_NE(message({.kind = LinearModel::file_kind}, "left_").find("'left_'"), std::string::npos);
  EXPECT_NE(message({.kind = 999}, "chair").find("unknown kind"), std::string::npos);
}

TEST(WeightsFile, IsWrittenWholeOrNotAtAll) {
  const auto directory = std::filesystem::temp_directory_path() / ("waymark_weights_" + std::to_string(getpid()));
  std::filesystem::create_directories(directory);
  save(some_model(), directory / "a.waymark");
  EXPECT_EQ(serialize(load_grounder(directory / "a.waymark")), serialize(some_model()));
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(directory), {}), 1);
  EXPECT_THROW(save(some_model(), directory / "missing" / "a.waymark"), ltl::FormatError);
  EXPECT_THROW(load_grounder(directory / "b.waymark"), ltl::FormatError);
  std::filesystem::remove_all(directory);
}

}  // namespace
}  // namespace waymark::parser

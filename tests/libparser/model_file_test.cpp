#include "libparser/model_file.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <functional>
#include <random>

#include "libltl/diagnostic.hpp"
#include "libparser/model/weights_bytes.hpp"

namespace waymark::parser {
namespace {

LinearModel some_model() {
  LinearModel model(ltl::Vocabulary({"chair", "ahead_chair", "moved"}));
  model.words.add("walk");
  model.words.add("the");
  std::mt19937_64 random(1);
  for (std::uint64_t f = 0; f < 40; ++f) {
    float* const row = model.reader.row(model.reader.add(f * f));
    for (std::size_t c = 0; c < model.reader.columns(); c += 1 + f % 3)
      row[c] = static_cast<float>(static_cast<double>(random() % 10'000) / 1000.0 - 5.0);
    *model.reranker.row(model.reranker.add(f + 7)) = static_cast<float>(f) - 20.0F;
    *model.start_pose_model.row(model.start_pose_model.add(f + 9)) = static_cast<float>(f) - 30.5F;
  }
  return model;
}

TEST(WeightsFile, KeepsWordsAndWeightsToHalfPrecision) {
  const LinearModel model = some_model();
  const LinearModel read = parse_linear_model(serialize(model));
  EXPECT_EQ(read.vocabulary(), model.vocabulary());
  EXPECT_EQ(read.words.words(), model.words.words());
  for (std::uint32_t r = 0; r < model.reader.rows(); ++r) {
    const std::uint32_t there = read.reader.find(model.reader.key(r));
    ASSERT_NE(there, WeightTable::absent);
    for (std::size_t c = 0; c < model.reader.columns(); ++c) {
      const double want = static_cast<double>(model.reader.weight(r, c)),
                   got = static_cast<double>(read.reader.weight(there, c));
      EXPECT_NEAR(got, want, got == 0.0 ? least_weight : 0.0005 * std::abs(want));
    }
  }
  EXPECT_EQ(read.reranker.rows(), 39U);  // the zero weight needs no row
  ASSERT_EQ(read.start_pose_model.rows(), 40U);
  for (std::uint32_t r = 0; r < model.start_pose_model.rows(); ++r)
    EXPECT_EQ(read.start_pose_model.weight(read.start_pose_model.find(model.start_pose_model.key(r)), 0),
              model.start_pose_model.weight(r, 0));
}

TEST(WeightsFile, WritingWhatWasReadGivesTheSameBytes) {
  const std::string bytes = serialize(some_model());
  EXPECT_EQ(serialize(parse_linear_model(bytes)), bytes);
}

std::string message_of(const std::string& bytes) {
  try {
    parse_linear_model(bytes, "a.waymark");
  } catch (const ltl::FormatError& error) {
    return error.what();
  }
  return {};
}

TEST(WeightsFile, FeaturesThatAreNeighboursTakeThreeBytes) {
  LinearModel model(ltl::Vocabulary({"chair"}));
  const auto add = [&](std::uint64_t from, std::uint64_t step) {
    for (std::uint64_t k = 0; k < 1000; ++k) *model.reranker.row(model.reranker.add(from + k * step)) = 0.5F;
    return serialize(model).size();
  };
  const std::size_t none = serialize(model).size(), near = add(1, 127), far = add(UINT64_MAX / 2, 1U << 20U);
  EXPECT_EQ(near - none, 3000U);
  EXPECT_EQ(far - near, 5 * 999U + 11U);
}

TEST(WeightsFile, WithoutAThresholdWhatIsNotZeroIsKept) {
  LinearModel model(ltl::Vocabulary({"chair"}));
  for (const float weight : {0.0F, 1e-4F, -0.01F, 0.02F})
    *model.start_pose_model.row(model.start_pose_model.add(model.start_pose_model.rows())) = weight;
  model.reader.row(model.reader.add(5))[2] = 1e-3F;
  const LinearModel all = parse_linear_model(serialize(model, 0)),
                    some = parse_linear_model(serialize(model, 0.02));
  EXPECT_EQ(all.start_pose_model.rows(), 3U);
  EXPECT_EQ(all.start_pose_model.find(0), WeightTable::absent);
  EXPECT_EQ(all.reader.rows(), 1U);
  EXPECT_EQ(some.start_pose_model.rows(), 1U);  // 0.012 and more
  EXPECT_EQ(some.reader.rows(), 0U);
}

// What no writer writes, under a checksum that fits.
TEST(WeightsFile, TablesThatCannotBeAreRefused) {
  const LinearModel empty(ltl::Vocabulary({"chair"}));
  const auto columns = static_cast<std::uint32_t>(empty.reader.columns());
  const auto file = [&](std::uint32_t rows, const std::function<void(WeightsWriter&)>& write) {
    WeightsWriter out(9);
    out.strings(empty.vocabulary().names());
    out.strings(empty.words.words());
    out.number(columns);
    out.number(rows);
    write(out);
    for (int table = 0; table < 2; ++table) {
      out.number(1U);
      out.number(0U);
    }
    return message_of(out.finish());
  };
  const auto row = [](WeightsWriter& out, std::uint64_t feature, std::uint64_t column) {
    out.gap(feature);
    out.gap(1);
    out.gap(column);
    out.number(std::uint16_t{0x3C00});
  };
  EXPECT_EQ(file(0, [](WeightsWriter&) {}), "");
  EXPECT_EQ(file(1, [&](WeightsWriter& out) { row(out, UINT64_MAX, columns - 1); }), "");
  EXPECT_NE(file(1, [&](WeightsWriter& out) { row(out, 1, columns); }).find("outside its table"),
            std::string::npos);
  EXPECT_NE(file(1, [&](WeightsWriter& out) { row(out, 1, UINT64_MAX); }).find("outside its table"),
            std::string::npos);
  EXPECT_NE(file(2, [&](WeightsWriter& out) { row(out, 1, 0), row(out, 0, 0); }).find("stands twice"),
            std::string::npos);
  EXPECT_NE(file(2, [&](WeightsWriter& out) { row(out, 2, 0), row(out, UINT64_MAX - 1, 0); }).find("64 bits"),
            std::string::npos);
  EXPECT_NE(file(1,
                 [](WeightsWriter& out) {
                   for (int byte = 0; byte < 12; ++byte) out.number(std::uint8_t{0xFF});
                 })
                .find("64 bits"),
            std::string::npos);
  EXPECT_NE(file(1U << 20U, [](WeightsWriter&) {}).find("promises more"), std::string::npos);
}

TEST(WeightsFile, EveryCutAndEveryFlippedBitIsNoticed) {
  const std::string bytes = serialize(some_model());
  for (std::size_t n = 0; n < bytes.size(); n += 1 + n / 50)
    EXPECT_THROW(parse_linear_model(bytes.substr(0, n)), ltl::FormatError) << n;
  EXPECT_THROW(parse_linear_model(bytes + "x"), ltl::FormatError);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::string altered = bytes;
    altered[i] = static_cast<char>(altered[i] ^ 1 << i % 8);
    EXPECT_THROW(parse_linear_model(altered), ltl::FormatError) << i;
  }
}

TEST(WeightsFile, MessagesSayWhatIsWrong) {
  const std::string bytes = serialize(some_model());
  std::string version = bytes;
  version[8] = 8;
  EXPECT_NE(message_of("no such thing").find("no weights file"), std::string::npos);
  EXPECT_NE(message_of(version).find("version 8"), std::string::npos);
  EXPECT_NE(message_of(bytes.substr(0, 100)).find("damaged"), std::string::npos);
  EXPECT_NE(message_of(bytes.substr(0, 10)).find("cut short"), std::string::npos);
  EXPECT_NE(message_of(bytes.substr(0, 10)).find("a.waymark"), std::string::npos);
}

TEST(WeightsFile, IsWrittenWholeOrNotAtAll) {
  const auto directory =
      std::filesystem::temp_directory_path() / ("waymark_weights_" + std::to_string(getpid()));
  std::filesystem::create_directories(directory);
  save(grounder_of(some_model()), directory / "a.waymark");
  EXPECT_EQ(serialize(load_grounder(directory / "a.waymark")), serialize(some_model()));
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(directory), {}), 1);
  EXPECT_THROW(save(grounder_of(some_model()), directory / "missing" / "a.waymark"), ltl::FormatError);
  EXPECT_THROW(load_grounder(directory / "b.waymark"), ltl::FormatError);
  std::filesystem::remove_all(directory);
}

}  // namespace
}  // namespace waymark::parser

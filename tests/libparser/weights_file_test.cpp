#include "libparser/weights_file.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <random>

#include "libltl/diagnostic.hpp"

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
    *model.chooser.row(model.chooser.add(f + 7)) = static_cast<float>(f) - 20.0F;
    *model.locator.row(model.locator.add(f + 9)) = static_cast<float>(f) - 30.5F;
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
      EXPECT_NEAR(got, std::abs(want) < 0.02 ? got * 0.0 + want : want,
                  0.0005 * std::abs(want) + 0.021 * (got == 0.0));
    }
  }
  EXPECT_EQ(read.chooser.rows(), 39U);  // the zero weight needs no row
  ASSERT_EQ(read.locator.rows(), 40U);
  for (std::uint32_t r = 0; r < model.locator.rows(); ++r)
    EXPECT_EQ(read.locator.weight(read.locator.find(model.locator.key(r)), 0), model.locator.weight(r, 0));
}

TEST(WeightsFile, WritingWhatWasReadGivesTheSameBytes) {
  const std::string bytes = serialize(some_model());
  EXPECT_EQ(serialize(parse_linear_model(bytes)), bytes);
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
  const auto message = [](const std::string& bytes) {
    try {
      parse_linear_model(bytes, "a.waymark");
    } catch (const ltl::FormatError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  const std::string bytes = serialize(some_model());
  std::string version = bytes;
  version[8] = 9;
  EXPECT_NE(message("no such thing").find("no weights file"), std::string::npos);
  EXPECT_NE(message(version).find("version 9"), std::string::npos);
  EXPECT_NE(message(bytes.substr(0, 100)).find("damaged"), std::string::npos);
  EXPECT_NE(message(bytes.substr(0, 10)).find("cut short"), std::string::npos);
  EXPECT_NE(message(bytes.substr(0, 10)).find("a.waymark"), std::string::npos);
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

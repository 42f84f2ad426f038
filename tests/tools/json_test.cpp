// JSON as we write it is read by another implementation to the same values.
#include <gtest/gtest.h>

#include <limits>
#include <nlohmann/json.hpp>

#include "tools/shell/json.hpp"
#include "tools/shell/terminal.hpp"

namespace waymark::tools {
namespace {

std::string as_read(std::string_view text) { return nlohmann::json::parse(Json(text).text()).get<std::string>(); }

TEST(JsonText, KeepsEveryCharacter) {
  std::string all;
  for (int c = 1; c < 128; ++c) all += static_cast<char>(c);
  EXPECT_EQ(as_read(all), all);
  EXPECT_EQ(as_read("◇(chair ∧ ○moved) 𝒰 “ü”"), "◇(chair ∧ ○moved) 𝒰 “ü”");
}

TEST(JsonText, ReplacesWhatIsNotUtf8) {
  EXPECT_EQ(as_read("a\xFFz"), "a\xEF\xBF\xBDz");
  EXPECT_EQ(as_read("\xC3"), "\xEF\xBF\xBD");                  // cut off
  EXPECT_EQ(as_read("\xC0\xAF"), "\xEF\xBF\xBD\xEF\xBF\xBD");  // overlong
  EXPECT_EQ(as_read("\xED\xA0\x80").size(), 9U);               // a surrogate
}

TEST(JsonText, NumbersReadBackExactly) {
  for (const double value : {0.1, 1.0 / 3, 1e-300, 12345678901.25, -0.0})
    EXPECT_EQ(nlohmann::json::parse(Json(value).text()).get<double>(), value);
  EXPECT_EQ(Json(std::numeric_limits<double>::infinity()).text(), "\"inf\"");
  EXPECT_EQ(Json(std::size_t{18446744073709551615U}).text(), "18446744073709551615");
  EXPECT_EQ(Json(true).text(), "true");
}

TEST(JsonText, NestsInTheOrderOfAddition) {
  const JsonObject json = JsonObject()
                              .add("z", 1)
                              .add("a", JsonArray().add("x").add(JsonArray()))
                              .add("none", Json())
                              .add("o", JsonObject());
  EXPECT_EQ(json.text(), R"({"z":1,"a":["x",[]],"none":null,"o":{}})");
}

TEST(Numbers, AreWrittenWithAPointWhateverTheLocale) {
  EXPECT_EQ(fixed(12.5, 2), "12.50");
  EXPECT_EQ(fixed(1e22, 0), "10000000000000000000000");
  EXPECT_EQ(hexadecimal(0x1A2BU), "0000000000001a2b");
}

}  // namespace
}  // namespace waymark::tools

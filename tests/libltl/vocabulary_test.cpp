#include "libltl/vocabulary.hpp"

#include <gtest/gtest.h>

#include <stdexcept>
#include <string>

#include "libltl/diagnostic.hpp"
#include "libltl/printable_name.hpp"
#include "libltl/text/parse.hpp"
#include "libltl/text/read_word.hpp"

namespace waymark::ltl {
namespace {

TEST(Vocabulary, KeepsNamesOnceAndInOrder) {
  Vocabulary names({"chair", "sofa", "chair"});
  EXPECT_EQ(names.size(), 2U);
  EXPECT_EQ(names.add("lamp").index, 2U);
  EXPECT_EQ(names.add("sofa").index, 1U);
  EXPECT_EQ(names.name({2}), "lamp");
  EXPECT_EQ(names.find("stool"), std::nullopt);
  EXPECT_THROW(names.add(""), std::invalid_argument);
}

TEST(Vocabulary, FindsTheNameThatWasMeant) {
  const Vocabulary names({"chair", "ahead_chair", "sofa", "tee", "intersection"});
  const struct {
    const char *typed, *meant;
  } table[] = {{"chiar", "chair"}, {"chairs", "chair"},
               {"hair", "chair"},  {"Sofa", "sofa"},
               {"osfa", "sofa"},   {"intersecton", "intersection"},
               {"te", "tee"},      {"ahead_chiar", "ahead_chair"}};
  for (const auto& row : table) EXPECT_EQ(names.nearest(row.typed), row.meant) << row.typed;
  EXPECT_EQ(names.nearest("lamp"), std::nullopt);
  EXPECT_EQ(names.nearest("x"), std::nullopt);
  EXPECT_EQ(Vocabulary().nearest("chair"), std::nullopt);
}

TEST(Vocabulary, NoNameHasControlCharacters) {
  using namespace std::string_literals;
  for (const std::string& name : {"a\0b"s, "\x1b[31m"s, "tab\t"s, "\x7f"s, "\xC2\x9B"s, "\xff"s, "\r"s}) {
    EXPECT_FALSE(is_printable_name(name));
    EXPECT_THROW(Vocabulary().add(name), FormatError);
    Arena arena;
    EXPECT_THROW(parse('"' + name + '"', arena), SyntaxError);
    Vocabulary names;
    EXPECT_THROW(read_word("{\"" + name + "\"}", names), SyntaxError);
  }
  for (const char* name : {"a", "meeting room", "größe", "two\nlines", "→"}) {
    EXPECT_TRUE(is_printable_name(name));
    EXPECT_EQ(Vocabulary({name}).size(), 1U);
  }
}

}  // namespace
}  // namespace waymark::ltl

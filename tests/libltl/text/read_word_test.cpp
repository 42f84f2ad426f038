#include "libltl/text/read_word.hpp"

#include <gtest/gtest.h>

#include <string>

#include "libltl/diagnostic.hpp"
#include "libltl/structure/random.hpp"

namespace waymark::ltl {
namespace {

std::string shown(const AnyWord& word, const Vocabulary& names) {
  return std::visit([&](const auto& w) { return show(w, names); }, word);
}

TEST(ReadWord, ReadsWhatIsShown) {
  Random random(11);
  const Vocabulary names({"a", "b", "c"});
  for (int i = 0; i < 200; ++i) {
    Vocabulary same = names;
    const Trace trace = random_trace(random, {.length = 1 + random.below(5)});
    EXPECT_EQ(std::get<Trace>(read_word(show(trace, names), same)), trace);
    const Lasso lasso = random_lasso(random, {.prefix = random.below(4), .cycle = 1 + random.below(3)});
    EXPECT_EQ(std::get<Lasso>(read_word(show(lasso, names), same)), lasso);
  }
}

TEST(ReadWord, HasSeveralSpellings) {
  const struct {
    const char *text, *same;
  } rows[] = {
      {"a b; ; c", "{a, b}; {}; {c}"},
      {"{a b}", "{a, b}"},
      {"a,b;c", "{a, b}; {c}"},
      {"({a})w", "({a})ʷ"},
      {"{}; (a; b)^w", "{}; ({a}; {b})ʷ"},
      {"", "{}"},
      {"\"meeting room\"", "{\"meeting room\"}"},
      {"{\"a \\\"b\\\"\"}", "{\"a \\\"b\\\"\"}"},
      {"a;", "{a}"},
      {";", "{}"},
      {"{}; (a; b;)ω", "{}; ({a}; {b})ʷ"},
  };
  for (const auto& row : rows) {
    Vocabulary names;
    EXPECT_EQ(shown(read_word(row.text, names), names), row.same) << row.text;
  }
}

TEST(ReadWord, SaysWhatIsWrongAndWhere) {
  const struct {
    const char *text, *message;
    std::size_t column;
  } rows[] = {
      {"{a; {b}", "expected a name or '}'", 3},
      {"{a} {b}", "expected ';' or the end of the word", 5},
      {"a (b", "expected the name of a proposition", 3},
      {"a; (b", "expected ';' or ')'", 6},
      {"(a)", "expected 'ʷ', '^w' or 'w' behind the cycle of a lasso", 4},
      {"(a)w; b", "expected ';' or the end of the word", 5},
      {"\"a", "expected '\"' at the end of the name", 3},
      {"\"a\\", "expected '\"' at the end of the name", 4},
      {"\"\"", "a name is never empty", 3},
      {"\"a\\\"", "expected '\"' at the end of the name", 5},
      {"\"\\\"", "expected '\"' at the end of the name", 4},
  };
  for (const auto& row : rows) {
    Vocabulary names;
    try {
      read_word(row.text, names);
      ADD_FAILURE() << row.text << " was read";
    } catch (const SyntaxError& error) {
      EXPECT_EQ(error.message(), row.message) << row.text;
      EXPECT_EQ(error.column(), row.column) << row.text;
      const std::size_t size = std::string_view(row.text).size();
      EXPECT_EQ(error.where().end, std::min(error.where().begin + 1, size)) << row.text;
    }
  }
}

}  // namespace
}  // namespace waymark::ltl

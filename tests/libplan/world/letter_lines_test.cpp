#include "libplan/world/letter_source.hpp"

#include <gtest/gtest.h>

#include <string>

#include "libltl/diagnostic.hpp"

namespace waymark::plan {
namespace {

NamedTraces read_auto(std::string_view text) { return read_traces(text, {}, "t"); }

// The first trace; names are sorted by use.
std::string shown(const NamedTraces& read) { return ltl::show(read.words.front(), read.vocabulary); }

std::string refusal(std::string_view text, const LetterOptions& options = {}) {
  try {
    return "read as " + shown(read_traces(text, options, "t"));
  } catch (const std::runtime_error& error) {
    return error.what();
  }
}

TEST(LetterLines, ReadTheSameWordInEveryFormat) {
  const std::string word = "{a}; {a, b}; {}; {b}";
  for (const char* text :
       {"{a}\n{a, b}\n\n# a comment\n{}\n{b}\n", "a; a b; ; b", "[\"a\"]\n[\"a\",\"b\"]\n[]\n[\"b\"]",
        "{\"a\":true,\"b\":0}\n{\"a\":1,\"b\":true}\n{}\n{\"b\":true}\n", "a,b\n1,0\ntrue,1\n,\n0,TRUE\n",
        "\"a\", b\r\n1, 0\r\n1, 1\r\n0, 0\r\n0, 1\r\n", "a;b\n1;0\n1;1\n0;0\n0;1\n", "a\tb\n1\t\n1\t1\n\t0\n0\t1\n",
        "a b\n1 0\n1 1\n0 0\n0 1\n", "a,b\nyes,no\nTRUE,x\n-,off\nFalse,On\n", "{a};\n{a, b}; {}\nb;\n"}) {
    EXPECT_EQ(shown(read_auto(text)), word) << text;
  }
}

TEST(LetterLines, OnlyATableNamesAllPropositions) {
  EXPECT_TRUE(read_auto("a,b\n0,0\n").names_all);
  EXPECT_TRUE(read_auto("a\n0\n").names_all);
  EXPECT_TRUE(read_traces("a\n0\n", {.format = LetterFormat::Csv}, "t").names_all);
  EXPECT_FALSE(read_auto("a\n").names_all);
}

TEST(LetterLines, AnEmptyFirstLetterDoesNotSettleTheFormat) { EXPECT_EQ(shown(read_auto("{}\n{a}\n")), "{}; {a}"); }

TEST(LetterLines, KeepTheVocabularyTheyWereGiven) {
  LetterLines lines(LetterLines::Forgetful{{.format = LetterFormat::Text, .wanted = ltl::Vocabulary({"p", "q"})}}, "t");
  for (int i = 0; i < 10'000; ++i) lines.read("{other" + std::to_string(i) + "}");
  EXPECT_LT(lines.vocabulary().size(), 6'000U);
  EXPECT_EQ(lines.read("{q}").front(), ltl::Letter({ltl::Proposition{1}}));
}

TEST(LetterLines, SayWhichLineIsWrong) {
  const struct {
    const char *text, *message;
  } rows[] = {
      {"{a}\n{b", "t:2:3"},
      {"a,b\n1,0\n1\n", "the row has 1 cells, the header 2"},
      {"a,,b\n", "a column without a name"},
      {"a,b,a\n", "two columns 'a'"},
      {"a,b;c\n1,0;1\n", "a bare number is no name"},
      {"[\"a\"]\n{\"a\":null}\n", "expected true, false, 1 or 0"},
      {"[\"a\"]\n{\"[\":[]}\n", "expected true, false, 1 or 0"},
      {"[\"a\"]\n7\n", "expected a list of names"},
      {"{a}\n({b})w\n", "not the cycle of a lasso"},
      {"# nothing\n", "there are no letters"},
      {"{a}\n{1}\n", "a bare number is no name"},
      {"{!a}\n", "a letter lists what holds"},
      {"a&b\n", "'a&b' is no name"},
      {"{a=1}\n", "'a=1' is no name"},
      {"{true}\n", "'true' is no name"},
      {"--\n{a}\n", "there are no letters"},
      {"{a}\n--\n---\n{a}\n", "there are no letters"},
      {"<?xml version=\"1.0\"?>\n<log><trace/></log>\n", "this is an XES log"},
      {"digraph g {\n}\n", "this is a DOT graph"},
      {"never { /* F a */\n", "this is a never claim"},
      {"2 1\n0 1 -1\n", "this is an automaton in the format of LBT"},
      {"INFO { TITLE: \"t\" }\n", "this is a TLSF specification"},
      {"-- a comment\nMODULE main\nVAR x : boolean;\n", "this is an SMV model"},
      {"mdp\nmodule m\nendmodule\n", "this is a PRISM model"},
      {"HOA: v1\nStates: 0\n", "this is an automaton in HOA"},
  };
  for (const auto& row : rows)
    EXPECT_NE(refusal(row.text).find(row.message), std::string::npos) << row.text << ": " << refusal(row.text);
}

TEST(LetterLines, ATableHasOneDelimiter) {
  EXPECT_NE(refusal("a,b;c\n1,0;1\n", {.format = LetterFormat::Csv}).find("two delimiters"), std::string::npos);
  EXPECT_EQ(refusal("\"a,b\";c\n1;0\n"), "read as {\"a,b\"}");
  EXPECT_EQ(refusal("\"say \"\"hi\"\"\",c\n1,0\n"), "read as {\"say \\\"hi\\\"\"}");
}

TEST(LetterLines, SeveralTracesStandBetweenLinesOfDashes) {
  for (const char* text : {"a\nb\n--\nc\n", "a\nb\n-----\nc\n--\n", "[\"a\"]\n[\"b\"]\n--\n[\"c\"]\n",
                           "a,b,c\n1,0,0\n0,1,0\n--\n0,0,1\n", "a;b;c\n1;;\n;1;\n--\na;b;c\n;;1\n"}) {
    const NamedTraces read = read_auto(text);
    ASSERT_EQ(read.words.size(), 2U) << text;
    EXPECT_EQ(ltl::show(read.words[0], read.vocabulary), "{a}; {b}") << text;
    EXPECT_EQ(ltl::show(read.words[1], read.vocabulary), "{c}") << text;
  }
  LetterLines stream(LetterOptions(), "t");
  stream.read("{a}");
  EXPECT_THROW(stream.read("--"), ltl::FormatError) << "who reads one trace never joins two";
}

TEST(LetterLines, ValuesAreComparedAndNoTruth) {
  const auto with = [](const char* text, const std::vector<std::string>& wanted) {
    return refusal(text, {.wanted = ltl::Vocabulary(wanted)});
  };
  const char* table = "a,x,state\n1,2.5,idle\n0,3,busy\n";
  EXPECT_EQ(with(table, {"x >= 3", "a"}), "read as {a}; {\"x >= 3\"}");
  EXPECT_EQ(with(table, {"x<3", "state = busy"}), "read as {\"x<3\", a}; {\"state = busy\"}");
  EXPECT_EQ(with(table, {"state != busy"}), "read as {\"state != busy\", a}; {}");
  EXPECT_EQ(with("x;a\n0,5;1\n", {"x = 0.5"}), "read as {\"x = 0.5\", a}") << "a decimal comma";
  EXPECT_EQ(with("{\"x\":2.5,\"a\":true}\n{\"x\":4}\n", {"x > 3"}), "read as {a}; {\"x > 3\"}");
  EXPECT_EQ(with("{\"s\":\"on\"}\n{\"s\":\"off\"}\n", {"s = on"}), "read as {\"s = on\"}; {}");
  EXPECT_NE(with(table, {"x"}).find("t:2:1"), std::string::npos) << with(table, {"x"});
  EXPECT_NE(with(table, {"state > 2"}).find("'idle' cannot be compared"), std::string::npos);
  EXPECT_NE(with(table, {"y > 2"}).find("no column to compare in \"y > 2\""), std::string::npos);
  EXPECT_NE(with(table, {"b"}).find("the table has no column 'b'\n  t:1:1"), std::string::npos) << with(table, {"b"});
  EXPECT_NE(with("{\"a\":1}\n", {"y > 2"}).find("no letter has a value to compare"), std::string::npos);
  EXPECT_NE(with("{\"p\":\"true\"}\n", {"p"}).find("expected true, false, 1 or 0"), std::string::npos);
  EXPECT_EQ(read_auto(table).no_truths.at("x").value, "2.5");
  EXPECT_EQ(read_auto(table).no_truths.at("state").line, 2U);
  EXPECT_EQ(shown(read_auto("\"x >= 3\",b\n1,0\n")), "{\"x >= 3\"}") << "a column may have such a name";
}

TEST(LetterLines, AColumnOfTimeCountsSteps) {
  const auto counted = [](const char* text, double unit) { return refusal(text, {.time_unit = unit}); };
  EXPECT_EQ(counted("time,a,b\n0.0,1,0\n0.5,0,1\n2,1,1\n", 0.5), "read as {a}; {b}; {b}; {b}; {a, b}");
  EXPECT_NE(counted("time,a\n0,1\n0.7,0\n", 0.5).find("no whole number of time units"), std::string::npos);
  EXPECT_NE(counted("time,a\n0,1\n0,0\n", 1).find("not behind that of the row before"), std::string::npos);
  EXPECT_NE(counted("time,a\n0,1\n1e15,0\n", 1).find("too many time units"), std::string::npos);
  EXPECT_NE(counted("b,a\n0,1\n", 1).find("no column time"), std::string::npos);
  EXPECT_TRUE(read_auto("time,a\n0,1\n").has_time);
  const NamedTraces two = read_traces("time,a\n5,1\n7,0\n--\n0,0\n1,1\n", {.time_unit = 1}, "t");
  EXPECT_EQ(two.words[0].size(), 3U);
  EXPECT_EQ(two.words[1].size(), 2U) << "each trace has its own first time";
}

TEST(LetterLines, WaveformsAreTables) {
  const char* dump =
      "$timescale 1ns $end\n$scope module top $end\n$var wire 1 ! a $end\n$var reg 4 # n [3:0] $end\n"
      "$scope module sub $end\n$var wire 1 % a $end\n$upscope $end\n$upscope $end\n$enddefinitions $end\n"
      "#0\n$dumpvars\n0!\nb11 #\nx%\n$end\n#5\n1!\n1%\n#7\nb100 #\n";
  EXPECT_EQ(refusal(dump, {.wanted = ltl::Vocabulary({"n >= 4", "top.a"})}),
            "read as {}; {\"top.a\", \"top.sub.a\"}; {\"n >= 4\", \"top.a\", \"top.sub.a\"}");
  EXPECT_EQ(read_auto(dump).no_truths.at("top.sub.a").value, "?") << "x is no truth value";
  EXPECT_NE(refusal(dump, {.wanted = ltl::Vocabulary({"top.sub.a"})}).find("expected a truth value"),
            std::string::npos);
  EXPECT_EQ(read_traces(dump, {.time_unit = 1}, "t").words[0].size(), 8U);
  EXPECT_NE(refusal("$var wire 1 ! a $end\n#0\n1?\n").find("no $var has the identifier '?'"), std::string::npos);
  EXPECT_NE(refusal("$var wire 1 ! a $end\n").find("there is no time"), std::string::npos);
  EXPECT_NE(refusal("$comment never ends\n").find("not the end of the file"), std::string::npos);
}

// A letter is given before the next line is asked for, but for a first line that may be the header of a table.
TEST(LetterSource, HoldsWhatMayBeAHeader) {
  const auto asked_before_first = [](std::vector<std::string> text, LetterFormat format) {
    LetterLines lines(LetterOptions{.format = format}, "t");
    std::size_t asked = 0;
    LetterSource from(lines, format, "t", [&](std::string& line) {
      if (asked == text.size()) return false;
      line = text[asked++];
      return true;
    });
    std::string line;
    EXPECT_TRUE(from.next(line));
    return asked;
  };
  EXPECT_EQ(asked_before_first({"{a}", "{b}", "{}"}, LetterFormat::Auto), 1U);
  EXPECT_EQ(asked_before_first({"[\"a\"]", "[]"}, LetterFormat::Auto), 1U);
  EXPECT_EQ(asked_before_first({"a", "a", "b"}, LetterFormat::Auto), 2U);
  EXPECT_EQ(asked_before_first({"a", "a", "b"}, LetterFormat::Text), 1U);
  EXPECT_EQ(asked_before_first({"# a;b", "", "a;b", "1;0", "0;1"}, LetterFormat::Auto), 4U);
}

}  // namespace
}  // namespace waymark::plan

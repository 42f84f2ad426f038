#include "libparser/grounding/instruction.hpp"

#include <gtest/gtest.h>

#include "libltl/diagnostic.hpp"

namespace waymark::parser {
namespace {

TEST(Instruction, IsTextUnlessItBeginsWithABrace) {
  const Instruction plain = parse_instruction("go to the {chair}", "f", 1);
  EXPECT_EQ(plain.text, "go to the {chair}");
  EXPECT_FALSE(plain.map || plain.start);
}

TEST(Instruction, MaySayWhereItIsSpoken) {
  const Instruction whole = parse_instruction(R"({"text":"stop","map":"l","start":[3,4,90],"note":1})", "f", 1);
  EXPECT_EQ(whole.text, "stop");
  EXPECT_EQ(whole.map, "l");
  EXPECT_EQ(whole.start, "3,4,90");
  EXPECT_EQ(parse_instruction(R"({"text":"a","start":[3,-4]})", "f", 1).start, "3,-4");
  EXPECT_EQ(parse_instruction(R"({"text":"a","start":"1,2,-1"})", "f", 1).start, "1,2,-1");
  EXPECT_FALSE(parse_instruction(R"({"text":"a"})", "f", 1).start);
}

TEST(Instruction, WhatIsWrongIsNamedWithItsLine) {
  for (const auto& [line, said] : {std::pair{"{", "no JSON object"},
                                   {R"({"map":"l"})", "'text'"},
                                   {R"({"text":1})", "'text'"},
                                   {R"({"text":"a","map":2})", "'map'"},
                                   {R"({"text":"a","start":[1]})", "'start'"},
                                   {R"({"text":"a","start":[1,2.5]})", "'start'"},
                                   {R"({"text":"a","start":{}})", "'start'"}}) {
    try {
      parse_instruction(line, "batch.jsonl", 7);
      ADD_FAILURE() << line;
    } catch (const ltl::FormatError& error) {
      EXPECT_NE(std::string(error.what()).find(said), std::string::npos) << error.what();
      EXPECT_NE(std::string(error.what()).find("batch.jsonl:7"), std::string::npos) << error.what();
    }
  }
}

}  // namespace
}  // namespace waymark::parser

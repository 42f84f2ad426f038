#include <algorithm>

#include "tests/libparser/corpus/import/import_fixture.hpp"

namespace waymark::parser {
namespace {
TEST_F(ImportSail, ReadsTheReleaseInXml) {
  write("maps/map-yard.xml", nested_map);
  write("SingleSentence.xml", R"(<?xml version="1.0"?>
<examples>
<example id="5-1" map="Yard">
  <instruction filename="Cleaned-AB_Yard0_1_2_Dirs_1.txt">
    walk to   the lamp
  </instruction>
  <path>
    [(0, 1, -1), (0, 1, 0), (0, 0, 0)]
  </path>
</example>
<example id="5-3" map="Yard">
  <instruction filename="Cleaned-AB_Yard0_1_2_Dirs_1.txt">go right</instruction>
  <path>[(0, 0, 0), (0, 0, 90), (1, 0, 90)]</path>
</example>
</examples>
)");
  write("Paragraph.xml", R"xml(<examples>
<example end="(1, 0)" id="5" map="Yard" start="(0, 1)">
  <instruction filename="Cleaned-AB_Yard0_1_2_Dirs_1.txt">walk to the lamp. go right.</instruction>
  <path>[(0, 1, -1), (0, 1, 0), (0, 0, 0), (0, 0, 90), (1, 0, 90)]</path>
</example>
<example end="(1, 0)" id="6" map="Yard" start="(0, 1)">
  <instruction filename="Cleaned-CD_Yard0_1_2_Dirs_1.txt">find the end.</instruction>
  <path>[(0, 1, 90), (0, 1, 270), (1, 1, 270)]</path>
</example>
</examples>
)xml");
  const ImportedCorpus corpus = import_sail(folder_);
  EXPECT_EQ(corpus.format, "xml");
  EXPECT_EQ(kinds(corpus),
            "SingleSentence.xml:3 sentence-numbers-missing\n"
            "Paragraph.xml:6 unsegmented\n"
            "Paragraph.xml:6 uturn-expanded\n"
            "Paragraph.xml:6 illegal-step\n");
  const Corpus read = read_back(corpus);
  ASSERT_EQ(read.paragraphs.size(), 2U);
  EXPECT_EQ(read.paragraphs[0].id, "AB_Yard0_1_2_Dirs_1");
  ASSERT_EQ(read.paragraphs[0].sentences.size(), 2U);
  const Sentence& first = read.paragraphs[0].sentences[0];
  EXPECT_EQ(first.text, "walk to the lamp");
  EXPECT_TRUE(first.heading_unknown);
  EXPECT_EQ(first.absolute, (std::vector<plan::Pose>{{0, 1, 0}, {0, 0, 0}}));
  EXPECT_EQ(first.relative, (std::vector<plan::Pose>{{0, 1, 270}, {0, 1, 0}, {0, 0, 0}}));
  ASSERT_EQ(read.maps.size(), 1U);
  EXPECT_EQ(read.maps[0].places(), 2);  // numbered by the names of the paragraphs
}

TEST_F(ImportSail, ReadsSetTraces) {
  write("maps/map-yard.xml", flat_map);
  write("yard.settrc",
        "// a comment\n"
        "Cleaned-AB_Yard0_1_2_Dirs_1\n"
        "y=1\tmap=yard\tx=2\tconfidence=(4.5,0.5)\n"
        "walk to the lamp\n"
        "FORWARD(0,1,0);(0, 0, 0)\n"
        "go right\n"
        "RIGHT[I](0,0,0);FORWARD(0,0,90);(1, 0, 90)\n"
        "\n"
        "Cleaned-AB_Yard0_2_1_Dirs_1\r\n"
        "map=yard\tx=1\ty=2\r\n"
        "stay\r\n"
        "(1, 0, 90)");
  const ImportedCorpus corpus = import_sail(folder_);
  EXPECT_EQ(corpus.format, "settrc");
  EXPECT_EQ(kinds(corpus), "yard.settrc:11 goal-not-reached\n");
  const Corpus read = read_back(corpus);
  ASSERT_EQ(read.paragraphs.size(), 2U);
  EXPECT_EQ(read.paragraphs[0].sentences[1].absolute, (std::vector<plan::Pose>{{0, 0, 0}, {0, 0, 90}, {1, 0, 90}}));
  EXPECT_EQ(read.paragraphs[1].sentences[0].tokens, (std::vector<std::string>{"stay"}));
  EXPECT_EQ(read.maps[0].places(), 2);
}

TEST_F(ImportSail, PassesOurOwnLinesOn) {
  write("maps/map-yard.xml", flat_map);
  write("yard.settrc", "AB_Yard0_1_2_Dirs_1\ny=1\tmap=yard\tx=2\nwait\n(0, 1, 0)\n");
  const ImportedCorpus first = import_sail(folder_);
  read_back(first);
  const ImportedCorpus again = import_sail(folder_ / "out");
  EXPECT_EQ(again.format, "jsonl");
  EXPECT_EQ(again.instructions, first.instructions);
  EXPECT_EQ(again.maps, first.maps);
  EXPECT_EQ(kinds(again), "instructions.jsonl:1 goal-not-reached\n");
}

TEST_F(ImportSail, ComplainsWithFileAndLine) {
  EXPECT_NE(complaint().find("holds neither"), std::string::npos);
  write("a.settrc", "id\nmap=yard\tx=1\ty=2\nwalk\n  FORWARD(0,1,0;(0, 0, 0)\n");
  EXPECT_NE(complaint().find("a.settrc:4:16"), std::string::npos) << complaint();
  write("a.settrc", "id\nmap=yard\tx=1\ty=2\nwalk\n");
  EXPECT_NE(complaint().find("a.settrc:3"), std::string::npos) << complaint();
  write("map-a.xml",
        "<map name=\"A\">\n<node x=\"0\" y=\"0\"/>\n<edge node1=\"0,0\" node2=\"5,5\" floor=\"\" "
        "wall=\"\"/></map>");
  EXPECT_NE(complaint().find("map-a.xml:3"), std::string::npos) << complaint();
  write("map-a.xml", "<map name=\"A\">\n<node x=\"0\" y=\"0\">");
  EXPECT_NE(complaint().find("malformed XML"), std::string::npos) << complaint();
  for (const std::string name : {"../a", "", ".a", "a/b"}) {  // it becomes the name of a file
    write("map-a.xml", "\n<map name=\"" + name + "\"><node x=\"0\" y=\"0\"/></map>");
    EXPECT_NE(complaint().find("map-a.xml:2"), std::string::npos) << complaint();
  }
}

// The map of the fixture, and one thing more in its third line.
TEST_F(ImportSail, RefusesMapsThatAreNoHallways) {
  for (const char* const more : {
           R"(<node x="4" y="0"/><edge node1="1,0" node2="4,0" floor="" wall=""/>)",  // too long
           R"(<edge node1="1,0" node2="0,0" floor="" wall=""/>)",                     // a second time
           R"(<edge node1="0,0" node2="0,0" floor="" wall=""/>)",                     // a loop
           R"(<edge node1="0,1" node2="1,0" floor="" wall=""/>)",                     // slanting
           R"(<node x="0" y="0" item="sofa"/>)",                                      // a node twice
           R"(<edge node1="0,0" node2="0,1" wall=""/>)",                              // no floor
           R"(<node x="9" y="9" id="0"/>)",                                           // no place
       }) {
    std::string map = flat_map;
    map.insert(map.rfind("</map>"), "\n" + std::string(more));
    const auto lines = std::count(map.begin(), map.end(), '\n');
    write("map-yard.xml", map);
    EXPECT_NE(complaint().find("map-yard.xml:" + std::to_string(lines)), std::string::npos)
        << more << ": " << complaint();
  }
}

// Names that no map of ours could tell apart: of things, and of what a place looks like.
TEST_F(ImportSail, RefusesMapsWhosePropositionsCoincide) {
  for (const char* const item : {"corner", "intersection", "moved"}) {
    std::string map = flat_map;
    map.insert(map.rfind("</map>"), "<node x=\"4\" y=\"0\" item=\"" + std::string(item) + "\"/>");
    write("map-yard.xml", map);
    EXPECT_NE(complaint().find("map-yard.xml:1"), std::string::npos) << item << ": " << complaint();
    EXPECT_NE(complaint().find("share the proposition '" + std::string(item) + "'"), std::string::npos) << complaint();
  }
}

}  // namespace
}  // namespace waymark::parser

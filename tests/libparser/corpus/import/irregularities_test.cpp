// What is odd in a release is told with file and line, and what is written can be read again.
#include <string>

#include "tests/libparser/corpus/import/import_fixture.hpp"

namespace waymark::parser {
namespace {

// One sentence on the map of the fixture, in line 2; its text in line 3 and its path in line 4.
std::string example(const std::string& text, const std::string& path, const std::string& id = "5-1") {
  return "<example id=\"" + id + "\" map=\"Yard\">\n<instruction filename=\"Cleaned-AB_Yard0_1_2_Dirs_1.txt\">" + text +
         "</instruction>\n<path>" + path + "</path>\n</example>\n";
}
std::string examples(const std::string& inside) { return "<examples>\n" + inside + "</examples>\n"; }

const char* const open_path = "[(0, 1, -1), (0, 1, 0), (0, 0, 0)]";
const char* const traces =
    "Cleaned-AB_Yard0_1_2_Dirs_1\n"
    "y=1\tmap=yard\tx=2\n"
    "walk to the lamp\n"
    "FORWARD(0,1,0);(0, 0, 0)\n"
    "it does n't end , go right\n"
    "RIGHT(0,0,0);FORWARD(0,0,90);(1, 0, 90)\n";

class Irregularities : public ImportSail {
 protected:
  void SetUp() override {
    ImportSail::SetUp();
    write("maps/map-yard.xml", flat_map);
  }
  // The same corpus with one passage replaced.
  void write_traces(const std::string& from = "", const std::string& to = "",
                    const std::string& name = "a.settrc") const {
    std::string text = traces;
    if (const std::size_t at = text.find(from); !from.empty()) text.replace(at, from.size(), to);
    write(name, text);
  }
  // Text of the only sentence.
  std::string text_of_xml(const std::string& text) const {
    write("SingleSentence.xml", examples(example(text, open_path)));
    return read_back(import_sail(folder_)).paragraphs.at(0).sentences.at(0).text;
  }
};

TEST_F(Irregularities, TextIsAllTextWhateverStandsBetween) {
  EXPECT_EQ(text_of_xml("walk <!-- well --> to the <b>lamp</b> <i>there</i>"), "walk to the lamp there");
  EXPECT_EQ(text_of_xml("<![CDATA[walk & go]]> on"), "walk & go on");
  EXPECT_EQ(text_of_xml("a &amp; b &lt; &#99; &#xe9;"), "a & b < c é");
  EXPECT_EQ(text_of_xml("über\r\n\t the\n lamp "), "über the lamp");
  EXPECT_EQ(text_of_xml(""), "");
}

TEST_F(Irregularities, PathsMayHoldCommentsAndLines) {
  write("SingleSentence.xml", examples(example("walk", "\n  <!-- a -->[(0, 1, -1),\n (0, 1, 0)]\n")));
  EXPECT_EQ(read_back(import_sail(folder_)).paragraphs.at(0).sentences.at(0).absolute.size(), 1U);
  write("SingleSentence.xml", examples(example("walk", "\n [(0, 1, -1),\n (0, 1, 0]\n")));
  EXPECT_NE(complaint().find("SingleSentence.xml:6:10"), std::string::npos) << complaint();
}

TEST_F(Irregularities, TextsAreUtf8) {
  write("a.settrc", "\xEF\xBB\xBF" + std::string(traces));
  EXPECT_EQ(read_back(import_sail(folder_)).paragraphs.at(0).id, "AB_Yard0_1_2_Dirs_1");
  write_traces("lamp", "l\xE1mp");
  EXPECT_NE(complaint().find("a.settrc:3"), std::string::npos) << complaint();
  const std::string latin1 = examples(example("caf\xE9 on", open_path));
  write("SingleSentence.xml", latin1);
  EXPECT_NE(complaint().find("SingleSentence.xml:3"), std::string::npos) << complaint();
  write("SingleSentence.xml", "<?xml version=\"1.0\" encoding=\"ISO-8859-1\"?>" + latin1);
  EXPECT_EQ(read_back(import_sail(folder_)).paragraphs.at(0).sentences.at(0).text, "café on");
  for (const std::string fault : {"\xC0\x80", "\xED\xA0\x80", "\xF4\x90\x80\x80", "\xE2\x82", "\x80", "\xFF\xFE"}) {
    write("SingleSentence.xml", examples(example("go " + fault, open_path)));
    EXPECT_NE(complaint().find("is not UTF-8"), std::string::npos) << complaint();
  }
}

TEST_F(Irregularities, NestingMayBeDeep) {
  std::string open, close;
  for (int i = 0; i < 200'000; ++i) open += "<a>", close += "</a>";
  write("SingleSentence.xml", open + examples(example("walk", open_path)) + close);
  EXPECT_EQ(import_sail(folder_).sentences, 1U);
}

TEST_F(Irregularities, WordsSplitBeforeStaySplit) {
  write_traces();
  const ImportedCorpus corpus = import_sail(folder_);
  EXPECT_EQ(kinds(corpus), "");
  EXPECT_EQ(read_back(corpus).paragraphs.at(0).sentences.at(1).tokens,
            (std::vector<std::string>{"it", "does", "n't", "end", ",", "go", "right"}));
}

// Each is told with its line; what is left can be read, and reads the same when it is imported again.
TEST_F(Irregularities, OfTraces) {
  const auto found = [&](const std::string& from, const std::string& to) {
    write_traces(from, to);
    const ImportedCorpus corpus = import_sail(folder_);
    const Corpus read = read_back(corpus);
    EXPECT_EQ(read.paragraphs.size(), corpus.paragraphs);
    EXPECT_EQ(read.sentences(), corpus.sentences);
    EXPECT_EQ(import_sail(folder_ / "out").irregularities.size(), corpus.irregularities.size());
    return std::to_string(corpus.sentences) + " " + kinds(corpus);
  };
  EXPECT_EQ(found("FORWARD(0,1,0);", "FORWARD(0,1,0);FORWARD(0,0,0);"), "2 a.settrc:3 stands-still\n");
  EXPECT_EQ(found("RIGHT(0", "LEFT[I](0"), "2 a.settrc:5 action-differs\n");
  EXPECT_EQ(found("x=2", "x=6"), "2 a.settrc:1 unknown-place\n");
  EXPECT_EQ(found("y=1", "y=2"), "2 a.settrc:3 start-differs\n");
  EXPECT_EQ(found("map=yard", "map=YARD"), "2 ");
  EXPECT_EQ(found("map=yard", "map=park"), "2 a.settrc:1 unknown-map\n");
  EXPECT_EQ(found("FORWARD(0,1,0);(0, 0, 0)", "LEFT(0,1,180);(0, 1, 0)"),
            "2 a.settrc:3 uturn-expanded\na.settrc:5 gap\n");
  EXPECT_EQ(found("FORWARD(0,1,0)", "FORWARD(0,2,0)"),
            "1 a.settrc:3 off-map\na.settrc:3 illegal-step\na.settrc:3 left-out\na.settrc:5 start-differs\n");
  EXPECT_EQ(found("(1, 0, 90)", "FORWARD(1,0,90);(2, 0, 90)"),
            "1 a.settrc:5 no-hallway\na.settrc:5 left-out\na.settrc:3 goal-not-reached\n");
}

TEST_F(Irregularities, PropertiesAreKept) {
  write_traces("map=yard", "confidence=(4.5,0.5)\t\tmap=yard\txalt=(1,0,90)");
  const std::string line = import_sail(folder_).instructions;
  EXPECT_NE(line.find("\"properties\":{\"confidence\":\"(4.5,0.5)\",\"xalt\":\"(1,0,90)\"}"), std::string::npos)
      << line;
  write_traces("x=2", "x=2\tx=1");
  EXPECT_NE(complaint().find("a.settrc:2"), std::string::npos) << complaint();
}

TEST_F(Irregularities, OfFilesThatSayTheSameTwice) {
  write_traces();
  write_traces("", "", "b.settrc");
  write_traces("go right", "go left", "c.settrc");
  ImportedCorpus corpus = import_sail(folder_);
  EXPECT_EQ(kinds(corpus), "b.settrc:1 repeated\nc.settrc:1 name-twice\n");
  EXPECT_EQ(corpus.paragraphs, 2U);
  write("x/SingleSentence.xml", examples(example("walk", open_path)));
  write("y/SingleSentence.xml", examples(example("run", open_path)));
  std::string other = flat_map;
  other.replace(other.find("wood"), 4, "blue");
  write("y/map-yard.xml", other);
  corpus = import_sail(folder_);
  EXPECT_EQ(kinds(corpus),
            "map-yard.xml:1 maps-differ\nSingleSentence.xml:1 not-read\n"
            "a.settrc:1 not-read\nb.settrc:1 not-read\nc.settrc:1 not-read\n");
  EXPECT_EQ(read_back(corpus).paragraphs.at(0).sentences.at(0).text, "walk");
}

TEST_F(Irregularities, OfNumbersAndNames) {
  std::string renamed = example("see", "[(0, 0, 0)]", "5-4");
  renamed.replace(renamed.find("AB_"), 2, "CD");
  write("SingleSentence.xml", examples(example("walk", open_path) + example("go", "[(0, 0, 0)]", "5-3") +
                                       example("wait", "[(0, 0, 0)]", "5-3") + renamed));
  EXPECT_EQ(kinds(import_sail(folder_)),
            "SingleSentence.xml:14 name-differs\n"
            "SingleSentence.xml:10 sentence-order\nSingleSentence.xml:2 sentence-numbers-missing\n");
  std::string twice = flat_map;
  twice.insert(twice.find("item=\"lamp\""), "id=\"2\" ");
  write("maps/map-yard.xml", twice);
  EXPECT_EQ(kinds(import_sail(folder_)).substr(0, 28), "map-yard.xml:1 place-differs");
}

// Lines of ours are looked at anew: what they do not say of themselves is found all the same.
TEST_F(Irregularities, OfOurOwnLines) {
  write_traces();
  const std::string line =
      R"({"id":"a","map":"grid","text":"","goal":[7,7],"sentences":[)"
      R"({"id":"1","text":"go","path":[[0,1,0],[0,0,0]]},{"id":"2","text":"stay","path":[[0,1,0]]}])";
  const auto found = [&](const std::string& more) {
    write("ours/instructions.jsonl", line + more + "}\n");
    return kinds(import_sail(folder_ / "ours"));
  };
  const std::string odd = "instructions.jsonl:1 gap\ninstructions.jsonl:1 goal-not-reached\n";
  EXPECT_EQ(found(""), odd);
  EXPECT_EQ(found(R"(,"flags":[{"kind":"gap","message":"known"}])"), odd);
  EXPECT_EQ(found(R"(,"flags":[{"kind":"said","after":"1"}])"), odd + "instructions.jsonl:1 said\n");
  EXPECT_THROW(found(R"(,"flags":[3])"), ltl::FormatError);
  EXPECT_THROW(found(R"(,"flags":[{"kind":3}])"), ltl::FormatError);
  write("ours/maps/any-name.json", import_sail(folder_).maps.at("yard"));
  EXPECT_EQ(found(""), "instructions.jsonl:1 unknown-map\n" + odd);
}

TEST_F(Irregularities, EmptyFilesHoldNothing) {
  write("a.settrc", "");
  EXPECT_EQ(import_sail(folder_).paragraphs, 0U);
  write("SingleSentence.xml", "<examples></examples>");
  EXPECT_NE(complaint().find("holds no <example>"), std::string::npos);
  write("SingleSentence.xml", "");
  EXPECT_NE(complaint().find("malformed XML"), std::string::npos);
  write("instructions.jsonl", "");
  EXPECT_EQ(import_sail(folder_).paragraphs, 0U);
}

}  // namespace
}  // namespace waymark::parser

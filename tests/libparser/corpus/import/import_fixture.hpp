// A folder of its own for each test of the importer, and a small map as both releases write it.
#pragma once
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "libltl/diagnostic.hpp"
#include "libparser/corpus/import/import_sail.hpp"
#include "libparser/corpus/sail_corpus.hpp"

namespace waymark::parser {

namespace fs = std::filesystem;

class ImportSail : public ::testing::Test {
 protected:
  void SetUp() override {
    const auto* test = ::testing::UnitTest::GetInstance()->current_test_info();
    folder_ = fs::path(::testing::TempDir()) / (std::string("waymark-import-") + test->name());
    fs::remove_all(folder_);
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }

  void write(const std::string& name, const std::string& text) const {
    fs::create_directories((folder_ / name).parent_path());
    std::ofstream(folder_ / name, std::ios::binary) << text;
  }
  // What is imported, written and read again: the reader of corpora takes it.
  Corpus read_back(const ImportedCorpus& corpus) const {
    write("out/instructions.jsonl", corpus.instructions);
    for (const auto& [name, text] : corpus.maps) write("out/maps/" + name + ".json", text);
    return read_sail_corpus(folder_ / "out");
  }
  static std::string kinds(const ImportedCorpus& corpus) {
    std::string out;
    for (const Irregularity& i : corpus.irregularities)
      out += fs::path(i.file).filename().string() + ":" + std::to_string(i.line) + " " + i.kind + "\n";
    return out;
  }

  std::string complaint() const {
    try {
      import_sail(folder_);
    } catch (const ltl::FormatError& error) {
      return error.what();
    }
    return "nothing";
  }

  fs::path folder_;
};

inline const char* const nested_map = R"(<?xml version="1.0"?>
  <map name="Yard">
    <nodes>
      <node x="0" y="1" item=""></node>
      <node x="0" y="0" item="lamp"></node>
      <node x="1" y="0" item=""></node>
    </nodes>
    <edges>
      <edge node1="0,1" node2="0,0" wall="fish" floor="blue"></edge>
      <edge node1="0,0" node2="1,0" wall="fish" floor="wood"></edge>
    </edges>
  </map>
)";
inline const char* const flat_map = R"(<map name="Yard" xplus="90">
  <node x="0" y="1" id="1" item="" /><node x="0" y="0" item="lamp" /><node x="1" y="0" id="2" item="" />
  <edge node1="0,1" node2="0,0" wall="fish" floor="blue" />
  <edge floor="wood" node1="0,0" node2="1,0" wall="fish" />
</map>
)";

}  // namespace waymark::parser

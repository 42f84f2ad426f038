#include "libparser/import/import_sail.hpp"

#include <algorithm>
#include <cstdlib>

#include "libltl/diagnostic.hpp"
#include "libparser/corpus/corpus_file.hpp"
#include "libparser/corpus/sail_corpus.hpp"
#include "libparser/import/irregularities.hpp"
#include "libparser/import/read_settrc.hpp"
#include "libparser/import/read_xml.hpp"
#include "libparser/import/write_corpus.hpp"

namespace waymark::parser {
namespace {

namespace fs = std::filesystem;

std::vector<fs::path> files_of(const fs::path& directory) {
  std::vector<fs::path> files;
  if (!fs::is_directory(directory)) throw ltl::FormatError(directory.string(), 0, 0, "is no directory");
  for (const auto& entry : fs::recursive_directory_iterator(directory))
    if (entry.is_regular_file()) files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

// "Cleaned-WLH_Grid0_4_7_Dirs_1.txt" → "WLH_Grid0_4_7_Dirs_1"
std::string paragraph_name(std::string name) {
  constexpr std::string_view prefix = "Cleaned-", suffix = ".txt";
  if (name.rfind(prefix, 0) == 0) name.erase(0, prefix.size());
  if (name.size() > suffix.size() && name.ends_with(suffix)) name.resize(name.size() - suffix.size());
  return name;
}

class Import {
 public:
  explicit Import(const fs::path& directory) : files_(files_of(directory)) {}

  ImportedCorpus run() {
    read_maps();
    const bool xml = has("SingleSentence.xml") || has("Paragraph.xml");
    const bool settrc = std::any_of(files_.begin(), files_.end(),
                                    [](const fs::path& f) { return f.extension() == ".settrc"; });
    if (xml)
      read_xml();
    else if (settrc)
      read_traces();
    else
      throw ltl::FormatError(
          files_.empty() ? "the directory" : files_[0].parent_path().string(), 0, 0,
          "holds neither SingleSentence.xml, nor Paragraph.xml, nor *.settrc, nor instructions.jsonl");
    out_.format = xml ? "xml" : "settrc";
    write();
    return std::move(out_);
  }

 private:
  bool has(const char* name) const {
    return std::any_of(files_.begin(), files_.end(), [&](const fs::path& f) { return f.filename() == name; });
  }

  void read_maps() {  // the same map may come with several releases: the one with place numbers is kept
    for (const fs::path& file : files_) {
      if (file.extension() != ".xml" || file.filename().string().rfind("map-", 0) != 0) continue;
      ReleasedMap map = parse_xml_map(read_corpus_file(file), file.string());
      const auto numbered = [](const ReleasedMap& m) {
        return std::any_of(m.nodes.begin(), m.nodes.end(),
                           [](const plan::Node& n) { return n.place.has_value(); });
      };
      const auto [at, fresh] = maps_.try_emplace(map.name, map);
      if (!fresh && numbered(map) && !numbered(at->second)) at->second = std::move(map);
    }
  }

  std::vector<XmlExample> examples(const char* name, std::string& file) const {
    std::vector<XmlExample> found;
    for (const fs::path& path : files_)
      if (path.filename() == name && file.empty()) {
        file = path.string();
        found = parse_xml_examples(read_corpus_file(path), file);
      }
    return found;
  }

  void read_xml() {
    std::string paragraph_file, sentence_file;
    const auto wholes = examples("Paragraph.xml", paragraph_file);
    const auto sentences = examples("SingleSentence.xml", sentence_file);
    std::map<std::string, std::size_t> index;  // of paragraphs, by their number
    for (const XmlExample& whole : wholes) {
      ReleasedParagraph p{paragraph_name(whole.file_name),
                          whole.map,
                          whole.text,
                          std::atoi(whole.id.c_str()),
                          paragraph_file,
                          whole.line,
                          whole.start,
                          whole.end,
                          whole.path,
                          {}};
      if (!index.try_emplace(whole.id, paragraphs_.size()).second)
        throw ltl::FormatError(paragraph_file, whole.line, 0, "two paragraphs have the number " + whole.id);
      paragraphs_.push_back(std::move(p));
    }
    for (const XmlExample& s : sentences) {
      const std::string number = s.id.substr(0, s.id.find('-'));
      const auto [at, alone] = index.try_emplace(number, paragraphs_.size());
      if (alone) {
        paragraphs_.push_back({paragraph_name(s.file_name),
                               s.map,
                               {},
                               std::atoi(number.c_str()),
                               sentence_file,
                               s.line,
                               std::nullopt,
                               std::nullopt,
                               {},
                               {}});
        if (!wholes.empty())
          out_.irregularities.push_back({sentence_file, s.line, "no-paragraph",
                                         "sentence " + s.id + ": its paragraph is not in Paragraph.xml"});
      }
      ReleasedParagraph& p = paragraphs_[at->second];
      if (p.map != s.map)
        out_.irregularities.push_back(
            {sentence_file, s.line, "map-differs",
             "sentence " + s.id + " is on " + s.map + ", its paragraph on " + p.map});
      p.sentences.push_back({s.id, s.text, s.path, sentence_file, s.line});
    }
    number_places();
  }

  // Chen and Mooney's maps do not number the places; the names of the paragraphs do, and where these start and end.
  void number_places() {
    for (const ReleasedParagraph& p : paragraphs_) {
      const auto map = maps_.find(p.map);
      const std::size_t dirs = p.id.rfind("_Dirs");
      if (map == maps_.end() || dirs == std::string::npos || dirs < 4) continue;
      const auto put = [&](const std::optional<plan::Pose>& at, char digit) {
        if (!at || digit < '0' || digit > '9') return;
        for (plan::Node& node : map->second.nodes)
          if (node.x == at->x && node.y == at->y && !node.place) node.place = digit - '0';
      };
      put(p.start, p.id[dirs - 3]);
      put(p.goal, p.id[dirs - 1]);
    }
  }

  void read_traces() {
    for (const fs::path& path : files_) {
      if (path.extension() != ".settrc") continue;
      for (SettrcParagraph& read : parse_settrc(read_corpus_file(path), path.string())) {
        ReleasedParagraph& p = read.paragraph;
        p.id = paragraph_name(p.id);
        for (const ReleasedSentence& s : p.sentences) p.text += (p.text.empty() ? "" : " . ") + s.text;
        if (const auto map = maps_.find(p.map); map != maps_.end())
          for (const plan::Node& node : map->second.nodes) {
            if (node.place == read.start_place) p.start = plan::Pose{node.x, node.y, 0};
            if (node.place == read.goal_place) p.goal = plan::Pose{node.x, node.y, 0};
          }
        paragraphs_.push_back(std::move(p));
      }
    }
  }

  void write() {
    for (ReleasedParagraph& p : paragraphs_) {
      const auto map = maps_.find(p.map);
      auto found = find_irregularities(p, map == maps_.end() ? nullptr : &map->second);
      std::size_t number = 0;
      for (ReleasedSentence& s : p.sentences)
        if (++number; s.id.empty()) s.id = p.id + "-" + std::to_string(number);
      out_.instructions += json_line(p, found) + "\n";
      out_.sentences += p.sentences.size();
      for (Irregularity& i : found) out_.irregularities.push_back(std::move(i));
    }
    out_.paragraphs = paragraphs_.size();
    for (const auto& [name, map] : maps_) out_.maps.emplace(name, json_map(map));
  }

  std::vector<fs::path> files_;
  std::map<std::string, ReleasedMap> maps_;
  std::vector<ReleasedParagraph> paragraphs_;
  ImportedCorpus out_;
};

// Our own format is checked by reading it, and copied as it is.
ImportedCorpus import_lines(const fs::path& directory) {
  const Corpus corpus = read_sail_corpus(directory);
  ImportedCorpus out;
  out.format = "jsonl";
  out.instructions = read_corpus_file(directory / "instructions.jsonl");
  out.paragraphs = corpus.paragraphs.size();
  out.sentences = corpus.sentences();
  for (const plan::Map& map : corpus.maps)
    out.maps.emplace(map.name(), read_corpus_file(directory / "maps" / (map.name() + ".json")));
  out.irregularities = flags_of(out.instructions, (directory / "instructions.jsonl").string());
  return out;
}

}  // namespace

ImportedCorpus import_sail(const std::filesystem::path& directory) {
  if (fs::exists(directory / "instructions.jsonl")) return import_lines(directory);
  return Import(directory).run();
}

}  // namespace waymark::parser

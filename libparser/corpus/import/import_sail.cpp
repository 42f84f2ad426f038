#include "libparser/corpus/import/import_sail.hpp"

#include <algorithm>
#include <cstdlib>
#include <set>
#include <tuple>

#include "libltl/diagnostic.hpp"
#include "libparser/corpus/corpus_file.hpp"
#include "libparser/corpus/import/irregularities.hpp"
#include "libparser/corpus/import/read_lines.hpp"
#include "libparser/corpus/import/read_settrc.hpp"
#include "libparser/corpus/import/read_xml.hpp"
#include "libparser/corpus/import/released_text.hpp"
#include "libparser/corpus/import/write_corpus.hpp"
#include "libparser/corpus/sail_corpus.hpp"

namespace waymark::parser {
namespace {

namespace fs = std::filesystem;

std::vector<fs::path> files_of(const fs::path& directory) {
  std::vector<fs::path> files;
  std::error_code error;
  if (!fs::is_directory(directory, error)) throw ltl::FormatError(directory.string(), 0, 0, "is no directory");
  for (fs::recursive_directory_iterator at(directory, error); !error && at != fs::recursive_directory_iterator();
       at.increment(error))
    if (std::error_code unknown; at->is_regular_file(unknown)) files.push_back(at->path());
  if (error) throw ltl::FormatError(directory.string(), 0, 0, "cannot be read: " + error.message());
  std::sort(files.begin(), files.end());
  return files;
}

std::string text_of(const fs::path& file) { return released_text(read_corpus_file(file), file.string()); }

bool same_hallways(const ReleasedMap& a, const ReleasedMap& b) {  // places apart
  const auto nodes = [](const ReleasedMap& map) {
    std::map<std::pair<int, int>, std::optional<std::string>> out;
    for (const plan::Node& n : map.nodes) out[{n.x, n.y}] = n.object;
    return out;
  };
  const auto edges = [](const ReleasedMap& map) {
    std::vector<std::tuple<std::pair<int, int>, std::pair<int, int>, std::string, std::string>> out;
    for (const plan::Edge& e : map.edges) {
      const std::pair one{map.nodes[e.a].x, map.nodes[e.a].y}, other{map.nodes[e.b].x, map.nodes[e.b].y};
      out.emplace_back(std::min(one, other), std::max(one, other), e.floor, e.wall);
    }
    std::sort(out.begin(), out.end());
    return out;
  };
  return nodes(a) == nodes(b) && edges(a) == edges(b);
}

std::optional<plan::Pose> place_of(const ReleasedMap& map, int number) {
  for (const plan::Node& node : map.nodes)
    if (node.place == number) return plan::Pose{node.x, node.y, 0};
  return std::nullopt;
}

// Does a second paragraph of the same name say the same?
bool same_content(const ReleasedParagraph& a, const ReleasedParagraph& b) {
  return a.map == b.map && a.path == b.path &&
         std::equal(a.sentences.begin(), a.sentences.end(), b.sentences.begin(), b.sentences.end(),
                    [](const ReleasedSentence& s, const ReleasedSentence& t) {
                      return s.text == t.text && s.trace.poses == t.trace.poses;
                    });
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
  explicit Import(const fs::path& directory) : directory_(directory.string()), files_(files_of(directory)) {}

  ImportedCorpus run() {
    read_maps();
    const bool xml = has("SingleSentence.xml") || has("Paragraph.xml");
    const bool settrc =
        std::any_of(files_.begin(), files_.end(), [](const fs::path& f) { return f.extension() == ".settrc"; });
    if (xml)
      read_xml();
    else if (settrc)
      read_traces();
    else
      throw ltl::FormatError(directory_, 0, 0,
                             "holds neither instructions.jsonl, nor, wherever they lie in it, "
                             "SingleSentence.xml, Paragraph.xml or *.settrc");
    if (xml && settrc)
      for (const fs::path& file : files_)
        if (file.extension() == ".settrc") not_read(file, "the release in XML is read");
    out_.format = xml ? "xml" : "settrc";
    write();
    return std::move(out_);
  }

 private:
  bool has(const char* name) const {
    return std::any_of(files_.begin(), files_.end(), [&](const fs::path& f) { return f.filename() == name; });
  }

  void report(const std::string& file, std::size_t line, const char* kind, std::string message) {
    out_.irregularities.push_back({file, line, kind, std::move(message)});
  }
  static void note(ReleasedParagraph& p, const std::string& file, std::size_t line, const char* kind,
                   const std::string& message) {
    p.noted.push_back({file, line, kind, p.id + ": " + message});
  }
  void not_read(const fs::path& file, const std::string& why) { report(file.string(), 1, "not-read", why); }

  void read_maps() {  // the same map may come with several releases: the one with place numbers is kept
    for (const fs::path& file : files_) {
      if (file.extension() != ".xml" || file.filename().string().rfind("map-", 0) != 0) continue;
      ReleasedMap map = parse_xml_map(text_of(file), file.string());
      const auto numbered = [](const ReleasedMap& m) {
        return std::any_of(m.nodes.begin(), m.nodes.end(), [](const plan::Node& n) { return n.place.has_value(); });
      };
      std::set<int> numbers;
      for (const plan::Node& n : map.nodes)
        if (n.place && !numbers.insert(*n.place).second)
          report(map.file, 1, "place-differs", "two nodes are place " + std::to_string(*n.place));
      const auto [at, fresh] = maps_.try_emplace(map.name, map);
      if (fresh) continue;
      if (!same_hallways(map, at->second))
        report(map.file, 1, "maps-differ", "another map " + map.name + " than in " + at->second.file);
      if (numbered(map) && !numbered(at->second)) at->second = std::move(map);
    }
  }

  std::vector<XmlExample> examples(const char* name, std::string& file) {
    std::vector<XmlExample> found;
    for (const fs::path& path : files_) {
      if (path.filename() != name) continue;
      if (file.empty()) {
        file = path.string();
        found = parse_xml_examples(text_of(path), file);
      } else {
        not_read(path, file + " is read");
      }
    }
    return found;
  }

  void read_xml() {
    std::string file;
    const auto wholes = examples("Paragraph.xml", file);
    std::map<std::string, std::size_t> index;  // of paragraphs, by their number
    for (const XmlExample& whole : wholes) {
      if (!index.try_emplace(whole.id, paragraphs_.size()).second)
        throw ltl::FormatError(file, whole.line, 0, "two paragraphs have the number " + whole.id);
      ReleasedParagraph& p = add_paragraph(whole, whole.id, file);
      p.text = whole.text;
      p.start = whole.start, p.goal = whole.end;
      p.path = whole.path;
    }
    file.clear();
    for (const XmlExample& s : examples("SingleSentence.xml", file)) {
      const std::string number = s.id.substr(0, s.id.find('-'));
      const auto [at, alone] = index.try_emplace(number, paragraphs_.size());
      ReleasedParagraph& p = alone ? add_paragraph(s, number, file) : paragraphs_[at->second];
      const auto note_here = [&](const char* kind, const std::string& message) {
        note(p, file, s.line, kind, "sentence " + s.id + " " + message);
      };
      if (alone && !wholes.empty()) note_here("no-paragraph", "has no paragraph in Paragraph.xml");
      if (p.map != s.map) note_here("map-differs", "is on " + s.map + ", its paragraph on " + p.map);
      if (p.id != paragraph_name(s.file_name)) note_here("name-differs", "is of " + s.file_name);
      ReleasedSentence& sentence = p.sentences.emplace_back();
      sentence.id = s.id;
      sentence.text = s.text;
      sentence.trace.poses = s.path;
      sentence.file = file;
      sentence.line = s.line;
    }
    number_places();
  }

  ReleasedParagraph& add_paragraph(const XmlExample& example, const std::string& number, const std::string& file) {
    ReleasedParagraph& p = paragraphs_.emplace_back();
    p.id = paragraph_name(example.file_name);
    p.map = example.map;
    p.number = std::atoi(number.c_str());
    p.file = file;
    p.line = example.line;
    return p;
  }

  // Chen and Mooney's maps do not number the places; the names of the paragraphs do, and where these start and end.
  void number_places() {
    for (ReleasedParagraph& p : paragraphs_) {
      const auto map = maps_.find(p.map);
      const std::size_t dirs = p.id.rfind("_Dirs");
      if (map == maps_.end() || dirs == std::string::npos || dirs < 4) continue;
      const auto put = [&](const std::optional<plan::Pose>& at, char digit) {
        if (!at || digit < '1' || digit > '9') return;
        for (plan::Node& node : map->second.nodes) {
          if (node.x != at->x || node.y != at->y) continue;
          if (!node.place) node.place = digit - '0';
          if (*node.place != digit - '0')
            note(p, p.file, p.line, "place-differs",
                 "(" + std::to_string(node.x) + ", " + std::to_string(node.y) + ") is place " +
                     std::to_string(*node.place) + " already");
        }
      };
      put(p.start, p.id[dirs - 3]);
      put(p.goal, p.id[dirs - 1]);
    }
  }

  void read_traces() {
    for (const fs::path& path : files_) {
      if (path.extension() != ".settrc") continue;
      for (SettrcParagraph& read : parse_settrc(text_of(path), path.string())) {
        ReleasedParagraph& p = read.paragraph;
        p.id = paragraph_name(p.id);
        for (const ReleasedSentence& s : p.sentences) p.text += (p.text.empty() ? "" : " . ") + s.text;
        if (const auto map = maps_.find(p.map); map != maps_.end()) {
          p.start = place(map->second, read.start_place, p);
          p.goal = place(map->second, read.goal_place, p);
        }
        paragraphs_.push_back(std::move(p));
      }
    }
  }

  std::optional<plan::Pose> place(const ReleasedMap& map, int number, ReleasedParagraph& p) {
    const auto at = place_of(map, number);
    if (!at)
      note(p, p.file, p.line, "unknown-place", "the map " + map.name + " has no place " + std::to_string(number));
    return at;
  }

  // A paragraph that comes again, word for word, is left out; one of the same name that differs is kept.
  void leave_out_repeated() {
    std::map<std::string, std::vector<std::size_t>> named;  // paragraphs that are kept, by name
    std::vector<ReleasedParagraph> kept;
    for (ReleasedParagraph& p : paragraphs_) {
      std::vector<std::size_t>& before = named[p.id];
      const auto same =
          std::find_if(before.begin(), before.end(), [&](std::size_t k) { return same_content(kept[k], p); });
      if (same != before.end()) {
        report(p.file, p.line, "repeated", p.id + ": left out, as in " + where(kept[*same]));
        continue;
      }
      if (!before.empty()) note(p, p.file, p.line, "name-twice", "says something else in " + where(kept[before[0]]));
      before.push_back(kept.size());
      kept.push_back(std::move(p));
    }
    paragraphs_ = std::move(kept);
  }
  static std::string where(const ReleasedParagraph& p) { return p.file + ":" + std::to_string(p.line); }

  void write() {
    leave_out_repeated();
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

  std::string directory_;
  std::vector<fs::path> files_;
  std::map<std::string, ReleasedMap> maps_;
  std::vector<ReleasedParagraph> paragraphs_;
  ImportedCorpus out_;
};

// Our own format is checked by reading it, and copied as it is.
ImportedCorpus import_lines(const fs::path& directory) {
  const Corpus corpus = read_sail_corpus(directory);
  const std::string file = (directory / "instructions.jsonl").string();
  ImportedCorpus out;
  out.format = "jsonl";
  out.instructions = read_corpus_file(file);
  out.paragraphs = corpus.paragraphs.size();
  out.sentences = corpus.sentences();
  for (const fs::path& map : map_files(directory)) out.maps.emplace(map.stem().string(), read_corpus_file(map));
  std::map<std::string, ReleasedMap> maps;
  for (const plan::Map& map : corpus.maps) maps.emplace(map.name(), released(map));
  for (auto& [paragraph, start_place, flags] : parse_lines(out.instructions, file)) {
    const auto map = maps.find(paragraph.map);
    if (map != maps.end() && start_place) paragraph.start = place_of(map->second, *start_place);
    auto found = find_irregularities(paragraph, map == maps.end() ? nullptr : &map->second);
    if (maps.empty()) std::erase_if(found, [](const Irregularity& i) { return i.kind == "unknown-map"; });
    for (Irregularity& flag : flags)  // what it says of itself and nobody sees any more
      if (std::none_of(found.begin(), found.end(), [&](const Irregularity& i) { return i.kind == flag.kind; }))
        found.push_back(std::move(flag));
    std::move(found.begin(), found.end(), std::back_inserter(out.irregularities));
  }
  return out;
}

}  // namespace

ImportedCorpus import_sail(const std::filesystem::path& directory) {
  std::error_code unknown;
  if (fs::exists(directory / "instructions.jsonl", unknown)) return import_lines(directory);
  return Import(directory).run();
}

}  // namespace waymark::parser

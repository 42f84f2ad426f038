#include "libplan/model/formats/read_streets.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <vector>

#include "libltl/diagnostic.hpp"
#include "libplan/world/json_reader.hpp"

namespace waymark::plan {
namespace {

using Value = JsonReader::Value;

struct Way {
  std::uint32_t to;
  double metres;
};

class StreetReader {
 public:
  StreetReader(std::string_view text, std::string_view source) : in_(text, source), source_(source) {}

  Mdp read(std::string_view start) {
    const Value document = in_.parse();
    in_.each(document, "", "nodes", [&](const Value& v, const std::string& path) { node(v, path); });
    if (names_.empty()) in_.fail("nodes", "a map without landmarks");
    ways_.resize(names_.size());
    in_.each(document, "", "edges", [&](const Value& v, const std::string& path) { edge(v, path); });
    MdpBuilder builder{ltl::Vocabulary(names_)};
    const auto letter = [&](std::uint32_t s) { return builder.letter({ltl::Proposition{s}}); };
    for (std::uint32_t s = 0; s < names_.size(); ++s) {
      builder.add_state(names_[s]);
      for (const Way& way : ways_[s]) {
        builder.add_choice(names_[way.to], way.metres);
        builder.add_outcome(way.to, letter(way.to));
      }
    }
    const std::uint32_t first = state(start);
    const LetterId first_letter = letter(first);
    return std::move(builder).build(first, first_letter);
  }

 private:
  void node(const Value& value, const std::string& path) {
    const int id = in_.integer(in_.member(value, path, "id"), path + ".id");
    if (!index_.emplace(id, static_cast<std::uint32_t>(names_.size())).second)
      in_.fail(path + ".id", "two landmarks have this id");
    const std::string name = landmark_name(in_.string(in_.member(value, path, "name"), path + ".name"));
    if (name.empty()) in_.fail(path + ".name", "a landmark without a name");
    if (std::find(names_.begin(), names_.end(), name) != names_.end())
      in_.fail(path + ".name", "two landmarks are called " + name);
    names_.push_back(name);
  }

  std::uint32_t end(const Value& value, const std::string& path, const char* key) const {
    const std::string here = path + "." + key;
    const auto at = index_.find(in_.integer(in_.member(value, path, key), here));
    if (at == index_.end()) in_.fail(here, "there is no landmark with that id");
    return at->second;
  }

  void edge(const Value& value, const std::string& path) {
    const std::uint32_t a = end(value, path, "a"), b = end(value, path, "b");
    const double metres = in_.number(in_.member(value, path, "metres"), path + ".metres");
    if (metres < 0) in_.fail(path + ".metres", "a negative length");
    ways_[a].push_back({b, metres});
    ways_[b].push_back({a, metres});
  }

  std::uint32_t state(std::string_view start) const {
    if (start.empty()) return 0;
    for (const auto& [id, s] : index_)
      if (std::to_string(id) == start || names_[s] == start) return s;
    throw ltl::FormatError(source_, 0, 0, "there is no landmark '" + std::string(start) + "'");
  }

  const JsonReader in_;
  std::string_view source_;
  std::map<int, std::uint32_t> index_;  // by id
  std::vector<std::string> names_;
  std::vector<std::vector<Way>> ways_;
};

}  // namespace

std::string landmark_name(std::string_view name) {
  std::string out;
  for (char c : name) {
    if (c == '\'') continue;
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    const bool plain =
        (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || (static_cast<unsigned char>(c) >= 0x80);
    if (plain)
      out += c;
    else if (!out.empty() && out.back() != '_')
      out += '_';
  }
  if (!out.empty() && out.back() == '_') out.pop_back();
  return out;
}

Mdp parse_streets(std::string_view json, std::string_view source, std::string_view start) {
  return StreetReader(json, source).read(start);
}

}  // namespace waymark::plan

#include "libparser/domain/commands/landmark.hpp"

#include <algorithm>

#include "libltl/printable_name.hpp"
#include "libparser/domain/commands/file_text.hpp"
#include "libplan/world/json_reader.hpp"

namespace waymark::parser {
namespace {

using Value = plan::JsonReader::Value;

void check_name(const plan::JsonReader& in, const std::string& name, const std::string& path) {
  if (name.empty()) in.fail(path, "the name of a proposition is empty");
  if (!ltl::is_printable_name(name)) in.fail(path, "the name of a proposition has a control character: " + name);
}

Landmark landmark_of(const plan::JsonReader& in, std::string proposition, const Value& entry, const std::string& path) {
  check_name(in, proposition, path);
  Landmark l{std::move(proposition), in.string_or(entry, path, "name", ""), {}, {}};
  if (const auto* names = in.find(entry, path, "other_names"))
    l.other_names = in.strings(*names, path + ".other_names");
  if (const auto* tags = in.find(entry, path, "tags")) {
    if (!tags->is_object()) in.fail(path + ".tags", "expected an object");
    for (const auto& [key, value] : tags->items())
      if (value.is_string()) l.tags[key] = value.get<std::string>();
  }
  return l;
}

// A proposition without a name is called as it reads.
Landmark named(Landmark landmark) {
  if (!landmark.name.empty()) return landmark;
  landmark.name = landmark.proposition;
  std::replace(landmark.name.begin(), landmark.name.end(), '_', ' ');
  return landmark;
}

}  // namespace

std::vector<Landmark> read_landmarks(const std::filesystem::path& file) {
  const std::string text = text_of(file), source = file.string();
  const plan::JsonReader in(text, source);
  std::vector<Landmark> all;
  in.each(in.parse(), "", "landmarks", [&](const Value& entry, const std::string& path) {
    all.push_back(landmark_of(in, in.string(in.member(entry, path, "prop"), path + ".prop"), entry, path));
  });
  return all;
}

std::vector<Landmark> read_propositions(const std::filesystem::path& file) {
  const std::string text = text_of(file), source = file.string();
  const plan::JsonReader in(text, source);
  const Value document = in.parse();
  const Value& named_ones = in.member(document, "", "propositions");
  std::vector<Landmark> all;
  if (named_ones.is_array()) {  // names alone
    for (const std::string& name : in.strings(named_ones, "propositions")) {
      check_name(in, name, "propositions");
      all.push_back(named({name, "", {}, {}}));
    }
    return all;
  }
  if (!named_ones.is_object()) in.fail("propositions", "expected a list of names, or an object of names");
  for (const auto& [proposition, said] : named_ones.items()) {
    const std::string path = "propositions." + proposition;
    if (!said.is_string() && !said.is_object()) in.fail(path, "expected a description, or an object");
    check_name(in, proposition, "propositions");
    const bool is_description = said.is_string();
    Landmark l = named(is_description ? Landmark{proposition, "", {}, {}} : landmark_of(in, proposition, said, path));
    const std::string description =
        is_description ? said.get<std::string>() : in.string_or(said, path, "description", "");
    if (!description.empty()) l.tags[description_tag] = description;
    all.push_back(std::move(l));
  }
  return all;
}

}  // namespace waymark::parser

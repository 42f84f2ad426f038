#include "libparser/domain/commands/command.hpp"

#include <algorithm>
#include <sstream>

#include "libltl/text/read_text.hpp"
#include "libplan/world/json_reader.hpp"

namespace waymark::parser {
namespace {

std::istringstream open(const std::filesystem::path& file) { return std::istringstream(ltl::read_text(file)); }

// Of one line; every wrong shape is reported with its key.
class CommandReader {
 public:
  CommandReader(std::string_view line, std::string_view source, std::size_t number)
      : in_(line, source, number), object_(in_.parse()) {}

  Command read() const {
    Command c;
    c.id = in_.string(in_.member(object_, "", "id"), "id");
    c.domain = in_.string(in_.member(object_, "", "domain"), "domain");
    c.from = in_.string_or(object_, "", "from", "");
    c.source = in_.string_or(object_, "", "source", "");
    c.type = in_.string_or(object_, "", "type", "free");
    c.n = count("n", 0);
    if (const auto* lifted = in_.find(object_, "", "lifted")) c.lifted = in_.truth(*lifted, "lifted");
    c.text = in_.string(in_.member(object_, "", "text"), "text");
    c.formula = in_.string_or(object_, "", "formula", "");
    c.count = count("count", 1);
    c.suspect = in_.find(object_, "", "suspect") != nullptr;
    if (const auto* names = in_.find(object_, "", "propositions")) c.propositions = in_.strings(*names, "propositions");
    if (const auto* landmarks = in_.find(object_, "", "landmarks")) {
      if (!landmarks->is_object()) in_.fail("landmarks", "expected an object");
      for (const auto& [proposition, words] : landmarks->items())
        c.landmarks[proposition] =
            words.is_null() ? std::nullopt : std::optional(in_.string(words, "landmarks." + proposition));
    }
    c.hand = in_.string_or(object_, "", "hand", "");
    c.style = in_.string_or(object_, "", "style", "");
    if (const auto* things = in_.find(object_, "", "things")) {
      if (!things->is_object()) in_.fail("things", "expected an object");
      for (const auto& [key, name] : things->items()) c.things[key] = in_.string(name, "things." + key);
    }
    const auto* const mentions = in_.find(object_, "", "mentions");
    c.marked = mentions != nullptr;
    if (const auto* also = in_.find(object_, "", "also"); also != nullptr && c.marked)
      c.also = in_.strings(*also, "also");
    if (c.marked)
      for (const auto& mention : *mentions) c.mentions.push_back(marked(mention, c));
    std::stable_sort(c.mentions.begin(), c.mentions.end(),
                     [](const MarkedMention& a, const MarkedMention& b) { return a.begin < b.begin; });
    return c;
  }

 private:
  // [begin, end, thing, negated], in characters of the text.
  MarkedMention marked(const plan::JsonReader::Value& mention, const Command& c) const {
    if (!mention.is_array() || mention.size() != 4)
      in_.fail("mentions", "expected lists of a beginning, an end, a key of things, and whether it is negated");
    const auto byte = [&](const plan::JsonReader::Value& character) {
      const int n = in_.integer(character, "mentions");
      std::size_t at = 0;
      for (int i = 0; i < n && at < c.text.size(); ++i) do
          ++at;
        while (at < c.text.size() && (static_cast<unsigned char>(c.text[at]) & 0xC0U) == 0x80U);
      return at;
    };
    MarkedMention m{byte(mention[0]), byte(mention[1]), in_.string(mention[2], "mentions"),
                    in_.truth(mention[3], "mentions")};
    if (m.begin >= m.end || !c.things.contains(m.thing)) in_.fail("mentions", "names no words, or no thing");
    return m;
  }
  std::size_t count(const std::string& key, std::size_t otherwise) const {
    const auto* const value = in_.find(object_, "", key);
    if (value == nullptr) return otherwise;
    const int number = in_.integer(*value, key);
    if (number < 0) in_.fail(key, "expected a number that is not negative");
    return static_cast<std::size_t>(number);
  }

  plan::JsonReader in_;
  plan::JsonReader::Value object_;
};

}  // namespace

std::vector<Command> read_commands(const std::filesystem::path& file) {
  std::istringstream in = open(file);
  const std::string source = file.string();
  std::vector<Command> all;
  std::size_t number = 0;
  for (std::string line; std::getline(in, line);) {
    ++number;
    if (line.find_first_not_of(" \t\r") == std::string::npos) continue;
    all.push_back(CommandReader(line, source, number).read());
  }
  return all;
}

std::vector<std::string> read_fold(const std::filesystem::path& file) {
  std::istringstream in = open(file);
  std::vector<std::string> ids;
  std::string line;
  std::getline(in, line);
  while (std::getline(in, line))
    if (!line.empty()) ids.push_back(line.substr(0, line.find('\t')));
  return ids;
}

}  // namespace waymark::parser

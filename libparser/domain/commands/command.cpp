#include "libparser/domain/commands/command.hpp"

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
    return c;
  }

 private:
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

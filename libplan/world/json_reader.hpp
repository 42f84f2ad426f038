// A reader of JSON documents of one form. Every error names the value, its line and its column.
//
// Only sources of readers include this header, because the header includes the JSON library. A path such as
// "nodes[3].x" names a value; its position is computed when the value is wrong (json_position.hpp). Unknown keys are
// ignored (documents may carry notes), unless a key resembles a known key that is missing.
#pragma once
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace waymark::plan {

class JsonReader {  // text and source must outlive it
 public:
  using Value = nlohmann::json;
  // The text begins in `first_line` of its file: of JSON Lines, each line is a text.
  JsonReader(std::string_view text, std::string_view source, std::size_t first_line = 1)
      : text_(text), source_(source), first_line_(first_line) {}

  // All throw ltl::FormatError.
  Value parse() const;
  [[noreturn]] void fail(const std::string& path, const std::string& message) const;
  void check_keys(const Value& object, const std::string& path, const std::vector<std::string>& known) const;
  const Value& member(const Value& object, const std::string& path,
                      const std::string& key) const;                                              // must be there
  const Value* find(const Value& object, const std::string& path, const std::string& key) const;  // or nullptr
  std::string string_or(const Value& object, const std::string& path, const std::string& key,
                        const std::string& otherwise) const;
  bool truth(const Value& value, const std::string& path) const;
  int integer(const Value& value, const std::string& path) const;
  double number(const Value& value, const std::string& path) const;  // finite
  std::string string(const Value& value, const std::string& path) const;
  std::vector<std::string> strings(const Value& value, const std::string& path) const;

  template <typename Visit>  // visit(value, path) for every value of the list under `key`
  void each(const Value& object, const std::string& path, const std::string& key, Visit visit) const {
    const std::string here = path.empty() ? key : path + "." + key;
    const Value& list = member(object, path, key);
    if (!list.is_array()) fail(here, "expected a list");
    for (std::size_t i = 0; i < list.size(); ++i) visit(list[i], here + "[" + std::to_string(i) + "]");
  }

  // Runs a step that checks what was read; its complaint is reported at the value it was about.
  template <typename Step>
  void at(const std::string& path, Step step) const {
    try {
      step();
    } catch (const std::invalid_argument& error) {
      fail(path, error.what());
    }
  }

 private:
  std::string_view text_, source_;
  std::size_t first_line_;
};

}  // namespace waymark::plan

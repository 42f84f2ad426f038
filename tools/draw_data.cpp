#include "tools/draw_data.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <vector>

#include "libltl/diagnostic.hpp"
#include "libplan/world/json_reader.hpp"
#include "tools/render/learning_curves.hpp"
#include "tools/render/table_picture.hpp"

namespace waymark::tools {
namespace {

using plan::JsonReader;
using Value = nlohmann::ordered_json;
constexpr std::size_t most_rows = 1000, most_columns = 40;

std::string cell(double number) {
  std::array<char, 40> text{};
  return {text.data(),
          std::to_chars(text.data(), text.data() + text.size(), number, std::chars_format::general, 4).ptr};
}

// An estimate with its interval is one cell; lists and other objects are none.
std::string cell(const Value& value) {
  if (value.is_null()) return "";
  if (value.is_string()) return value.get<std::string>();
  if (value.is_boolean()) return value.get<bool>() ? "yes" : "no";
  if (value.is_number_float()) return cell(value.get<double>());
  if (value.is_number()) return value.dump();
  if (value.is_object() && value.contains("estimate") && value.contains("low") && value.contains("high"))
    return cell(value["estimate"]) + " [" + cell(value["low"]) + ", " + cell(value["high"]) + "]";
  return "";
}
bool is_cell(const Value& value) { return !value.is_array() && (!value.is_object() || value.contains("estimate")); }

class TableReader {
 public:
  TableReader(std::string_view text, std::string_view source) : text_(text), source_(source) {}

  render::Table read() {
    const std::size_t first = text_.find_first_not_of(" \t\r\n");
    if (first == std::string_view::npos) fail(0, "there is no table");
    if (text_[first] == '{' || text_[first] == '[')
      json();
    else
      separated();
    if (out_.columns.empty()) fail(0, "there is no table: no row has a text or a number");
    if (out_.columns.size() > most_columns) fail(0, "expected at most 40 columns");
    for (auto& row : out_.rows) row.resize(out_.columns.size());
    return std::move(out_);
  }

 private:
  [[noreturn]] void fail(std::size_t line, const std::string& message) const {
    throw ltl::FormatError(source_, line, 0, message);
  }
  void add_row(std::vector<std::string> row, std::size_t line) {
    if (out_.rows.size() == most_rows) fail(line, "expected at most 1,000 rows");
    out_.rows.push_back(std::move(row));
  }

  void json() {
    try {
      const Value document = Value::parse(text_, nullptr, false);
      if (!document.is_discarded()) return document_of(document);
      std::size_t line = 0;
      for (std::string_view rest = text_; !rest.empty();) {
        const std::string_view text = rest.substr(0, rest.find('\n'));
        rest.remove_prefix(std::min(text.size() + 1, rest.size()));
        ++line;
        if (text.find_first_not_of(" \t\r") == std::string_view::npos) continue;
        const Value object = Value::parse(text, nullptr, false);
        if (!object.is_object()) fail(line, "expected a JSON object on each line");
        add_object(object, line);
      }
    } catch (const nlohmann::json::out_of_range&) {
      fail(0, "a number of the JSON text is out of range");
    }
  }
  void document_of(const Value& document) {
    for (const char* key : {"methods", "rows"})
      if (document.is_object() && document.contains(key) && document[key].is_array()) {
        if (document.contains("formula")) out_.title = cell(document["formula"]);
        return document_of(document[key]);
      }
    if (document.is_object()) return add_object(document, 1);
    for (const Value& row : document) {
      if (!row.is_object()) fail(0, "expected a list of objects");
      add_object(row, 0);
    }
  }
  void add_object(const Value& object, std::size_t line) {
    std::vector<std::string> row(out_.columns.size());
    for (const auto& [key, value] : object.items()) {
      if (!is_cell(value)) continue;
      const auto at = std::find(out_.columns.begin(), out_.columns.end(), key);
      if (at == out_.columns.end()) {
        out_.columns.push_back(key);
        row.push_back(cell(value));
      } else {
        row[static_cast<std::size_t>(at - out_.columns.begin())] = cell(value);
      }
    }
    add_row(std::move(row), line);
  }

  // One record at a time; a quoted field may hold the separator and ends of lines.
  void separated() {
    const char separator = text_.substr(0, text_.find('\n')).find('\t') == std::string_view::npos ? ',' : '\t';
    std::size_t at = 0, line = 1;
    while (at < text_.size()) {
      std::vector<std::string> record(1);
      const std::size_t begins = line;
      bool quoted = false;
      for (; at < text_.size() && (quoted || text_[at] != '\n'); ++at) {
        const char c = text_[at];
        if (c == '\n') ++line;
        if (c == '"' && quoted && at + 1 < text_.size() && text_[at + 1] == '"')
          record.back() += text_[++at];
        else if (c == '"' && (quoted || record.back().empty()))
          quoted = !quoted;
        else if (c == separator && !quoted)
          record.emplace_back();
        else if (c != '\r' || quoted)
          record.back() += c;
      }
      ++at, ++line;
      if (quoted) fail(begins, "a quotation mark is not closed");
      if (record.size() == 1 && record[0].empty()) continue;
      if (out_.columns.empty())
        out_.columns = std::move(record);
      else if (record.size() != out_.columns.size())
        fail(begins, "expected " + std::to_string(out_.columns.size()) + " fields, as in the heading");
      else
        add_row(std::move(record), begins);
    }
  }

  std::string_view text_, source_;
  render::Table out_;
};

}  // namespace

std::string curves_picture(std::string_view text, std::string_view source) {
  const std::size_t end = std::min(text.find("\n{"), text.size());  // of the first answer
  const JsonReader in(text.substr(0, end), source);
  const JsonReader::Value answer = in.parse();
  render::CurvePlot plot{"", "means with 95 % intervals", {}};
  if (answer.is_object() && answer.contains("formula") && answer["formula"].is_string()) plot.title = answer["formula"];
  if (answer.is_object() && answer.contains("map") && answer["map"].is_string())
    plot.caption = "map " + answer["map"].get<std::string>() + ", " + plot.caption;
  in.each(answer, "", "methods", [&](const JsonReader::Value& method, const std::string& path) {
    const std::string name = in.string(in.member(method, path, "method"), path + ".method");
    if (!method.contains("curve")) {
      plot.exact.push_back(name);
      return;
    }
    render::Curve curve{name, {}};
    in.each(method, path, "curve", [&](const JsonReader::Value& point, const std::string& here) {
      if (!point.is_array() || point.size() != 4) in.fail(here, "expected a point [steps, score, low, high]");
      const auto number = [&](std::size_t i) { return in.number(point[i], here + "[" + std::to_string(i) + "]"); };
      curve.points.push_back({number(0), number(1), number(2), number(3)});
    });
    plot.curves.push_back(std::move(curve));
  });
  if (plot.curves.empty()) in.fail("methods", "no method has a curve");
  return render::draw_curves(plot);
}

std::string table_picture(std::string_view text, std::string_view source) {
  return render::draw_table(TableReader(text, source).read());
}

}  // namespace waymark::tools

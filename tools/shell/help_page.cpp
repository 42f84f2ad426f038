#include "tools/shell/help_page.hpp"

#include <algorithm>
#include <sstream>

#include "libltl/diagnostic.hpp"

namespace waymark::tools {
namespace {

constexpr std::size_t least_column = 16, greatest_column = 32;

std::string joined(const std::vector<std::string>& parts, std::string_view between) {
  std::string out;
  for (const std::string& part : parts) out += (out.empty() ? "" : std::string(between)) + part;
  return out;
}

std::string left_of(const OptionText& option) {
  std::string out = option.names.empty() ? option.place : joined(option.names, ", ");
  if (!option.value.empty()) out += ' ' + option.value;
  return out;
}

// What the option does, then in brackets what it may be and what it is by default.
std::string right_of(const OptionText& option) {
  std::vector<std::string> facts;
  if (!option.choices.empty()) facts.push_back(joined(option.choices, ", "));
  if (!option.fallback.empty()) facts.push_back("default " + option.fallback);
  if (option.required) facts.emplace_back("required");
  return option.help + (facts.empty() ? "" : " [" + joined(facts, "; ") + ']');
}

using Rows = std::vector<std::pair<std::string, std::string>>;

// Names in a column, what they do beside them; a name that is too wide has its line for itself.
std::vector<std::string> table(const Rows& rows, std::size_t column) {
  std::vector<std::string> out;
  for (const auto& [name, help] : rows) {
    std::string line = "  " + name;
    std::istringstream paragraphs(help);
    bool first = true;
    for (std::string paragraph; std::getline(paragraphs, paragraph);) {
      const std::size_t inner = std::min(paragraph.find_first_not_of(' '), paragraph.size());
      for (const std::string& part : lines_of(paragraph, help_columns - column - inner)) {
        const std::size_t used = first ? ltl::utf8_length(line) : 0;
        if (first && used + 1 > column) {
          out.push_back(line);
          line = std::string(column, ' ');
        } else if (first) {
          line += std::string(column - used, ' ');
        } else {
          line = std::string(column, ' ');
        }
        out.push_back(line + std::string(inner, ' ') + part);
        first = false;
      }
    }
    if (first) out.push_back(line);
  }
  return out;
}

std::size_t column_of(const Rows& rows) {
  std::size_t widest = least_column;
  for (const auto& [name, help] : rows) {
    const std::size_t width = ltl::utf8_length(name) + 4;
    if (width <= greatest_column) widest = std::max(widest, width);
  }
  return widest;
}

struct Group {
  std::string name;
  Rows rows;
};

std::vector<Group> groups_of(const std::vector<OptionText>& options) {
  std::vector<Group> out;
  for (const OptionText& option : options) {
    const std::string name = option.names.empty() ? "Arguments" : option.group;
    auto at = std::find_if(out.begin(), out.end(), [&](const Group& group) { return group.name == name; });
    if (at == out.end()) at = out.insert(out.end(), {name, {}});
    at->rows.emplace_back(left_of(option), right_of(option));
  }
  return out;
}

}  // namespace

std::vector<std::string> lines_of(std::string_view text, std::size_t columns) {
  std::vector<std::string> out;
  std::istringstream words{std::string(text)};
  std::string line;
  for (std::string word; words >> word;) {
    if (!line.empty() && ltl::utf8_length(line) + 1 + ltl::utf8_length(word) > columns) {
      out.push_back(std::move(line));
      line.clear();
    }
    line += (line.empty() ? "" : " ") + word;
  }
  if (!line.empty()) out.push_back(std::move(line));
  return out;
}

std::string help_page(const HelpText& text, bool all) {
  std::vector<std::string> page = lines_of(text.summary, help_columns);
  page.push_back("Usage: " + text.usage);
  std::vector<Group> groups = groups_of(text.options);
  if (!text.commands.empty()) groups.push_back({"Subcommands", text.commands});
  Rows every;
  for (const Group& group : groups) every.insert(every.end(), group.rows.begin(), group.rows.end());
  const std::size_t column = column_of(every);
  std::vector<std::string> closing;
  std::istringstream examples(text.examples);
  for (std::string line; std::getline(examples, line);) closing.push_back(line);
  constexpr std::size_t foot = 4;  // blank, hidden groups on two lines, blank
  std::string hidden;
  for (const Group& group : groups) {
    const std::vector<std::string> lines = table(group.rows, column);
    if (!all && page.size() + lines.size() + 2 + foot + closing.size() > help_lines) {
      hidden += (hidden.empty() ? "" : ", ") + group.name + " (" + std::to_string(group.rows.size()) + ")";
      continue;
    }
    page.emplace_back();
    page.push_back(group.name + ":");
    page.insert(page.end(), lines.begin(), lines.end());
  }
  if (!hidden.empty()) {
    page.emplace_back();
    const auto lines = lines_of("More options by --help-all: " + hidden, help_columns);
    page.insert(page.end(), lines.begin(), lines.end());
  }
  if (!closing.empty()) page.emplace_back();
  page.insert(page.end(), closing.begin(), closing.end());
  std::string out;
  for (const std::string& line : page) out += line + '\n';
  return out;
}

}  // namespace waymark::tools

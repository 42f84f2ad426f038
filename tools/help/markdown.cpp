#include "tools/help/markdown.hpp"

#include <algorithm>
#include <cctype>
#include <sstream>
#include <vector>

#include "libltl/diagnostic.hpp"
#include "tools/shell/help_page.hpp"

namespace waymark::tools {
namespace {

constexpr std::size_t indent = 2, between = 2;  // of paragraphs; of the columns of a table

// Without marks: `code`, **bold**, *emphasis* and [text](address) become their text. Inside code only \| is a mark.
std::string plain(std::string_view text) {
  std::string out;
  bool code = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (c == '\\' && i + 1 < text.size() && (text[i + 1] == '|' || (!code && std::ispunct(text[i + 1]) != 0))) {
      out += text[++i];
    } else if (c == '`') {
      code = !code;
    } else if (!code && c == '*' && text.substr(i, 2) == "**") {
      ++i;
    } else if (!code && c == '*' && i + 1 < text.size() && text[i + 1] != ' ' &&
               text.find('*', i + 1) != std::string_view::npos) {
      const auto end = text.find('*', i + 1);
      out += text.substr(i + 1, end - i - 1);
      i = end;
    } else if (!code && c == '[' && text.find("](", i) != std::string_view::npos) {
      const auto middle = text.find("](", i), end = text.find(')', middle);
      out += plain(text.substr(i + 1, middle - i - 1));
      i = std::min(end, text.size() - 1);
    } else {
      out += c;
    }
  }
  return out;
}

std::vector<std::string> cells_of(std::string_view row) {
  std::vector<std::string> out;
  std::string cell;
  for (std::size_t i = 1; i < row.size(); ++i) {
    if (row[i] == '\\' && i + 1 < row.size()) {
      cell += row[i];
      cell += row[++i];
    } else if (row[i] == '|') {
      const auto from = cell.find_first_not_of(' '), to = cell.find_last_not_of(' ');
      out.push_back(from == std::string::npos ? "" : plain(std::string_view(cell).substr(from, to - from + 1)));
      cell.clear();
    } else {
      cell += row[i];
    }
  }
  return out;
}

class Page {
 public:
  Page(std::size_t columns, const Terminal& terminal) : columns_(columns), terminal_(terminal) {}

  void read(std::string_view markdown) {
    std::istringstream lines{std::string(markdown)};
    bool code = false;
    for (std::string line; std::getline(lines, line);) {
      if (line.starts_with("```")) {
        flush();
        code = !code;
        if (!code) blank();
      } else if (code) {
        write("    " + line);
      } else if (line.empty()) {
        flush();
      } else if (line[0] == '#') {
        flush();
        heading(line);
      } else if (line[0] == '|') {
        if (!paragraph_.empty()) flush();
        table_.push_back(line);
      } else {
        if (!table_.empty()) flush();
        if (is_item(line)) flush(false);
        paragraph_ += (paragraph_.empty() ? "" : " ") + line;
      }
    }
    flush();
  }
  std::string text() && {
    while (out_.ends_with("\n\n")) out_.pop_back();
    return std::move(out_);
  }

 private:
  static bool is_item(std::string_view line) {
    const auto digits = line.find_first_not_of("0123456789");
    return line.starts_with("- ") || (digits > 0 && digits < line.size() && line.substr(digits).starts_with(". "));
  }
  void write(const std::string& line) { out_ += line + '\n'; }
  void blank() {
    if (!out_.empty() && !out_.ends_with("\n\n")) out_ += '\n';
  }

  void heading(const std::string& line) {
    const std::size_t depth = line.find_first_not_of('#');
    const std::string text = plain(std::string_view(line).substr(std::min(depth + 1, line.size())));
    blank();
    write(terminal_.paint(Paint::Bold, text));
  }

  void flush(bool ends_block = true) {
    if (!paragraph_.empty()) {
      const bool item = is_item(paragraph_);
      const std::string text = plain(paragraph_);
      const std::size_t hang = item ? text.find(' ') + 1 : 0;
      bool first = true;
      for (const std::string& line : lines_of(text, columns_ - indent - hang)) {
        write(std::string(indent + (first ? 0 : hang), ' ') + line);
        first = false;
      }
      if (ends_block) blank();
    }
    paragraph_.clear();
    if (!table_.empty()) table();
    table_.clear();
  }

  static bool is_rule(const std::string& row) { return row.find_first_not_of("|-: ") == std::string::npos; }

  // Columns as wide as they need; where that is too wide, the widest gives way.
  std::vector<std::size_t> widths(const std::vector<std::vector<std::string>>& rows) const {
    std::vector<std::size_t> out;
    for (const auto& row : rows) {
      out.resize(std::max(out.size(), row.size()));
      for (std::size_t i = 0; i < row.size(); ++i) out[i] = std::max(out[i], ltl::utf8_length(row[i]));
    }
    const auto total = [&] {
      std::size_t sum = indent;
      for (const std::size_t width : out) sum += width + between;
      return sum - between;
    };
    constexpr std::size_t least = 12;
    while (!out.empty() && total() > columns_) {
      auto& widest = *std::max_element(out.begin(), out.end());
      if (widest <= least) break;
      --widest;
    }
    return out;
  }

  void table() {
    std::vector<std::vector<std::string>> rows;
    for (const std::string& line : table_)
      if (!is_rule(line)) rows.push_back(cells_of(line));
    const auto wide = widths(rows);
    for (std::size_t r = 0; r < rows.size(); ++r) {
      std::vector<std::vector<std::string>> cells;
      std::size_t height = 1;
      for (std::size_t i = 0; i < rows[r].size(); ++i) {
        cells.push_back(lines_of(rows[r][i], wide[i]));
        height = std::max(height, cells.back().size());
      }
      for (std::size_t h = 0; h < height; ++h) {
        std::string line(indent, ' ');
        for (std::size_t i = 0; i < cells.size(); ++i) {
          const std::string cell = h < cells[i].size() ? cells[i][h] : "";
          line += cell;
          if (i + 1 < cells.size())
            line += std::string(wide[i] + between - std::min(wide[i], ltl::utf8_length(cell)), ' ');
        }
        line.erase(line.find_last_not_of(' ') + 1);
        write(r == 0 ? terminal_.paint(Paint::Dim, line) : line);
      }
    }
    blank();
  }

  std::size_t columns_;
  const Terminal& terminal_;
  std::string out_, paragraph_;
  std::vector<std::string> table_;
};

}  // namespace

std::string readable(std::string_view markdown, std::size_t columns, const Terminal& terminal) {
  Page page(columns, terminal);
  page.read(markdown);
  return std::move(page).text();
}

}  // namespace waymark::tools

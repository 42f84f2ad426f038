#include "tools/shell/options.hpp"

#include <iostream>
#include <utility>

#include "libltl/diagnostic.hpp"
#include "libltl/text/dialect.hpp"
#include "libltl/text/foreign.hpp"
#include "libltl/text/print.hpp"
#include "libplan/world/trajectory.hpp"
#include "tools/shell/data_directory.hpp"

namespace waymark::tools {

void add_data_option(Command command, std::string& data) {
  command.add_option("--data", data, "directory of maps and models (else $WAYMARK_DATA, else beside the executable)")
      .type_name("DIR");
}

void add_map_options(Command command, MapOptions& options) {
  command = command.in("Map");
  command.add_option("-m,--map", options.map, "a map that comes with waymark (grid, jelly, l) or a file")
      .type_name("MAP")
      .show_default();
  add_data_option(command, options.data);
}

plan::Map read_map(const MapOptions& options) { return plan::read_map(options.map, data_directory(options.data)); }

void add_start_option(Command command, std::string& start) {
  command = command.in("Map");
  command.add_option("--start", start, "start pose; x,y alone: any heading (else the first place, facing north)")
      .type_name("X,Y,HEADING");
}

std::vector<plan::PoseId> start_poses(const std::string& start, const plan::Map& map) {
  if (!start.empty()) return plan::parse_start(start, map);
  std::uint32_t best = 0;
  const auto& nodes = map.nodes();
  for (std::uint32_t node = 1; node < nodes.size(); ++node)
    if (nodes[node].place && (!nodes[best].place || *nodes[node].place < *nodes[best].place)) best = node;
  return {plan::PoseId{4 * best}};
}

void add_text_options(Command command, TextOptions& options, const std::string& what) {
  command.add_option(what, options.arguments, "the " + what + "; - or nothing: standard input, one a line")
      .type_name("TEXT");
  command.add_option("-F,--file", options.file, "read from a file, one " + what + " a line; - is standard input")
      .type_name("FILE");
}

void add_notation_options(Command command, NotationOptions& options) {
  command = command.in("Formulas");
  command
      .add_option("--dialect", options.dialect,
                  "whose spelling formulas have; of spot, X is weak at the end of a finite word")
      .one_of({"waymark", "spot", "nusmv", "psl"})
      .show_default();
  command.add_option("--notation", options.notation, "how formulas are written")
      .one_of({"infix", "lbt", "postfix"})
      .show_default();
}

ltl::ParseOptions parse_options(const NotationOptions& options, ltl::Unknown unknown) {
  return {.dialect = options.dialect == "spot"    ? ltl::Dialect::Spot
                     : options.dialect == "nusmv" ? ltl::Dialect::Nusmv
                     : options.dialect == "psl"   ? ltl::Dialect::Psl
                                                  : ltl::Dialect::Waymark,
          .notation = options.notation == "lbt"       ? ltl::Notation::Lbt
                      : options.notation == "postfix" ? ltl::Notation::Postfix
                                                      : ltl::Notation::Infix,
          .unknown = unknown};
}

namespace {

// New names that look like operators run into a name are read as names, and not in silence.
void note_doubtful_names(std::size_t known, const ltl::Vocabulary& names, const ltl::ParseOptions& options) {
  if (options.dialect != ltl::Dialect::Waymark || options.notation != ltl::Notation::Infix) return;
  for (std::size_t i = known; i < names.size(); ++i)
    if (const std::string apart = ltl::spelled_apart(names.names()[i]); !apart.empty())
      std::cerr << "note: '" + names.names()[i] + "' is read as one proposition (did you mean '" + apart +
                       "'? --dialect spot reads it so)\n";
}

}  // namespace

ltl::Formula parse_formula(const Text& text, ltl::Arena& arena, const ltl::ParseOptions& options, bool notes) {
  const std::size_t known = arena.vocabulary().size();
  try {
    const ltl::Formula read = ltl::parse(text.text, arena, options);
    if (notes) note_doubtful_names(known, arena.vocabulary(), options);
    return read;
  } catch (const ltl::SyntaxError& error) {
    if (const std::string hint = ltl::foreign_hint(text.text); !hint.empty())
      throw ltl::FormatError(text.source, text.source.empty() ? 0 : text.line, 0, "expected a formula: " + hint);
    if (text.source.empty()) throw;
    throw error.in(text.source, text.line);
  }
}

std::string as_typed(const Text& text, ltl::Formula formula, const NotationOptions& options) {
  if (options.dialect != "waymark" || options.notation != "infix") return ltl::print(formula);
  std::string out;
  bool quoted = false, blank = false;
  for (const char c : text.text) {
    if (!quoted && (c == ' ' || c == '\t' || c == '\n' || c == '\r')) {
      blank = !out.empty();
      continue;
    }
    if (std::exchange(blank, false)) out += ' ';
    if (c == '"' && (out.empty() || out.back() != '\\')) quoted = !quoted;
    out += c;
  }
  return out;
}

ltl::Formula parse_on_map(const Text& text, ltl::Arena& arena, const NotationOptions& options, const std::string& map) {
  try {
    return parse_formula(text, arena, parse_options(options, ltl::Unknown::Reject));
  } catch (const ltl::SyntaxError& error) {
    if (!error.message().starts_with("unknown proposition")) throw;
    throw ltl::SyntaxError(text.text, error.where(), error.message() + "; waymark map " + map + " lists all",
                           text.source, text.source.empty() ? 1 : text.line);
  }
}

void add_letter_format_option(Command command, std::string& format) {
  command.add_option("--letter-format", format, "how letters are written: text, JSON lines, CSV with a header")
      .one_of({"auto", "text", "json", "csv"})
      .show_default();
}

void add_time_unit_option(Command command, double& unit) {
  command
      .add_option("--time-unit", unit,
                  "of a table with a column time: a step is so much time, and a row holds until the next one")
      .type_name("T");
}

plan::LetterFormat letter_format(const std::string& name) {
  if (name == "text") return plan::LetterFormat::Text;
  if (name == "json") return plan::LetterFormat::Json;
  return name == "csv" ? plan::LetterFormat::Csv : plan::LetterFormat::Auto;
}

}  // namespace waymark::tools

// Options that several subcommands share, so that they are spelled and explained in one way.
#pragma once
#include <string>
#include <vector>

#include "libltl/text/parse.hpp"
#include "libplan/world/letter_lines.hpp"
#include "libplan/world/read_map.hpp"
#include "tools/shell/command.hpp"
#include "tools/shell/input.hpp"

namespace waymark::tools {

struct MapOptions {
  std::string map = "grid";
  std::string data;
};
void add_map_options(Command command, MapOptions& options);
void add_data_option(Command command, std::string& data);
plan::Map read_map(const MapOptions& options);

void add_start_option(Command command, std::string& start);
// Of --start; without it, the place with the lowest number (else the first node), facing north.
std::vector<plan::PoseId> start_poses(const std::string& start, const plan::Map& map);

// `what`: "formula" or "instruction", the name of the positional argument.
void add_text_options(Command command, TextOptions& options, const std::string& what);

struct NotationOptions {
  std::string dialect = "waymark";
  std::string notation = "infix";
};
void add_notation_options(Command command, NotationOptions& options);
ltl::ParseOptions parse_options(const NotationOptions& options, ltl::Unknown unknown);

// The formula of one text; errors name the file and line that it came from. Notes on names such as GFa go to standard
// error, unless the text is read a second time.
ltl::Formula parse_formula(const Text& text, ltl::Arena& arena, const ltl::ParseOptions& options, bool notes = true);
// The formula as it was typed, blanks made one; in other notations and dialects as we print it.
std::string as_typed(const Text& text, ltl::Formula formula, const NotationOptions& options);
// Over the names of a map; the error of another name says where they are listed. `map`: as --map has it.
ltl::Formula parse_on_map(const Text& text, ltl::Arena& arena, const NotationOptions& options, const std::string& map);

// --letter-format, and what its value means.
void add_letter_format_option(Command command, std::string& format);
plan::LetterFormat letter_format(const std::string& name);
// --time-unit of tables with a column time; without it there is a note.
void add_time_unit_option(Command command, double& unit);
inline constexpr const char* note_of_time =
    "note: rows are steps; with --time-unit, the column time says how many steps pass between them\n";

}  // namespace waymark::tools

// The files that a picture is written to: SVG, and what waymark-convert makes of it.
#pragma once
#include <string>

#include "tools/shell/command.hpp"

namespace waymark::tools {

struct PictureFiles {
  std::string svg = {}, png = {}, pdf = {};  // empty: none; "-": standard output
  bool given() const { return !svg.empty() || !png.empty() || !pdf.empty(); }
  double scale = 2;  // pixels of PNG for each unit of the picture, which is 1/96 inch
};
void add_picture_options(Command command, PictureFiles& files);

// Before the work: is a file named, and can it be written? Throws UsageError when none is, or when the helper
// waymark-convert is needed and not installed; ltl::FormatError when a file cannot be written.
void check_picture_files(const PictureFiles& files);

// Writes the SVG document to all of them. Throws ltl::FormatError naming the file that cannot be written, UsageError
// without waymark-convert, std::runtime_error when the helper fails.
void write_picture(const std::string& svg, const PictureFiles& files);

}  // namespace waymark::tools

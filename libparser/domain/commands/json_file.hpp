// A file of one JSON value.
#pragma once
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "libltl/diagnostic.hpp"

namespace waymark::parser {

// Throws ltl::FormatError when it cannot be read, or is no JSON.
inline nlohmann::json read_json(const std::filesystem::path& file) {
  std::ifstream in(file);
  if (!in) throw ltl::FormatError(file.string(), 0, 0, "cannot be read");
  try {
    return nlohmann::json::parse(in);
  } catch (const nlohmann::json::exception& e) {
    throw ltl::FormatError(file.string(), 0, 0, e.what());
  }
}

}  // namespace waymark::parser

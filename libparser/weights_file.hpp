// The weights file: a trained model in one portable binary file. Layout: docs/formats/corpus-and-models.md.
//
// Little endian; magic, version, vocabulary, words, and for each table its rows with only the weights that matter,
// as 16-bit floats; an FNV-1a checksum at the end. Saving is lossy once: what is loaded saves to the same bytes.
#pragma once
#include <filesystem>
#include <string>
#include <string_view>

#include "libparser/linear_model.hpp"

namespace waymark::parser {

inline constexpr double least_weight = 0.02;
// Weights smaller than `threshold` in absolute value are dropped.
std::string serialize(const LinearModel& model, double threshold = least_weight);
// The same with the threshold raised by quarters until the file fits; `bytes` must leave room for the words.
inline constexpr std::size_t most_bytes = 3'000'000;
std::string serialize_within(const LinearModel& model, std::size_t bytes);
// Throws ltl::FormatError when it is no weights file, of another version, cut short or altered.
LinearModel parse_linear_model(std::string_view bytes, std::string_view source = "");

// Written to a temporary name and renamed. Throws ltl::FormatError when the file cannot be written.
void save(const LinearModel& model, const std::filesystem::path& file);
LinearModel load_linear_model(const std::filesystem::path& file);  // throws ltl::FormatError

}  // namespace waymark::parser

// The model file: a trained model in one file that is mapped, not read. Layout: docs/formats/corpus-and-models.md.
//
// Little endian. Tables keep the weights that matter as 16-bit floats and are looked up where they lie; networks are
// whole, in float32; XXH64 at the end. Saving is lossy once: what is loaded saves to the same bytes.
#pragma once
#include <filesystem>
#include <string>
#include <string_view>

#include "libparser/decode/grounder.hpp"

namespace waymark::parser {

inline constexpr double least_weight = 0.0085;  // smaller weights of the linear model are left out
// Of the reranker and the start-pose model, whose many small weights add up, the threshold is this share of what it is
// for others.
inline constexpr double least_of_rerankers = 0.6;
inline constexpr std::size_t most_bytes = 24'000'000;

// Weights of tables smaller than `threshold` in absolute value are dropped.
std::string serialize(const Grounder& grounder, double threshold = least_weight);
// The same with the threshold raised by quarters until the file fits; `bytes` must leave room for the rest.
std::string serialize_within(const Grounder& grounder, std::size_t bytes);

// These throw ltl::FormatError when it is no model file, of another version, cut short or altered.
Grounder parse_grounder(std::string_view bytes, std::string_view source = "");
Grounder load_grounder(const std::filesystem::path& file);

// Within most_bytes; to a temporary name that is renamed. Throws ltl::FormatError when the file cannot be written.
void save(const Grounder& grounder, const std::filesystem::path& file);

}  // namespace waymark::parser

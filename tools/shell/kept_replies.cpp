#include "tools/shell/kept_replies.hpp"

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <iterator>

#include "libltl/diagnostic.hpp"
#include "libltl/text/xxhash.hpp"
#include "tools/shell/packed.hpp"

namespace waymark::tools {
namespace {

constexpr std::string_view suffix = ".replies";

std::string name_of(std::size_t first, std::size_t count) {
  return std::to_string(first) + '-' + std::to_string(count) + std::string(suffix);
}

struct Range {
  std::size_t first = 0, count = 0;
};

std::optional<Range> range_of(std::string_view name) {
  if (!name.ends_with(suffix)) return std::nullopt;
  name.remove_suffix(suffix.size());
  Range range;
  const char* const end = name.data() + name.size();
  const auto [dash, bad_first] = std::from_chars(name.data(), end, range.first);
  if (bad_first != std::errc() || dash == end || *dash != '-') return std::nullopt;
  const auto [last, bad_count] = std::from_chars(dash + 1, end, range.count);
  if (bad_count != std::errc() || last != end || range.count == 0) return std::nullopt;
  return range;
}

// Line numbers are part of a reply to a text.
std::uint64_t checksum(std::span<const Text> texts) {
  Packed all;
  for (const Text& text : texts) all.number(text.line).text(text.text);
  return ltl::xxh64(all.bytes());
}

}  // namespace

KeptReplies::KeptReplies(const std::string& folder, const std::string& settings)
    : folder_(folder), parts_(folder, settings) {
  std::error_code error;
  for (const auto& entry : std::filesystem::directory_iterator(folder, error)) {
    const auto range = range_of(entry.path().filename().string());
    if (range) counts_[range->first] = std::max(counts_[range->first], range->count);
  }
  if (error) throw ltl::FormatError(folder, 0, 0, "cannot be read: " + error.message());
}

std::size_t KeptReplies::count_from(std::size_t first) const {
  const auto found = counts_.find(first);
  return found == counts_.end() ? 0 : found->second;
}

std::size_t KeptReplies::begin_of_part(std::size_t text) const {
  const auto after = counts_.upper_bound(text);
  if (after == counts_.begin()) return text;
  const auto& [first, count] = *std::prev(after);
  return first + count > text ? first : text;
}

std::optional<std::vector<Reply>> KeptReplies::find(std::size_t first, std::span<const Text> texts) const {
  const auto bytes = parts_.find_text(name_of(first, texts.size()));
  if (!bytes) return std::nullopt;
  Unpacked part(*bytes);
  if (part.number() != checksum(texts))
    throw ltl::FormatError(folder_, 0, 0,
                           "holds answers to other texts, from line " + std::to_string(texts.front().line) +
                               " on: name another folder, or remove it");
  std::vector<Reply> replies(texts.size());
  for (Reply& reply : replies) reply = unpack_reply(part);
  return replies;
}

void KeptReplies::keep(std::size_t first, std::span<const Text> texts, std::span<const Reply> replies) const {
  if (texts.empty()) return;
  Packed part;
  part.number(checksum(texts));
  for (const Reply& reply : replies) pack(part, reply);
  parts_.keep_text(name_of(first, texts.size()), part.bytes());
}

}  // namespace waymark::tools

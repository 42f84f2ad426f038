#include "tools/shell/dealt_texts.hpp"

#include <charconv>
#include <chrono>
#include <limits>
#include <utility>

#include "libltl/diagnostic.hpp"
#include "tools/shell/chunk_size.hpp"

namespace waymark::tools {
namespace {

constexpr std::size_t most_part_bytes = std::size_t{16} << 20U;

struct Share {
  std::size_t number = 1, of = 1;
};

Share share_of(const std::string& text) {
  if (text.empty()) return {};
  Share share;
  const char* const end = text.data() + text.size();
  const auto [slash, bad_number] = std::from_chars(text.data(), end, share.number);
  const bool has_of = bad_number == std::errc() && slash != end && *slash == '/';
  const auto [last, bad_of] = std::from_chars(has_of ? slash + 1 : end, end, share.of);
  if (!has_of || bad_of != std::errc() || last != end || share.number < 1 || share.number > share.of)
    throw UsageError("--share '" + text + "': expected NUMBER/OF, from 1/OF to OF/OF");
  return share;
}

// The begin of share i of n, i from 0, without overflow: ⌊i·count/n⌋.
std::size_t begin_of(std::size_t i, std::size_t n, std::size_t count) { return count / n * i + count % n * i / n; }

double now() { return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(); }

}  // namespace

void add_deal_options(Command command, DealOptions& options) {
  command
      .add_option("--share", options.share,
                  "answer the NUMBER-th of OF parts of the texts; the answers to all parts, one after the other, are "
                  "those to all texts")
      .type_name("NUMBER/OF");
  command
      .add_option("--kept", options.kept,
                  "where answers are kept, and found again by the same command; several processes may share it")
      .type_name("DIR");
}

bool has_first_share(const DealOptions& options) { return share_of(options.share).number == 1; }

DealtTexts::DealtTexts(TextReader& texts, const DealOptions& options, const std::function<std::string()>& settings)
    : texts_(texts), end_(std::numeric_limits<std::size_t>::max()) {
  const Share share = share_of(options.share);
  if (!options.kept.empty()) kept_.emplace(options.kept, settings ? settings() : std::string());
  if (share.of == 1) return;
  const std::size_t count = texts.count();
  is_part_ = count > 0;
  first_ = begin_of(share.number - 1, share.of, count);
  end_ = begin_of(share.number, share.of, count);
  const std::size_t begin = kept_ ? kept_->begin_of_part(first_) : first_;
  while (read_ < begin && texts_.next()) ++read_;
}

// A part may begin before the share, and end behind it.
void DealtTexts::look_ahead() {
  const std::size_t first = read_;
  const std::size_t count = kept_ && read_ < end_ ? kept_->count_from(first) : 0;
  std::vector<Text> texts;
  while (texts.size() < count) {
    std::optional<Text> text = texts_.next();
    if (!text) break;
    texts.push_back(std::move(*text));
  }
  read_ += texts.size();
  auto replies = texts.size() == count && count > 0 ? kept_->find(first, texts) : std::nullopt;
  for (std::size_t i = 0; i < texts.size(); ++i) {
    if (first + i < first_ || first + i >= end_) continue;
    ahead_.push_back(
        {first + i, std::move(texts[i]), replies ? std::optional(std::move((*replies)[i])) : std::nullopt});
  }
}

std::optional<DealtText> DealtTexts::next() {
  if (ahead_.empty()) look_ahead();
  if (!ahead_.empty()) {
    DealtText text = std::move(ahead_.front());
    ahead_.pop_front();
    return text;
  }
  std::optional<Text> text = read_ < end_ ? texts_.next() : std::nullopt;
  if (!text && read_ == 0 && !is_part_) throw ltl::FormatError(texts_.source(), 0, 0, "there is nothing to read");
  if (!text) return std::nullopt;
  return DealtText{read_++, std::move(*text)};
}

void ReplyKeeper::put(DealtText text, const Reply& reply) {
  if (kept_ == nullptr) return;
  if (text.made) return end_part();
  if (texts_.empty()) {
    first_ = text.number;
    begun_ = now();
  }
  bytes_ += text.text.text.size() + reply.text.size() + reply.problem.size();
  texts_.push_back(std::move(text.text));
  replies_.push_back(reply);
  if (texts_.size() >= ChunkSize::most_texts || bytes_ >= most_part_bytes || now() - begun_ >= seconds_) end_part();
}

void ReplyKeeper::end_part() {
  if (kept_ != nullptr) kept_->keep(first_, texts_, replies_);
  texts_.clear();
  replies_.clear();
  bytes_ = 0;
}

}  // namespace waymark::tools

#include "tools/shell/hand.hpp"

#include <utility>

namespace waymark::tools {
namespace {

constexpr std::size_t most_unsaid_bytes = std::size_t{1} << 20U;

}  // namespace

std::optional<DealtText> HandTexts::next() {
  std::unique_lock lock(mutex_);
  while (true) {
    if (taken_ > 0 && is_over()) texts_.resize(taken_);  // one text at least, whatever the time
    if (taken_ < texts_.size()) {
      const std::size_t number = taken_++;
      return DealtText{number, std::move(texts_[number])};
    }
    closed_ = true;
    say_when_over();
    lock.unlock();
    const auto chunk = read_frame(seat_.in);  // which comes when all replies to the last one are there
    lock.lock();
    if (!chunk) return std::nullopt;
    take(*chunk);
  }
}

void HandTexts::take(const std::string& chunk) {
  Unpacked message(chunk);
  chunk_ = message.number();
  begun_ = Clock::now();
  end_ = begun_ + std::chrono::microseconds(message.number());
  texts_.assign(message.number(), {});
  for (Text& text : texts_) {
    text.line = message.number();
    text.source = message.text();
    text.text = message.text();
  }
  taken_ = answered_ = 0;
  closed_ = said_over_ = false;
}

void HandTexts::put(const Reply& reply) {
  const std::lock_guard lock(mutex_);
  pack(replies_, reply);
  ++unsaid_;
  ++answered_;
  if (replies_.bytes().size() >= most_unsaid_bytes) say(false);
  say_when_over();
}

void HandTexts::say_when_over() {
  if (!closed_ || said_over_ || answered_ < taken_) return;
  say(true);
  said_over_ = true;
}

void HandTexts::say(bool over) {
  const auto took = std::chrono::duration_cast<std::chrono::microseconds>(Clock::now() - begun_).count();
  write_frame(seat_.out, Packed()
                             .number(chunk_)
                             .number(over ? 1 : 0)
                             .number(static_cast<std::uint64_t>(took))
                             .number(unsaid_)
                             .rest(replies_.bytes())
                             .bytes());
  replies_ = {};
  unsaid_ = 0;
}

}  // namespace waymark::tools

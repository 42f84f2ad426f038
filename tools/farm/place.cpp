#include "tools/farm/place.hpp"

#include <utility>

namespace waymark::tools {
namespace {

constexpr int most_fruitless = 50;

}  // namespace

Place::Place(std::string program, std::vector<std::string> arguments, Tell tell)
    : program_(std::move(program)), arguments_(std::move(arguments)), tell_(std::move(tell)) {
  start();
}

void Place::start() {
  child_ = std::make_unique<Child>(program_, arguments_, ChildRole::Hand);
  tell_(FarmNews::Ready, {});
}

void Place::give(std::string_view chunk) {
  if (!child_) return;
  chunks_.push_back(Unpacked(chunk).number());
  child_->say(chunk);
}

void Place::hear() {
  while (const auto replies = child_->hear()) {
    Unpacked message(*replies);
    message.number();
    const bool is_over = message.number() != 0;
    fruitless_ = 0;
    if (is_over && !chunks_.empty()) chunks_.pop_front();
    tell_(FarmNews::Replies, *replies);
  }
}

void Place::look() {
  if (!child_) return;
  child_->look();
  hear();
  const auto ending = child_->ending();
  if (!ending) return;
  hear();  // what it answered before it was killed
  const std::uint64_t at_work = chunks_.empty() ? 0 : chunks_.front();
  chunks_.clear();
  if (ending->signal == 0) {
    tell_(FarmNews::Ended,
          Packed().number(static_cast<std::uint64_t>(ending->code)).text(child_->complained()).bytes());
    child_.reset();
    return;
  }
  if (at_work != 0)
    tell_(FarmNews::Lost, Packed().number(at_work).number(static_cast<std::uint64_t>(ending->signal)).bytes());
  if (++fruitless_ < most_fruitless) return start();
  child_.reset();
  tell_(FarmNews::Gone, {});
}

void Place::add_to(std::vector<pollfd>& pipes) const {
  if (child_) child_->add_to(pipes);
}

}  // namespace waymark::tools

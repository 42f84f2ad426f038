// The giver of a farm, whose hands are played here: how it shares texts out, counted, and what it does when hands are
// lost. Hands take the time that a text says, in milliseconds, and no time passes.
#include "tools/shell/giver.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <condition_variable>
#include <deque>
#include <mutex>
#include <optional>
#include <random>
#include <set>
#include <thread>
#include <vector>

#include "tools/shell/packed.hpp"

namespace waymark::tools {
namespace {

struct Given {  // a chunk, as a hand reads it
  std::uint64_t hand = 0, number = 0, microseconds = 0;
  std::vector<std::string> texts = {};
};

Given given_of(const std::string& frame) {
  Unpacked message(frame);
  Given given{message.number(), message.number(), message.number()};
  given.texts.resize(message.number());
  for (std::string& text : given.texts) {
    message.number();
    message.text();
    text = message.text();
  }
  return given;
}

class PlayedFarm {
 public:
  PlayedFarm() {
    if (::pipe(to_giver_.data()) != 0 || ::pipe(from_giver_.data()) != 0) throw std::runtime_error("no pipe");
  }
  ~PlayedFarm() {
    for (const int end : {to_giver_[0], to_giver_[1], from_giver_[0]}) ::close(end);
  }
  PlayedFarm(const PlayedFarm&) = delete;
  PlayedFarm& operator=(const PlayedFarm&) = delete;

  Packed news(FarmNews kind, std::uint64_t hand) const {
    return Packed().number(static_cast<std::uint64_t>(kind)).number(hand);
  }
  void tell(const Packed& message) const { write_frame(to_giver_[1], message.bytes()); }
  void ready(std::uint64_t hand) const { tell(news(FarmNews::Ready, hand)); }
  void lost(const Given& given, int signal) const {
    const std::uint64_t number = signal == 0 ? 0 : given.number;
    tell(news(FarmNews::Lost, given.hand).number(number).number(static_cast<std::uint64_t>(signal)));
  }

  // What a hand was given and had not begun when it was killed.
  void forget(std::uint64_t hand) {
    const std::lock_guard lock(mutex_);
    std::erase_if(arrived_, [&](const auto& frame) { return frame && given_of(*frame).hand == hand; });
  }

  // The replies to texts [from, to).
  void reply(const Given& given, std::size_t from, std::size_t to, bool over, std::uint64_t microseconds) const {
    Packed message = news(FarmNews::Replies, given.hand);
    message.number(given.number).number(over ? 1 : 0).number(microseconds).number(to - from);
    for (std::size_t i = from; i < to; ++i) pack(message, {ExitCode::Done, "re " + given.texts[i] + "\n"});
    tell(message);
  }

  // As hand.cpp answers: one text at least, and no other when the time is over. Returns milliseconds.
  std::uint64_t answer(const Given& given) const {
    std::uint64_t milliseconds = 0;
    std::size_t answered = 0;
    while (answered < given.texts.size() && (answered == 0 || milliseconds * 1000 < given.microseconds))
      milliseconds += std::stoull(given.texts[answered++]);
    reply(given, 0, answered, true, milliseconds * 1000);
    return milliseconds;
  }

  // Gives the texts out to hands, of which `play` plays each chunk. Returns what the giver prints.
  template <class Play>
  std::string run(std::vector<std::string> texts, std::size_t hands, const Play& play, ExitCode wanted) {
    TextReader reader({.arguments = std::move(texts), .file = ""}, "text");
    DealtTexts dealt(reader, {}, {});
    testing::internal::CaptureStdout();
    std::thread farm([&] {
      for (std::size_t hand = 0; hand < hands; ++hand) ready(hand);
      while (const auto frame = take()) play(given_of(*frame));
    });
    std::thread reader_of_chunks([&] {  // as waymark-farm: always, whatever else is under way
      while (auto frame = read_frame(from_giver_[0])) arrive(std::move(frame));
      arrive(std::nullopt);
    });
    const BadTextReply bad = [](const Text& text, const std::string&) { return "bad " + text.text + "\n"; };
    const ExitCode code = give_out(dealt, {Seat::Role::Giver, to_giver_[0], from_giver_[1]}, {}, bad);
    ::close(from_giver_[1]);
    farm.join();
    reader_of_chunks.join();
    EXPECT_EQ(code, wanted);
    return testing::internal::GetCapturedStdout();
  }

 private:
  void arrive(std::optional<std::string> frame) {
    const std::lock_guard lock(mutex_);
    arrived_.push_back(std::move(frame));
    news_.notify_one();
  }
  std::optional<std::string> take() {
    std::unique_lock lock(mutex_);
    news_.wait(lock, [this] { return !arrived_.empty(); });
    auto frame = std::move(arrived_.front());
    arrived_.pop_front();
    return frame;
  }

  std::array<int, 2> to_giver_{}, from_giver_{};
  std::mutex mutex_;
  std::condition_variable news_;
  std::deque<std::optional<std::string>> arrived_;  // nullopt: the giver has ended
};

std::string replies_to(const std::vector<std::string>& texts) {
  std::string all;
  for (const std::string& text : texts) all += "re " + text + "\n";
  return all;
}

// Half a second a chunk: 1, 2, 4, …, 256 texts of a millisecond, then 500. Two chunks are given before one is answered.
TEST(Giver, ChunksGrowToTheirTime) {
  const std::vector<std::string> texts(5'012, "1");
  std::vector<std::size_t> sizes;
  PlayedFarm farm;
  const auto play = [&](const Given& given) {
    sizes.push_back(given.texts.size());
    farm.answer(given);
  };
  EXPECT_EQ(farm.run(texts, 1, play, ExitCode::Done), replies_to(texts));
  EXPECT_EQ(sizes, (std::vector<std::size_t>{1, 1, 2, 4, 8, 16, 32, 64, 128, 256, 500, 500, 500, 500, 500, 500, 500,
                                             500, 500}));
}

// Whatever comes after what: no chunk takes longer than half a second and one text, and few are needed.
TEST(Giver, HardTextsAreFoundAndSharedOut) {
  std::mt19937 random(1);
  for (int round = 0; round < 20; ++round) {
    std::vector<std::string> texts;
    std::uint64_t total = 0;
    while (texts.size() < 3'000) {  // runs of texts that are alike hard
      const std::uint64_t cost = std::uint64_t{1} << (random() % 12U);
      for (std::size_t more = 1 + random() % 300U; more > 0; --more) {
        texts.push_back(std::to_string(cost));
        total += cost;
      }
    }
    std::uint64_t longest = 0;
    std::size_t chunks = 0;
    std::set<std::uint64_t> hands;
    PlayedFarm farm;
    const auto play = [&](const Given& given) {
      ++chunks;
      hands.insert(given.hand);
      longest = std::max(longest, farm.answer(given));
    };
    EXPECT_EQ(farm.run(texts, 4, play, ExitCode::Done), replies_to(texts)) << "round " << round;
    EXPECT_LE(longest, 500U + 2'048U) << "round " << round;
    EXPECT_EQ(hands.size(), 4U) << "round " << round;
    // At most three times as many as chunks of exactly half a second, or a text each where that takes longer.
    EXPECT_LE(chunks, 3 * (total / 500 + 12 * 12)) << "round " << round;
  }
}

// Hands are lost in the middle of chunks, some for a while only: they then answer what others answer, too.
TEST(Giver, WhatALostHandHadIsGivenAnew) {
  std::mt19937 random(2);
  for (int round = 0; round < 50; ++round) {
    std::vector<std::string> texts;
    for (int i = 0; i < 400; ++i) texts.push_back(std::to_string(random() % 200U));
    std::size_t losses = 0;
    PlayedFarm farm;
    const auto play = [&](const Given& given) {
      const std::size_t done = random() % (given.texts.size() + 1);
      switch (random() % 8U) {
        case 0:
        case 1:
          ++losses;
          farm.reply(given, 0, done, false, 1000);
          farm.forget(given.hand);
          farm.lost(given, 9);
          farm.ready(given.hand);
          break;
        case 2:
          ++losses;
          farm.lost(given, 0);
          farm.answer(given);
          break;
        default: farm.answer(given);
      }
    };
    EXPECT_EQ(farm.run(texts, 3, play, ExitCode::Done), replies_to(texts)) << "round " << round;
    EXPECT_GT(losses, 0U);
  }
}

// A text that ends whoever reads it is found by halving, and answered as what cannot be answered.
TEST(Giver, ATextThatEndsItsHandsIsGivenUp) {
  std::vector<std::string> texts(1'000, "1");
  texts[700] = "1000000";
  std::size_t deaths = 0;
  PlayedFarm farm;
  const auto play = [&](const Given& given) {
    if (std::find(given.texts.begin(), given.texts.end(), "1000000") == given.texts.end()) {
      farm.answer(given);
      return;
    }
    ++deaths;
    farm.forget(given.hand);
    farm.lost(given, 11);
    farm.ready(given.hand);
  };
  std::string expected;
  for (const std::string& text : texts) expected += (text == "1" ? "re " : "bad ") + text + "\n";
  testing::internal::CaptureStderr();
  EXPECT_EQ(farm.run(texts, 2, play, ExitCode::GaveUp), expected);
  EXPECT_NE(testing::internal::GetCapturedStderr().find("ended by signal 11, 8 times"), std::string::npos);
  EXPECT_LE(deaths, 8U + 10U);
}

TEST(Giver, EndsWithTheErrorOfAHand) {
  PlayedFarm farm;
  const auto play = [&](const Given& given) {
    farm.tell(farm.news(FarmNews::Ended, given.hand).number(30).text("error: this is a bug\n"));
  };
  testing::internal::CaptureStderr();
  EXPECT_EQ(farm.run({"1", "2"}, 1, play, ExitCode::OurBug), "");
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "error: this is a bug\n");
}

}  // namespace
}  // namespace waymark::tools

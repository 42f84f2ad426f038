#include "tools/shell/giver.hpp"

#include <algorithm>
#include <deque>
#include <iostream>
#include <map>
#include <utility>

#include "tools/shell/chunk_size.hpp"
#include "tools/shell/packed.hpp"

namespace waymark::tools {
namespace {

constexpr std::size_t most_waiting_bytes = std::size_t{256} << 20U;
constexpr std::size_t most_chunk_bytes = std::size_t{4} << 20U;
constexpr std::size_t most_deaths = 8;

struct Chunk {
  std::size_t first = 0;  // number of its first text
  std::vector<Text> texts = {};
  std::size_t deaths = 0;  // of hands that were at work on it, when it is a single text
};

struct Task {  // a chunk that a hand has
  std::uint64_t number = 0;
  Chunk chunk = {};
  std::vector<Reply> replies = {};  // to its first texts
};

// A hand has a second chunk while it is at work on the first, so that it need not wait for it.
constexpr std::size_t most_tasks = 2;

struct Hand {
  bool is_there = false;
  std::deque<Task> tasks = {};
};

// Replies that wait for earlier ones.
class Waiting {
 public:
  void put(std::size_t first, std::vector<Reply> replies) {
    for (const Reply& reply : replies) bytes_ += size_of(reply);
    if (!replies.empty()) parts_.emplace(first, std::move(replies));
  }
  void print() {
    for (auto part = parts_.begin(); part != parts_.end() && part->first == next_; part = parts_.erase(part))
      for (const Reply& reply : part->second) {
        output_.put(reply);
        bytes_ -= size_of(reply);
        ++next_;
      }
    ReplyOutput::flush();
  }
  void begin_at(std::size_t first) { next_ = first; }
  bool has_room() const { return bytes_ < most_waiting_bytes; }
  ExitCode worst() const { return output_.worst(); }

 private:
  static std::size_t size_of(const Reply& reply) { return sizeof(Reply) + reply.text.size() + reply.problem.size(); }

  ReplyOutput output_;
  std::map<std::size_t, std::vector<Reply>> parts_;  // by first text
  std::size_t next_ = 0, bytes_ = 0;
};

class Giver {
 public:
  Giver(DealtTexts& texts, const Seat& seat, const BadTextReply& bad)
      : texts_(texts), seat_(seat), bad_(bad), seconds_(chunk_seconds()), size_(seconds_) {}

  ExitCode run(const std::stop_token& stop) {
    ahead_ = texts_.next();
    if (ahead_) waiting_.begin_at(ahead_->number);
    while (true) {
      if (stop.stop_requested()) throw Interrupted();
      give();
      waiting_.print();
      give();  // there may be room now
      if (is_done()) return waiting_.worst();
      const auto news = read_frame(seat_.in);
      if (!news) throw GaveUp("waymark-farm is gone");
      if (const auto code = hear(Unpacked(*news))) return *code;
    }
  }

 private:
  bool is_done() const {
    return !ahead_ && again_.empty() &&
           std::none_of(hands_.begin(), hands_.end(), [](const auto& hand) { return !hand.second.tasks.empty(); });
  }

  void give() {  // a first chunk to all, then a second
    for (std::size_t tasks = 0; tasks < most_tasks; ++tasks)
      for (auto& [name, hand] : hands_) {
        if (!hand.is_there || hand.tasks.size() != tasks) continue;
        std::optional<Chunk> chunk = next_chunk();
        if (!chunk) return;
        hand.tasks.push_back({++last_number_, std::move(*chunk)});
        write_frame(seat_.out, message(name, hand.tasks.back()));
      }
  }

  std::string message(std::uint64_t name, const Task& task) const {
    Packed packed;
    packed.number(name).number(task.number).number(static_cast<std::uint64_t>(seconds_ * 1e6));
    packed.number(task.chunk.texts.size());
    for (const Text& text : task.chunk.texts) packed.number(text.line).text(text.source).text(text.text);
    return packed.bytes();
  }

  // What has to be given anew comes first: the earliest text that is not answered is at work, or among it.
  std::optional<Chunk> next_chunk() {
    if (!again_.empty()) {
      Chunk chunk = std::move(again_.front());
      again_.pop_front();
      if (chunk.texts.size() > size_.texts()) give_anew(cut(chunk, size_.texts()));
      return chunk;
    }
    Chunk chunk;
    std::size_t bytes = 0;
    while (ahead_ && waiting_.has_room() && chunk.texts.size() < size_.texts() && bytes < most_chunk_bytes) {
      if (ahead_->made) {
        if (!chunk.texts.empty()) break;
        pass_made();
        continue;
      }
      if (chunk.texts.empty()) chunk.first = ahead_->number;
      bytes += ahead_->text.text.size();
      chunk.texts.push_back(std::move(ahead_->text));
      ahead_ = texts_.next();
    }
    if (chunk.texts.empty()) return std::nullopt;
    return chunk;
  }

  // The replies of one kept part and of what follows it.
  void pass_made() {
    const std::size_t first = ahead_->number;
    std::vector<Reply> replies;
    for (; ahead_ && ahead_->made && replies.size() < ChunkSize::most_texts; ahead_ = texts_.next())
      replies.push_back(std::move(*ahead_->made));
    waiting_.put(first, std::move(replies));
    waiting_.print();
  }

  static Chunk cut(Chunk& chunk, std::size_t from) {  // all texts but the first ones
    const auto middle = chunk.texts.begin() + static_cast<std::ptrdiff_t>(from);
    Chunk rest{chunk.first + from, {std::make_move_iterator(middle), std::make_move_iterator(chunk.texts.end())}};
    chunk.texts.erase(middle, chunk.texts.end());
    return rest;
  }

  void give_anew(Chunk chunk) {
    if (chunk.texts.empty()) return;
    const auto later = [&](const Chunk& other) { return other.first > chunk.first; };
    again_.insert(std::find_if(again_.begin(), again_.end(), later), std::move(chunk));
  }

  std::optional<ExitCode> hear(Unpacked news) {
    const auto kind = static_cast<FarmNews>(news.number());
    const std::size_t name = news.number();
    Hand& hand = hands_[name];
    switch (kind) {
      case FarmNews::Ready: hand.is_there = true; break;
      case FarmNews::Replies: take_replies(hand, news); break;
      case FarmNews::Lost: {
        const std::uint64_t at_work = news.number();
        hand.is_there = false;
        lose(hand, at_work, static_cast<int>(news.number()));
        break;
      }
      case FarmNews::Ended: {  // by itself: after an error that ends everything
        const auto code = static_cast<ExitCode>(news.number());
        std::cerr << news.text();
        if (code != ExitCode::Done) return code;
        hands_.erase(name);
        break;
      }
      case FarmNews::Gone: hands_.erase(name); break;
    }
    if (hands_.empty()) throw GaveUp("no process of the farm is left to answer");
    return std::nullopt;
  }

  void take_replies(Hand& hand, Unpacked& news) {
    const std::uint64_t number = news.number();
    const bool is_over = news.number() != 0;
    const double took = static_cast<double>(news.number()) * 1e-6;
    hand.is_there = hand.is_there || is_over;  // when it was given up and has come back
    const auto task =
        std::find_if(hand.tasks.begin(), hand.tasks.end(), [&](const Task& t) { return t.number == number; });
    if (task == hand.tasks.end()) return;
    for (std::uint64_t count = news.number(); count > 0; --count) task->replies.push_back(unpack_reply(news));
    if (!is_over) return;
    size_.learn(task->replies.size(), took);
    give_anew(take(std::move(*task)));
    hand.tasks.erase(task);
  }

  // The replies that are there are taken; the texts that were not answered are left.
  Chunk take(Task task) {
    Chunk rest = cut(task.chunk, task.replies.size());
    if (texts_.kept() != nullptr) texts_.kept()->keep(task.chunk.first, task.chunk.texts, task.replies);
    waiting_.put(task.chunk.first, std::move(task.replies));
    return rest;
  }

  void lose(Hand& hand, std::uint64_t at_work, int signal) {
    for (Task& task : std::exchange(hand.tasks, {})) {
      const bool was_at_work = task.number == at_work;
      const std::size_t deaths = task.chunk.deaths;
      Chunk rest = take(std::move(task));
      rest.deaths = deaths;
      if (was_at_work && signal != 0)
        suspect(std::move(rest), signal);
      else
        give_anew(std::move(rest));
    }
  }

  // One of the texts may have ended the hand: halves are given anew, so that it is found.
  void suspect(Chunk rest, int signal) {
    if (rest.texts.size() > 1)
      give_anew(cut(rest, rest.texts.size() / 2));
    else
      ++rest.deaths;
    if (rest.texts.empty() || rest.deaths < most_deaths) return give_anew(std::move(rest));
    const Text& text = rest.texts.front();
    const std::string message = "the process that answers this ended by signal " + std::to_string(signal) + ", " +
                                std::to_string(most_deaths) + " times" +
                                (text.source.empty() ? "" : "\n  " + text.source + ':' + std::to_string(text.line));
    waiting_.put(rest.first, {{ExitCode::GaveUp, bad_(text, message), message}});
  }

  DealtTexts& texts_;
  Seat seat_;
  const BadTextReply& bad_;
  double seconds_;
  ChunkSize size_;
  std::optional<DealtText> ahead_;
  std::deque<Chunk> again_;  // by first text
  std::map<std::uint64_t, Hand> hands_;
  std::uint64_t last_number_ = 0;
  Waiting waiting_;
};

}  // namespace

ExitCode give_out(DealtTexts& texts, const Seat& seat, const std::stop_token& stop, const BadTextReply& bad) {
  return Giver(texts, seat, bad).run(stop);
}

}  // namespace waymark::tools

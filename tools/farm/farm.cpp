#include "tools/farm/farm.hpp"

#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <iostream>
#include <memory>
#include <utility>

#include "tools/farm/place.hpp"
#include "tools/shell/exit_code.hpp"
#include "tools/shell/terminal.hpp"

namespace waymark::tools {
namespace {

using Clock = std::chrono::steady_clock;
using std::chrono::seconds;

constexpr int pause_milliseconds = 2;  // between two looks for messages; pipes are seen at once
constexpr seconds sign_of_life{1}, silence{5}, silence_of_rank_0{60}, patience_with_sending{2};
constexpr int most_restarts = 20;

enum class Kind : std::uint64_t {
  News,   // of a place to rank 0: kind of news, the rest
  Chunk,  // for a place: as the giver says it
  Alive,  // 1: it has nothing to do
  Over,   // to all: end
  Ended,  // to rank 0: exit code, standard error, of a command that shares checkpoints
};

std::string letter(Kind kind, std::string_view rest) {
  return Packed().number(static_cast<std::uint64_t>(kind)).rest(rest).bytes();
}

// Waits for a pipe, but no longer than a pause.
void wait_for(std::vector<pollfd>& pipes) { ::poll(pipes.data(), pipes.size(), pause_milliseconds); }

// Writes what can be written to standard output without waiting: as many bytes as a pipe takes at once.
void show_some(std::string& shown) {
  std::size_t done = 0;
  pollfd out{STDOUT_FILENO, POLLOUT, 0};
  while (done < shown.size() && ::poll(&out, 1, 0) > 0) {
    const ssize_t written =
        ::write(STDOUT_FILENO, shown.data() + done, std::min<std::size_t>(4096, shown.size() - done));
    if (written < 0 && errno != EINTR) done = shown.size();  // nobody reads
    if (written > 0) done += static_cast<std::size_t>(written);
  }
  shown.erase(0, done);
}

void show_all(std::string& shown) {
  while (!shown.empty()) {
    pollfd out{STDOUT_FILENO, POLLOUT, 0};
    ::poll(&out, 1, -1);
    show_some(shown);
  }
}

class Rhythm {  // of signs of life
 public:
  bool is_due() {
    const Clock::time_point now = Clock::now();
    if (now < next_) return false;
    next_ = now + sign_of_life;
    return true;
  }

 private:
  Clock::time_point next_ = Clock::now();
};

// When each other rank was last heard of.
class Roll {
 public:
  explicit Roll(int ranks) : heard_(static_cast<std::size_t>(ranks), Clock::now()), lost_(heard_.size(), 0) {}

  bool is_lost(int rank) const { return lost_[static_cast<std::size_t>(rank)] != 0; }
  bool heard(int rank) {  // was it taken for killed?
    heard_[static_cast<std::size_t>(rank)] = Clock::now();
    return std::exchange(lost_[static_cast<std::size_t>(rank)], 0) != 0;
  }
  template <class Lose>
  void call(const Lose& lose) {
    for (std::size_t rank = 1; rank < heard_.size(); ++rank)
      if (lost_[rank] == 0 && Clock::now() - heard_[rank] > silence) {
        lost_[rank] = 1;
        lose(rank);
      }
  }

 private:
  std::vector<Clock::time_point> heard_;
  std::vector<char> lost_;  // 1: taken for killed
};

// Tells all ranks that it is over, and waits a little until they are told.
void end_all(Post& post, int ranks, const Roll& roll) {
  for (int rank = 1; rank < ranks; ++rank)
    if (!roll.is_lost(rank)) post.send(rank, letter(Kind::Over, {}));
  const Clock::time_point end = Clock::now() + patience_with_sending;
  while (!post.is_all_sent([&](int rank) { return roll.is_lost(rank); }) && Clock::now() < end)
    ::usleep(1000 * pause_milliseconds);
}

int texts_of_rank_0(const FarmCommand& command, const boost::mpi::communicator& ranks,
                    const volatile std::sig_atomic_t& stopped) {
  Post post(ranks);
  Roll roll(ranks.size());
  Rhythm rhythm;
  Child giver(command.program, command.arguments, ChildRole::Giver);
  const auto tell = [&](int rank, FarmNews kind, std::string_view rest) {
    giver.say(
        Packed().number(static_cast<std::uint64_t>(kind)).number(static_cast<std::uint64_t>(rank)).rest(rest).bytes());
  };
  Place own(command.program, command.arguments, [&](FarmNews kind, const std::string& rest) { tell(0, kind, rest); });
  const auto take = [&](int rank, const std::string& message) {
    const bool was_lost = roll.heard(rank);
    Unpacked opened(message);
    const auto kind = static_cast<Kind>(opened.number());
    if (kind == Kind::News) {
      const auto news = static_cast<FarmNews>(opened.number());
      tell(rank, news, opened.rest());
    } else if (kind == Kind::Alive && was_lost && opened.number() == 1) {
      tell(rank, FarmNews::Ready, {});
    }
  };
  int told = 0;
  std::optional<Ending> ending;
  while (!(ending = giver.ending())) {
    if (stopped != told) giver.signal(told = stopped);
    giver.look();
    show_some(giver.shown());
    while (const auto chunk = giver.hear()) {
      Unpacked message(*chunk);
      const int rank = static_cast<int>(message.number());
      if (rank == 0)
        own.give(message.rest());
      else
        post.send(rank, letter(Kind::Chunk, message.rest()));
    }
    own.look();
    post.receive(take);
    post.is_all_sent([](int) { return false; });
    if (rhythm.is_due())
      for (int rank = 1; rank < ranks.size(); ++rank)
        if (!roll.is_lost(rank)) post.send(rank, letter(Kind::Alive, Packed().number(0).bytes()));
    roll.call([&](std::size_t rank) {
      complain("note", "rank " + std::to_string(rank) + " is not heard of: what it was at work on is given to others");
      tell(static_cast<int>(rank), FarmNews::Lost, Packed().number(0).number(0).bytes());
    });
    std::vector<pollfd> pipes;
    giver.add_to(pipes);
    own.add_to(pipes);
    wait_for(pipes);
  }
  show_all(giver.shown());
  if (ending->signal != 0)
    complain("error", "the process that reads the texts and prints was ended by signal " +
                          std::to_string(ending->signal) + "; with --kept, the same command goes on");
  end_all(post, ranks.size(), roll);
  return ending->code;
}

int texts_of_others(const FarmCommand& command, const boost::mpi::communicator& ranks) {
  Post post(ranks);
  Rhythm rhythm;
  Clock::time_point heard = Clock::now();
  bool is_over = false;
  Place own(command.program, command.arguments, [&](FarmNews kind, const std::string& rest) {
    post.send(0, letter(Kind::News, Packed().number(static_cast<std::uint64_t>(kind)).rest(rest).bytes()));
  });
  while (true) {
    own.look();
    post.receive([&](int, const std::string& message) {
      heard = Clock::now();
      Unpacked opened(message);
      const auto kind = static_cast<Kind>(opened.number());
      if (kind == Kind::Chunk) own.give(opened.rest());
      if (kind == Kind::Over) is_over = true;
    });
    if (is_over || Clock::now() - heard > silence_of_rank_0) break;
    post.is_all_sent([](int) { return false; });
    if (rhythm.is_due()) post.send(0, letter(Kind::Alive, Packed().number(own.is_idle() ? 1 : 0).bytes()));
    std::vector<pollfd> pipes;
    own.add_to(pipes);
    wait_for(pipes);
  }
  return static_cast<int>(is_over ? ExitCode::Done : ExitCode::GaveUp);
}

// The command, started again when it is killed: it goes on from its checkpoints.
class Again {
 public:
  explicit Again(const FarmCommand& command) : command_(command) { start(); }

  std::optional<Ending> look() {
    child_->look();
    const auto ending = child_->ending();
    if (!ending || ending->signal == 0 || ++killed_ > most_restarts) return ending;
    start();
    return std::nullopt;
  }
  Child& child() { return *child_; }

 private:
  void start() { child_ = std::make_unique<Child>(command_.program, command_.arguments, ChildRole::Alone); }

  const FarmCommand& command_;
  std::unique_ptr<Child> child_;
  int killed_ = 0;
};

int checkpoints_of_rank_0(const FarmCommand& command, const boost::mpi::communicator& ranks,
                          const volatile std::sig_atomic_t& stopped) {
  Post post(ranks);
  Roll roll(ranks.size());
  Rhythm rhythm;
  Again again(command);
  std::optional<Ending> ending;
  int told = 0;
  while (!(ending = again.look())) {
    if (stopped != told) again.child().signal(told = stopped);
    post.receive([&](int rank, const std::string& message) {
      roll.heard(rank);
      Unpacked opened(message);
      if (static_cast<Kind>(opened.number()) != Kind::Ended) return;
      const std::uint64_t code = opened.number();
      if (code != 0) std::cerr << "rank " << rank << " ended with exit code " << code << '\n' << opened.text();
    });
    post.is_all_sent([](int) { return false; });
    if (rhythm.is_due())
      for (int rank = 1; rank < ranks.size(); ++rank)
        if (!roll.is_lost(rank)) post.send(rank, letter(Kind::Alive, {}));
    roll.call([](std::size_t rank) {
      complain("note", "rank " + std::to_string(rank) + " is not heard of: others do what it was at work on");
    });
    std::vector<pollfd> pipes;
    again.child().add_to(pipes);
    wait_for(pipes);
  }
  show_all(again.child().shown());
  std::cerr << again.child().complained();
  end_all(post, ranks.size(), roll);
  return ending->code;
}

int checkpoints_of_others(const FarmCommand& command, const boost::mpi::communicator& ranks) {
  Post post(ranks);
  Rhythm rhythm;
  Clock::time_point heard = Clock::now();
  bool is_over = false, has_ended = false;
  Again again(command);
  while (true) {
    const auto ending = has_ended ? std::nullopt : again.look();
    if (ending) {
      has_ended = true;
      post.send(
          0,
          letter(Kind::Ended,
                 Packed().number(static_cast<std::uint64_t>(ending->code)).text(again.child().complained()).bytes()));
    }
    post.receive([&](int, const std::string& message) {
      heard = Clock::now();
      is_over = is_over || static_cast<Kind>(Unpacked(message).number()) == Kind::Over;
    });
    if (is_over || Clock::now() - heard > silence_of_rank_0) break;
    post.is_all_sent([](int) { return false; });
    if (rhythm.is_due()) post.send(0, letter(Kind::Alive, {}));
    std::vector<pollfd> pipes;
    if (!has_ended) again.child().add_to(pipes);
    wait_for(pipes);
  }
  return static_cast<int>(is_over ? ExitCode::Done : ExitCode::GaveUp);
}

}  // namespace

int share_texts(const FarmCommand& command, const boost::mpi::communicator& ranks,
                const volatile std::sig_atomic_t& stopped) {
  return ranks.rank() == 0 ? texts_of_rank_0(command, ranks, stopped) : texts_of_others(command, ranks);
}

int share_checkpoints(const FarmCommand& command, const boost::mpi::communicator& ranks,
                      const volatile std::sig_atomic_t& stopped) {
  return ranks.rank() == 0 ? checkpoints_of_rank_0(command, ranks, stopped) : checkpoints_of_others(command, ranks);
}

}  // namespace waymark::tools

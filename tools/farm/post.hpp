// Messages between ranks, sent and received without waiting: what is on its way to or from a rank that was killed never
// arrives, and nobody waits for it.
#pragma once
#include <boost/mpi/communicator.hpp>
#include <boost/mpi/request.hpp>
#include <deque>
#include <functional>
#include <list>
#include <map>
#include <string>
#include <string_view>

namespace waymark::tools {

class Post {
 public:
  explicit Post(const boost::mpi::communicator& ranks) : ranks_(ranks) {}

  // Throws std::length_error for a message of 2 GiB or more.
  void send(int rank, std::string message);

  // Those that have arrived, each rank's in the order in which it sent them.
  void receive(const std::function<void(int rank, const std::string& message)>& take);

  // Forgets messages that are sent. Are all, but those to ranks for which `but` holds?
  bool is_all_sent(const std::function<bool(int rank)>& but);

 private:
  struct Letter {
    std::string bytes;
    boost::mpi::request under_way;
    bool arrived = false;
  };

  boost::mpi::communicator ranks_;
  std::map<int, std::list<Letter>> outgoing_, incoming_;
};

}  // namespace waymark::tools

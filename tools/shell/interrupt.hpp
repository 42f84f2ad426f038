// Ctrl-C: a request to stop that long work answers, and a deadline for work that does not.
//
// The signal handler writes one byte into a pipe. A watcher thread reads it, requests the stop, and when the
// process is still there 0.25 s later removes unfinished files and ends it with exit code 11. So Ctrl-C works
// within half a second whether or not the code that runs polls the token.
#pragma once
#include <stop_token>
#include <thread>

namespace waymark::tools {

class Interrupt {  // at most one per process
 public:
  Interrupt();  // SIGINT and SIGTERM are caught from here on
  ~Interrupt();
  Interrupt(const Interrupt&) = delete;
  Interrupt& operator=(const Interrupt&) = delete;

  std::stop_token token() const { return stop_.get_token(); }

 private:
  void watch();
  std::stop_source stop_;
  int reader_ = -1;
  std::thread watcher_;
};

}  // namespace waymark::tools

// A process of `waymark` that the farm started: its pipes, read and written without waiting, and its end.
#pragma once
#include <poll.h>
#include <sys/types.h>

#include <deque>
#include <optional>
#include <string>
#include <vector>

#include "tools/shell/packed.hpp"

namespace waymark::tools {

// Read from as it comes, or written to as it goes.
class OpenPipe {
 public:
  OpenPipe() = default;
  explicit OpenPipe(int end);  // takes it, makes it not wait
  ~OpenPipe();
  OpenPipe(OpenPipe&& other) noexcept;
  OpenPipe& operator=(OpenPipe&& other) noexcept;
  int end() const { return end_; }  // -1: closed
  std::string read() const;         // of what is there now, up to a mebibyte
  void write(std::string bytes);    // now, or when there is room: flush()
  void flush();
  bool has_unwritten() const { return !unwritten_.empty(); }

 private:
  int end_ = -1;
  std::deque<std::string> unwritten_;
  std::size_t done_ = 0;  // bytes of the first one
};

struct Ending {
  int code = 0;    // exit code; 128 + signal when it was killed
  int signal = 0;  // 0: it ended by itself
};

enum class ChildRole {
  Giver,  // standard input and standard error are ours, standard output goes through `shown`
  Hand,   // standard input and standard output are empty
  Alone   // speaks to nobody; standard input is empty, standard output kept
};

class Child {
 public:
  // Is killed when this process ends, however it ends. Throws std::system_error when it cannot be started.
  Child(const std::string& program, const std::vector<std::string>& arguments, ChildRole role);
  ~Child();  // kills it
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;

  void say(std::string_view frame);
  std::optional<std::string> hear();  // a frame, if one is there
  void look();                        // writes and reads what can be written and read now; of a giver, some standard
                                      // output at a time
  // Nothing while it runs, or while there may be something left to hear.
  std::optional<Ending> ending();
  void signal(int number) const;
  std::string& shown() { return shown_; }                        // of standard output, what was not taken yet
  const std::string& complained() const { return complained_; }  // the end of standard error
  void add_to(std::vector<pollfd>& pipes) const;                 // what to wait for

 private:
  ChildRole role_;
  pid_t process_ = -1;
  OpenPipe to_, from_, out_, err_;
  FrameCutter frames_;
  std::string shown_, complained_;
  std::optional<Ending> ended_;
};

}  // namespace waymark::tools

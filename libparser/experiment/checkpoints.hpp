// Finished parts of a long experiment, kept in a directory: a run that was killed goes on after the last of them.
//
// A part is a file under the name it was given, written to a temporary name and renamed: there whole or not at all,
// whatever ends the process. Parts are whatever bytes they are; models carry their own checksum (model_file.hpp), texts
// are given one here.
#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <utility>

namespace waymark::parser {

// A part that this process makes, as long as the object lives: no other claim of the part is granted meanwhile, in no
// process. The system ends the claims of a process that ends, however it ends.
class Claim {
 public:
  explicit Claim(int file) : file_(file) {}  // takes an open file; -1: none
  Claim(Claim&& other) noexcept : file_(std::exchange(other.file_, -1)) {}
  Claim& operator=(Claim&&) = delete;
  ~Claim();

 private:
  friend class Checkpoints;
  int file_;
};

class Checkpoints {
 public:
  // The directory is made when it is not there. It belongs to one experiment: `settings`, any text that says what the
  // parts depend on, is kept beside them. Throws ltl::FormatError when the directory holds parts of other settings,
  // with the first line that differs, or cannot be used.
  Checkpoints(std::filesystem::path directory, const std::string& settings);

  bool has(const std::string& name) const;                         // is the part finished?
  std::optional<std::string> find(const std::string& name) const;  // its bytes; nothing when it is not finished
  // From several threads at once, of different names. Throws ltl::FormatError when the file cannot be written.
  void keep(const std::string& name, const std::string& bytes) const;

  // Nothing when somebody else makes the part. Claims are locks of the file system, on a file `claims` in the
  // directory: where it has none, every claim is granted, and parts may be made twice.
  std::optional<Claim> claim(const std::string& name) const;

  // A text with its checksum in the line before it. Nothing when it is not finished or is damaged: it is made again.
  std::optional<std::string> find_text(const std::string& name) const;
  void keep_text(const std::string& name, const std::string& text) const;  // as keep

 private:
  std::filesystem::path directory_;
};

}  // namespace waymark::parser

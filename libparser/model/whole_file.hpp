// Files written whole or not at all. Two processes that write one file leave one whole file.
//
// A file is written without a name (O_TMPFILE), gets a temporary one beside the target, and is renamed. So a process
// that is killed while it writes leaves nothing behind. Where the file system has no such files, or /proc is missing,
// the file has its temporary name from the beginning, and a killed process leaves it.
#pragma once
#include <filesystem>
#include <string_view>

namespace waymark::parser {

// Replaces the file at `path`, and keeps its mode; a symbolic link stays one; a device or pipe is written directly.
// Throws ltl::FormatError naming the path and the reason when that fails; the old file is then untouched.
void write_file(const std::filesystem::path& path, std::string_view contents);

// A new folder among the temporary ones. It is removed, with all that it holds, at the end of the object's life.
class TemporaryFolder {
 public:
  explicit TemporaryFolder(std::string_view prefix);  // of its name; throws ltl::FormatError
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  const std::filesystem::path& path() const { return path_; }  // absolute, where the temporary folders are

 private:
  std::filesystem::path path_;
};

// Removes the temporary files of writes that are under way, and temporary folders: for a process that is about to be
// ended.
void discard_unfinished_files();

}  // namespace waymark::parser

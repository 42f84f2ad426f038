#include "libparser/model/whole_file.hpp"

#include <fcntl.h>
#include <stdlib.h>  // NOLINT(modernize-deprecated-headers): mkostemp, mkdtemp
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <mutex>
#include <string>
#include <vector>

#include "libltl/diagnostic.hpp"

namespace waymark::parser {
namespace {

std::mutex unfinished_mutex;
std::vector<std::string> unfinished;  // names of temporary files and folders that exist right now

[[noreturn]] void fail(const std::filesystem::path& path, int error) {
  throw ltl::FormatError(path.string(), 0, 0, "cannot write the file: " + std::string(std::strerror(error)));
}

bool write_all(int file, std::string_view contents) {
  while (!contents.empty()) {
    const ssize_t written = ::write(file, contents.data(), contents.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) return false;
    contents.remove_prefix(static_cast<std::size_t>(written));
  }
  return true;
}

void write_directly(const std::filesystem::path& path, std::string_view contents) {
  const int file = ::open(path.c_str(), O_WRONLY | O_CLOEXEC);
  if (file < 0) fail(path, errno);
  const bool complete = write_all(file, contents);
  const int error = errno;
  ::close(file);
  if (!complete) fail(path, error);
}

// A symbolic link stays one: the file it names is replaced, or made.
std::filesystem::path followed(std::filesystem::path path) {
  constexpr int most = 40;  // as Linux has it
  for (int i = 0; i < most; ++i) {
    std::error_code ignored;
    if (!std::filesystem::is_symlink(std::filesystem::symlink_status(path, ignored))) return path;
    path = path.parent_path() / std::filesystem::read_symlink(path, ignored);
  }
  fail(path, ELOOP);
}

void forget(const std::string& name) {
  const std::lock_guard lock(unfinished_mutex);
  unfinished.erase(std::remove(unfinished.begin(), unfinished.end(), name), unfinished.end());
}

std::string opened(int file) { return "/proc/self/fd/" + std::to_string(file); }

// Negative where there are no files without a name, or where none could get one.
int open_unnamed(const std::filesystem::path& folder) {
#ifdef O_TMPFILE
  const int file = ::open(folder.c_str(), O_TMPFILE | O_WRONLY | O_CLOEXEC, 0600);
  if (file >= 0 && ::access(opened(file).c_str(), F_OK) == 0) return file;
  if (file >= 0) ::close(file);
#endif
  return -1;
}

bool name_temporary(int file, const std::filesystem::path& folder, std::string& name) {
  static std::size_t names = 0;
  const std::lock_guard lock(unfinished_mutex);
  while (true) {
    name = (folder / (".waymark." + std::to_string(::getpid()) + "." + std::to_string(++names))).string();
    if (::linkat(AT_FDCWD, opened(file).c_str(), AT_FDCWD, name.c_str(), AT_SYMLINK_FOLLOW) == 0) break;
    if (errno != EEXIST) return false;
  }
  unfinished.push_back(name);
  return true;
}

int create_temporary(std::string& name) {  // mkstemp fills in the X's
  const std::lock_guard lock(unfinished_mutex);
  const int file = ::mkostemp(name.data(), O_CLOEXEC);
  if (file >= 0) unfinished.push_back(name);
  return file;
}

// That of the file which is replaced; of a new one what open(…, 0666) would give; mkstemp gives 0600.
mode_t mode_for(const std::filesystem::path& target) {
  struct stat status {};
  if (::stat(target.c_str(), &status) == 0) return status.st_mode & 07777;
  const mode_t mask = ::umask(0);
  ::umask(mask);
  return 0666 & ~mask;
}

}  // namespace

void write_file(const std::filesystem::path& path, std::string_view contents) {
  std::error_code ignored;
  const auto status = std::filesystem::status(path, ignored);
  const bool ordinary = !std::filesystem::exists(status) || std::filesystem::is_regular_file(status);
  if (!ordinary && !std::filesystem::is_directory(status)) return write_directly(path, contents);
  if (!ordinary) fail(path, EISDIR);

  const std::filesystem::path target = followed(path);
  const std::filesystem::path folder = target.has_parent_path() ? target.parent_path() : ".";
  std::string temporary = (folder / ".waymark.XXXXXX").string();
  int file = open_unnamed(folder);
  const bool unnamed = file >= 0;
  if (!unnamed) file = create_temporary(temporary);
  if (file < 0) fail(path, errno);
  bool complete = write_all(file, contents) && ::fchmod(file, mode_for(target)) == 0;
  if (complete && unnamed) complete = name_temporary(file, folder, temporary);
  int error = errno;
  const bool closed = ::close(file) == 0;
  if (complete && !closed) error = errno;
  const bool renamed = complete && closed && ::rename(temporary.c_str(), target.c_str()) == 0;
  if (complete && closed && !renamed) error = errno;
  if (!renamed) ::unlink(temporary.c_str());
  forget(temporary);
  if (!renamed) fail(path, error);
}

TemporaryFolder::TemporaryFolder(std::string_view prefix) {
  std::error_code error;
  std::string name = (std::filesystem::temp_directory_path(error) / std::string(prefix)).string() + "XXXXXX";
  if (error) throw ltl::FormatError("TMPDIR", 0, 0, "no folder for temporary files: " + error.message());
  const std::lock_guard lock(unfinished_mutex);
  if (::mkdtemp(name.data()) == nullptr)
    throw ltl::FormatError(name, 0, 0, "cannot be made: " + std::string(std::strerror(errno)));
  unfinished.push_back(name);
  path_ = name;
}

TemporaryFolder::~TemporaryFolder() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
  forget(path_.string());
}

void discard_unfinished_files() {
  const std::lock_guard lock(unfinished_mutex);
  std::error_code ignored;
  for (const std::string& name : unfinished) std::filesystem::remove_all(name, ignored);
  unfinished.clear();
}

}  // namespace waymark::parser

#include "tools/shell/output.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <iostream>

#include "libltl/diagnostic.hpp"
#include "libparser/model/whole_file.hpp"

namespace waymark::tools {
namespace {

[[noreturn]] void fail(const std::filesystem::path& path, int error) {
  throw ltl::FormatError(path.string(), 0, 0, "cannot write the file: " + std::string(std::strerror(error)));
}

// /dev/full refuses even no bytes at all; others take them and do nothing.
void check_takes_bytes(const std::filesystem::path& device) {
  const int file = ::open(device.c_str(), O_WRONLY | O_CLOEXEC | O_NOCTTY | O_NONBLOCK);
  if (file < 0) fail(device, errno);
  const int error = ::write(file, "", 0) < 0 ? errno : 0;
  ::close(file);
  if (error != 0) fail(device, error);
}

}  // namespace

void remove_file(const std::filesystem::path& path) {
  std::error_code error;
  std::filesystem::remove(path, error);
  if (error) throw ltl::FormatError(path.string(), 0, 0, "cannot be removed: " + error.message());
}

void make_directory(const std::filesystem::path& path) {
  std::error_code error;
  std::filesystem::create_directories(path, error);
  if (error) throw ltl::FormatError(path.string(), 0, 0, "cannot be made: " + error.message());
}

void check_writable(const std::filesystem::path& path) {
  if (path.empty() || path == "-") return;
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored)) fail(path, EISDIR);
  const auto folder = path.has_parent_path() ? path.parent_path() : std::filesystem::path(".");
  const bool device = std::filesystem::exists(path, ignored) && !std::filesystem::is_regular_file(path, ignored);
  if (::access((device ? path : folder).c_str(), W_OK) != 0) fail(path, errno);
  if (device && std::filesystem::is_character_file(path, ignored)) check_takes_bytes(path);
}

void write_file(const std::filesystem::path& path, std::string_view contents) {
  if (path == "-")
    std::cout << contents;  // in order with what was printed before
  else
    parser::write_file(path, contents);
}

}  // namespace waymark::tools

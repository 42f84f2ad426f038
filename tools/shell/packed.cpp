#include "tools/shell/packed.hpp"

#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <stdexcept>
#include <system_error>

namespace waymark::tools {
namespace {

constexpr std::size_t number_bytes = sizeof(std::uint64_t);

// Fewer than `size` bytes when the pipe has ended.
std::size_t read_bytes(int pipe, char* out, std::size_t size) {
  std::size_t done = 0;
  while (done < size) {
    const ssize_t got = ::read(pipe, out + done, size - done);
    if (got < 0 && errno != EINTR) throw std::system_error(errno, std::generic_category(), "read");
    if (got == 0) break;
    if (got > 0) done += static_cast<std::size_t>(got);
  }
  return done;
}

}  // namespace

Packed& Packed::number(std::uint64_t value) {
  char bytes[number_bytes];
  std::memcpy(bytes, &value, number_bytes);
  bytes_.append(bytes, number_bytes);
  return *this;
}

Packed& Packed::text(std::string_view value) {
  number(value.size());
  return rest(value);
}

Packed& Packed::rest(std::string_view bytes) {
  bytes_ += bytes;
  return *this;
}

std::uint64_t Unpacked::number() {
  if (bytes_.size() < number_bytes) throw std::logic_error("a message is too short");
  std::uint64_t value = 0;
  std::memcpy(&value, bytes_.data(), number_bytes);
  bytes_.remove_prefix(number_bytes);
  return value;
}

std::string Unpacked::text() {
  const std::uint64_t size = number();
  if (bytes_.size() < size) throw std::logic_error("a message is too short");
  std::string value(bytes_.substr(0, size));
  bytes_.remove_prefix(size);
  return value;
}

std::optional<std::string> FrameCutter::next() {
  const std::string_view left = std::string_view(bytes_).substr(begin_);
  if (left.size() < number_bytes) return std::nullopt;
  const std::uint64_t size = Unpacked(left).number();
  if (left.size() - number_bytes < size) {
    bytes_.erase(0, begin_);
    begin_ = 0;
    return std::nullopt;
  }
  begin_ += number_bytes + size;
  return std::string(left.substr(number_bytes, size));
}

std::string framed(std::string_view bytes) { return Packed().text(bytes).bytes(); }

void write_frame(int pipe, std::string_view bytes) {
  const std::string frame = framed(bytes);
  for (std::string_view left = frame; !left.empty();) {
    const ssize_t written = ::write(pipe, left.data(), left.size());
    if (written < 0 && errno != EINTR) throw std::system_error(errno, std::generic_category(), "write");
    if (written > 0) left.remove_prefix(static_cast<std::size_t>(written));
  }
}

std::optional<std::string> read_frame(int pipe) {
  char length[number_bytes];
  if (read_bytes(pipe, length, number_bytes) < number_bytes) return std::nullopt;
  std::string bytes(Unpacked({length, number_bytes}).number(), '\0');
  if (read_bytes(pipe, bytes.data(), bytes.size()) < bytes.size()) return std::nullopt;
  return bytes;
}

}  // namespace waymark::tools

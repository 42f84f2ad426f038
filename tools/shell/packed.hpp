// Numbers and texts as bytes, and frames of bytes in a pipe: how the processes of a farm speak to each other.
//
// A number is eight bytes in the order of the machine, a text its length and its bytes, a frame a text. All machines of
// a farm are of one kind.
#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace waymark::tools {

class Packed {
 public:
  Packed& number(std::uint64_t value);
  Packed& text(std::string_view value);
  Packed& rest(std::string_view bytes);  // what was packed before, as it is
  const std::string& bytes() const { return bytes_; }

 private:
  std::string bytes_;
};

class Unpacked {  // refers to the bytes
 public:
  explicit Unpacked(std::string_view bytes) : bytes_(bytes) {}
  std::uint64_t number();  // both throw std::logic_error when too little is left
  std::string text();
  std::string_view rest() const { return bytes_; }  // what was not taken yet

 private:
  std::string_view bytes_;
};

// Frames as they come out of bytes that arrive in pieces.
class FrameCutter {
 public:
  void add(std::string_view bytes) { bytes_ += bytes; }
  std::optional<std::string> next();  // a whole one, in order

 private:
  std::string bytes_;
  std::size_t begin_ = 0;  // of what was not taken yet
};

std::string framed(std::string_view bytes);

// Wait until the frame is written, or there; nullopt when the pipe has ended before it. Throw std::system_error.
void write_frame(int pipe, std::string_view bytes);
std::optional<std::string> read_frame(int pipe);

}  // namespace waymark::tools

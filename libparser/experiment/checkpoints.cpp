#include "libparser/experiment/checkpoints.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <charconv>
#include <fstream>
#include <iterator>
#include <sstream>

#include "libltl/diagnostic.hpp"
#include "libltl/text/xxhash.hpp"
#include "libparser/model/weights_bytes.hpp"
#include "libparser/model/whole_file.hpp"

namespace waymark::parser {
namespace {

constexpr const char *settings_name = "settings.txt", *claims_name = "claims";

std::string checked(const std::string& text) {
  std::array<char, 16> digits{};
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), ltl::xxh64(text), 16).ptr;
  return "xxh64 " + std::string(digits.data(), end) + '\n' + text;
}

// "'seed 1', not 'seed 2'": the first line in which they differ.
std::string difference(const std::string& theirs, const std::string& ours) {
  std::istringstream a(theirs), b(ours);
  std::string x, y;
  while (true) {
    const bool more_a = static_cast<bool>(std::getline(a, x)), more_b = static_cast<bool>(std::getline(b, y));
    if (!more_a) x.clear();
    if (!more_b) y.clear();
    if (x != y || (!more_a && !more_b)) return "'" + x + "', not '" + y + "'";
  }
}

}  // namespace

Claim::~Claim() {
  if (file_ >= 0) ::close(file_);
}

Checkpoints::Checkpoints(std::filesystem::path directory, const std::string& settings)
    : directory_(std::move(directory)) {
  std::error_code error;
  std::filesystem::create_directories(directory_, error);
  if (error) throw ltl::FormatError(directory_.string(), 0, 0, "cannot be made: " + error.message());
  if (const auto theirs = find(settings_name); !theirs)
    keep(settings_name, settings);
  else if (*theirs != settings)
    throw ltl::FormatError(directory_.string(), 0, 0,
                           "holds an experiment of other settings (" + difference(*theirs, settings) +
                               "): name another directory, or remove it");
}

bool Checkpoints::has(const std::string& name) const { return std::filesystem::exists(directory_ / name); }

std::optional<std::string> Checkpoints::find(const std::string& name) const {
  const std::filesystem::path file = directory_ / name;
  if (!has(name)) return std::nullopt;
  std::ifstream in(file, std::ios::binary);
  std::string bytes{std::istreambuf_iterator<char>(in), {}};
  if (!in) throw ltl::FormatError(file.string(), 0, 0, "cannot be read");
  return bytes;
}

void Checkpoints::keep(const std::string& name, const std::string& bytes) const {
  write_file(directory_ / name, bytes);
}

// A lock of the open file description on one byte, whose place stands for the part. Two parts of one place only wait
// for each other.
std::optional<Claim> Checkpoints::claim(const std::string& name) const {
  Claim claim(::open((directory_ / claims_name).c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666));
  struct flock lock {};
  lock.l_type = F_WRLCK;
  lock.l_whence = SEEK_SET;
  lock.l_start = static_cast<off_t>(ltl::xxh64(name) >> 2U);
  lock.l_len = 1;
  if (claim.file_ >= 0 && ::fcntl(claim.file_, F_OFD_SETLK, &lock) != 0 && (errno == EAGAIN || errno == EACCES))
    return std::nullopt;
  return claim;
}

std::optional<std::string> Checkpoints::find_text(const std::string& name) const {
  const std::optional<std::string> found = find(name);
  if (!found || found->empty()) return std::nullopt;
  std::string text = found->substr(std::min(found->find('\n'), found->size() - 1) + 1);
  if (checked(text) != *found) return std::nullopt;
  return text;
}

void Checkpoints::keep_text(const std::string& name, const std::string& text) const { keep(name, checked(text)); }

}  // namespace waymark::parser

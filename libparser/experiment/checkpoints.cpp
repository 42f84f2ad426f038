#include "libparser/experiment/checkpoints.hpp"

#include <fstream>
#include <sstream>

#include "libltl/diagnostic.hpp"
#include "libparser/model/weights_bytes.hpp"

namespace waymark::parser {
namespace {

constexpr const char* settings_name = "settings.txt";

}  // namespace

Checkpoints::Checkpoints(std::filesystem::path directory, const std::string& settings)
    : directory_(std::move(directory)) {
  std::error_code error;
  std::filesystem::create_directories(directory_, error);
  if (error) throw ltl::FormatError(directory_.string(), 0, 0, "cannot be made: " + error.message());
  if (const auto theirs = find(settings_name); !theirs)
    keep(settings_name, settings);
  else if (*theirs != settings)
    throw ltl::FormatError(directory_.string(), 0, 0,
                           "holds an experiment of other settings (see " + std::string(settings_name) +
                               " there): name another directory, or remove it");
}

bool Checkpoints::has(const std::string& name) const { return std::filesystem::exists(directory_ / name); }

std::optional<std::string> Checkpoints::find(const std::string& name) const {
  const std::filesystem::path file = directory_ / name;
  if (!has(name)) return std::nullopt;
  std::ifstream in(file, std::ios::binary);
  std::ostringstream bytes;
  bytes << in.rdbuf();
  if (!in || !bytes) throw ltl::FormatError(file.string(), 0, 0, "cannot be read");
  return std::move(bytes).str();
}

void Checkpoints::keep(const std::string& name, const std::string& bytes) const {
  write_weights(bytes, (directory_ / name).string());
}

}  // namespace waymark::parser

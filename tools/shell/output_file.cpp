#include "tools/shell/output_file.hpp"

#include <unistd.h>

#include <string>
#include <system_error>
#include <utility>

#include "libltl/diagnostic.hpp"
#include "tools/shell/output.hpp"

namespace waymark::tools {

OutputFile::OutputFile(std::filesystem::path path)
    : path_(std::move(path)), unfinished_(path_.string() + '.' + std::to_string(::getpid())), block_(1U << 20U) {
  check_writable(path_);
  file_.rdbuf()->pubsetbuf(block_.data(), static_cast<std::streamsize>(block_.size()));
  file_.open(unfinished_, std::ios::binary);
  if (!file_) throw ltl::FormatError(path_.string(), 0, 0, "cannot write the file");
}

OutputFile::~OutputFile() {
  std::error_code ignored;
  if (!unfinished_.empty()) std::filesystem::remove(unfinished_, ignored);
}

void OutputFile::finish() {
  file_.close();
  if (!file_) throw ltl::FormatError(path_.string(), 0, 0, "cannot write the whole file");
  std::error_code error;
  std::filesystem::rename(unfinished_, path_, error);
  if (error) throw ltl::FormatError(path_.string(), 0, 0, "cannot write the file: " + error.message());
  unfinished_.clear();
}

}  // namespace waymark::tools

// A file that is written as its contents are made, for contents that memory should not hold.
#pragma once
#include <filesystem>
#include <fstream>
#include <vector>

namespace waymark::tools {

// Under another name beside the target until it is finished, so that the target is complete or absent. Throws
// ltl::FormatError naming the target and the reason.
class OutputFile {
 public:
  explicit OutputFile(std::filesystem::path path);
  ~OutputFile();  // removes what was not finished
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  std::ostream& stream() { return file_; }
  void finish();

 private:
  std::filesystem::path path_, unfinished_;
  std::vector<char> block_;
  std::ofstream file_;
};

}  // namespace waymark::tools

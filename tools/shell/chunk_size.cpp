#include "tools/shell/chunk_size.hpp"

#include <algorithm>
#include <cstdlib>
#include <sstream>
#include <string>

#include "tools/shell/exit_code.hpp"

namespace waymark::tools {

void ChunkSize::learn(std::size_t texts, double took) {
  if (texts == 0) return;
  const double each = took / static_cast<double>(texts);
  each_ = each_ == 0 ? each : (each_ + each) / 2;
  const std::size_t most = std::min(2 * texts_, most_texts);
  const double wanted = each_ > 0 ? seconds_ / each_ : static_cast<double>(most);
  texts_ = wanted >= static_cast<double>(most) ? most : std::max<std::size_t>(1, static_cast<std::size_t>(wanted));
}

double chunk_seconds() {
  const char* variable = std::getenv("WAYMARK_CHUNK_SECONDS");
  if (variable == nullptr || *variable == '\0') return 0.5;
  std::istringstream number(variable);
  double seconds = 0;
  if (!(number >> seconds) || !number.eof() || !(seconds >= 0))
    throw UsageError("the environment variable WAYMARK_CHUNK_SECONDS is '" + std::string(variable) +
                     "': expected a number of seconds");
  return seconds;
}

}  // namespace waymark::tools

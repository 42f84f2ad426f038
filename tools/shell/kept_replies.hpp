// Answered parts of a batch, kept in a folder: the same command goes on from them.
//
// A part is a file FIRST-COUNT.replies with the replies to COUNT texts from text FIRST on, counted from 0, and with the
// checksum of those texts. Parts are written whole or not at all (libparser/experiment/checkpoints.hpp). Several
// processes may write one folder; parts that overlap hold equal replies.
#pragma once
#include <cstddef>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "libparser/experiment/checkpoints.hpp"
#include "tools/shell/reply.hpp"

namespace waymark::tools {

class KeptReplies {
 public:
  // `settings`: what the replies depend on beside the texts. Throws ltl::FormatError as Checkpoints does.
  KeptReplies(const std::string& folder, const std::string& settings);

  // How many texts the largest part has that begins with this text, as the folder was when this began; 0: none.
  std::size_t count_from(std::size_t first) const;

  // The first text of the part that holds this text and begins last; this text where there is none.
  std::size_t begin_of_part(std::size_t text) const;

  // The replies of that part, to these texts. Nothing when the file is damaged. Throws ltl::FormatError when its texts
  // were others.
  std::optional<std::vector<Reply>> find(std::size_t first, std::span<const Text> texts) const;

  // From several threads. Throws ltl::FormatError when the file cannot be written.
  void keep(std::size_t first, std::span<const Text> texts, std::span<const Reply> replies) const;

 private:
  std::string folder_;
  parser::Checkpoints parts_;
  std::map<std::size_t, std::size_t> counts_;  // by first text
};

}  // namespace waymark::tools

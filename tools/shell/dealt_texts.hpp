// The texts that this process has to answer: those of its share, and of them those that no run before it has answered.
#pragma once
#include <deque>
#include <functional>
#include <optional>
#include <string>

#include "tools/shell/command.hpp"
#include "tools/shell/input.hpp"
#include "tools/shell/kept_replies.hpp"
#include "tools/shell/reply.hpp"

namespace waymark::tools {

struct DealOptions {
  std::string share = {};  // "3/16": the third of 16 parts of as many texts each; empty: all texts
  std::string kept = {};   // a folder; empty: none
};
void add_deal_options(Command command, DealOptions& options);

// Is this process the one that prints what stands before the first reply? Throws UsageError for what is no share.
bool has_first_share(const DealOptions& options);

struct DealtText {
  std::size_t number = 0;  // in the whole batch, from 0
  Text text;
  std::optional<Reply> made = {};  // by a run before this one
};

class DealtTexts {
 public:
  // `settings` is asked for when replies are kept. A share counts the texts first. Throws UsageError for what is no
  // share and for a share of standard input, ltl::FormatError as KeptReplies does.
  DealtTexts(TextReader& texts, const DealOptions& options, const std::function<std::string()>& settings);

  std::optional<DealtText> next();  // throws ltl::FormatError when there is no text at all
  bool is_batch() const { return texts_.is_batch(); }
  const KeptReplies* kept() const { return kept_ ? &*kept_ : nullptr; }

 private:
  void look_ahead();  // into a kept part that begins here

  TextReader& texts_;
  std::optional<KeptReplies> kept_;
  std::size_t first_ = 0, end_;  // of the share
  bool is_part_ = false;         // of a batch that has texts
  std::size_t read_ = 0;         // texts of the batch
  std::deque<DealtText> ahead_;
};

// Keeps replies that come one by one and in order, several in one part: a part ends when it is large, when its first
// reply is some time ago, and where an older part begins.
class ReplyKeeper {
 public:
  ReplyKeeper(const KeptReplies* kept, double seconds) : kept_(kept), seconds_(seconds) {}
  void put(DealtText text, const Reply& reply);  // a made one ends the part and is not kept again
  void end_part();

 private:
  const KeptReplies* kept_;  // nullptr: nothing is kept
  double seconds_;
  double begun_ = 0;  // of the clock
  std::size_t first_ = 0, bytes_ = 0;
  std::vector<Text> texts_;
  std::vector<Reply> replies_;
};

}  // namespace waymark::tools

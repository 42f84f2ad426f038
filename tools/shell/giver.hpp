// The giver of a farm: gives the texts of a batch out to hands in chunks, and prints the replies in the order of the
// texts. What a hand was at work on when it was lost is given anew.
#pragma once
#include <stop_token>

#include "tools/shell/dealt_texts.hpp"
#include "tools/shell/exit_code.hpp"
#include "tools/shell/seat.hpp"

namespace waymark::tools {

// As answer_in_parallel. At most 256 MiB of replies wait for earlier ones; then no new text is given out. A text that
// ended eight hands, alone in its chunk, is answered with `bad` and ExitCode::GaveUp.
ExitCode give_out(DealtTexts& texts, const Seat& seat, const std::stop_token& stop, const BadTextReply& bad);

}  // namespace waymark::tools

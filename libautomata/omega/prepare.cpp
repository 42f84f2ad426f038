#include "libautomata/omega/prepare.hpp"

#include <optional>

#include "libautomata/omega/containment.hpp"
#include "libltl/rewriting/nnf.hpp"
#include "libltl/rewriting/separate.hpp"
#include "libltl/rewriting/simplify.hpp"

namespace waymark::automata {
namespace {

using ltl::Formula;

constexpr std::size_t containment_steps = 500'000;

}  // namespace

// Two rounds because each makes work for the other, unless separation found none.
Prepared prepared_forms(Formula f, const std::vector<ltl::Proposition>& reads, const std::stop_token& stop) {
  Budget budget(containment_steps, SIZE_MAX, stop);
  Containment implies(reads, budget);
  std::optional<Formula> plain;
  f = ltl::simplify(f, ltl::Over::Infinite, {}, stop);
  for (int round = 0; round < 2; ++round) {
    f = ltl::nnf(ltl::simplify(
        f, ltl::Over::Infinite, [&](Formula g, Formula h) { return implies(g, h); }, stop));
    if (!plain) plain = f;
    const Formula separated = ltl::separate(f);
    if (separated == f) break;
    f = separated;
  }
  return {f, *plain};
}

}  // namespace waymark::automata

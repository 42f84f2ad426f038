#include "tools/distributed/band_product.hpp"

#include "tools/shell/exit_code.hpp"

namespace waymark::tools {

BandProduct::BandProduct(const GridBand& band, const plan::TaskTable& task) : band_(&band), task_(&task) {
  constexpr std::uint64_t most = std::uint64_t{1} << 31U;  // numbers of PETSc with 32 bits, sign included
  if (std::uint64_t{task.states()} * band.places() >= most)
    throw GaveUp("gave up: the band of a rank has more than 2^31 pairs; more ranks have smaller bands");
  for (std::uint32_t k = 0; k < 4; ++k) {
    for (std::uint32_t d = 0; d < 4; ++d)
      if (band.chance(k, d) > 0) directions_[k] |= 1U << d;
    all_directions_ |= directions_[k];
  }
}

BandProduct::Around BandProduct::around(std::uint32_t pair) const {
  const std::uint32_t here = place(pair), q = state(pair);
  Around out;
  for (std::uint32_t d = 0; d < 4; ++d) {
    const std::uint32_t there = band_->move(here, d);
    const plan::TaskTable::Successor step = task_->next(q, band_->letter(there));
    out.to[d] = step.target == plan::TaskTable::trap ? trap : number(there, step.target);
    if (step.marked) out.marked |= 1U << d;
  }
  return out;
}

}  // namespace waymark::tools

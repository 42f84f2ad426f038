#include "tools/distributed/band_sets.hpp"

#include <bit>
#include <utility>

namespace waymark::tools {

BandSets::BandSets(const Ranks& ranks, const BandProduct& product, const Halo& halo)
    : ranks_(&ranks), product_(&product), halo_(&halo), flags_(product.pairs(), 0) {}

std::uint32_t BandSets::directions_into(const BandProduct::Around& around, std::uint8_t flag) const {
  std::uint32_t out = 0;
  for (std::uint32_t d = 0; d < 4; ++d)
    if (around.to[d] != BandProduct::trap && has(around.to[d], flag)) out |= 1U << d;
  return out;
}

std::uint32_t BandSets::directions_to_trap(const BandProduct::Around& around) const {
  std::uint32_t out = 0;
  for (std::uint32_t d = 0; d < 4; ++d)
    if (around.to[d] == BandProduct::trap) out |= 1U << d;
  return out;
}

// Forwards: what lies in the halo is offered to its owner.
void BandSets::reach() {
  std::vector<std::uint32_t> open;
  const auto meet = [&](std::uint32_t pair) {
    if (has(pair, Reached)) return;
    set(pair, Reached);
    if (product_->band().is_own(product_->place(pair))) open.push_back(pair);
  };
  if (const auto start = product_->band().own_start())
    for (const std::uint32_t q : product_->task().initial_states()) {
      const auto step = product_->task().next(q, product_->band().letter(*start));
      if (step.target == plan::TaskTable::trap) continue;
      starts_.push_back(product_->number(*start, step.target));
      meet(starts_.back());
    }
  const GridBand& band = product_->band();
  const auto for_each_of_border = [&](const auto& visit) {  // own pairs whose copies lie in the halo of a neighbour
    for (std::uint32_t q = 0; q < product_->task().states(); ++q)
      for (std::uint32_t x = 0; x < band.width(); ++x) {
        visit(product_->number(band.first_own() + x, q));
        visit(product_->number(band.last_own() - band.width() + x, q));
      }
  };
  std::vector<std::uint8_t> before;
  do {
    while (!open.empty()) {
      const std::uint32_t pair = open.back();
      open.pop_back();
      if (product_->is_goal(pair)) continue;
      const auto around = product_->around(pair);
      for (std::uint32_t d = 0; d < 4; ++d)
        if (around.to[d] != BandProduct::trap && ((product_->all_directions() >> d) & 1U) != 0) meet(around.to[d]);
      for (const std::uint32_t q : product_->jumps(pair)) meet(product_->number(product_->place(pair), q));
    }
    before.clear();
    for_each_of_border([&](std::uint32_t pair) { before.push_back(flags_[pair]); });
    halo_->offer(flags_.data());
    std::size_t i = 0;
    for_each_of_border([&](std::uint32_t pair) {
      if (before[i++] != flags_[pair]) open.push_back(pair);
    });
  } while (ranks_->any(!open.empty()));
  halo_->fetch(flags_.data());
  count();
}

void BandSets::count() {
  std::uint64_t pairs = 0, edges = 0;
  product_->for_each_own([&](std::uint32_t pair) {
    if (!has(pair, Reached)) return;
    ++pairs;
    if (product_->is_goal(pair)) return;
    const std::uint32_t lost = directions_to_trap(product_->around(pair));
    for (std::uint32_t k = 0; k < 4; ++k)
      edges += static_cast<std::uint64_t>(std::popcount(product_->directions(k) & ~lost));
    edges += product_->jumps(pair).size();
  });
  pairs_ = ranks_->sum(pairs);
  edges_ = ranks_->sum(edges);
}

// look(pair): of an own pair; true: its flags changed, so its predecessors are to be looked at.
template <class Look>
void BandSets::settle(std::deque<std::uint32_t> open, const Look& look) {
  do {
    for (; !open.empty(); open.pop_front())
      if (look(open.front()))
        product_->for_each_predecessor(open.front(), [&](std::uint32_t pair) { open.push_back(pair); });
    halo_->fetch(flags_.data());
    std::size_t i = 0;
    product_->for_each_copy([&](std::uint32_t copy) {
      if (seen_[i++] == flags_[copy]) return;
      seen_[i - 1] = flags_[copy];
      product_->for_each_predecessor(copy, [&](std::uint32_t pair) { open.push_back(pair); });
    });
  } while (ranks_->any(!open.empty()));
}

// Does some choice keep the pair inside?
bool BandSets::stays_inside(std::uint32_t pair) const {
  const std::uint32_t inside = directions_into(product_->around(pair), Inside);
  for (std::uint32_t k = 0; k < 4; ++k)
    if ((product_->directions(k) & ~inside) == 0) return true;
  for (const std::uint32_t q : product_->jumps(pair))
    if (has(product_->number(product_->place(pair), q), Inside)) return true;
  return false;
}

// Takes pairs out that no choice keeps inside, until there are none.
void BandSets::keep_inside() {
  const auto look = [&](std::uint32_t pair) {
    if (!has(pair, Inside) || product_->is_goal(pair) || stays_inside(pair)) return false;
    clear(pair, Inside);
    return true;
  };
  std::deque<std::uint32_t> open;
  product_->for_each_copy([&](std::uint32_t copy) { seen_.push_back(flags_[copy]); });
  product_->for_each_own([&](std::uint32_t pair) {
    if (look(pair)) product_->for_each_predecessor(pair, [&](std::uint32_t source) { open.push_back(source); });
  });
  settle(std::move(open), look);
  seen_.clear();
}

// Joined becomes the least set with the seeds and what joins by it; nearest to the seeds first.
template <class Seed, class Joins>
void BandSets::join(const Seed& is_seed, const Joins& joins) {
  joined_.clear();
  for (std::uint8_t& flags : flags_) flags = static_cast<std::uint8_t>(flags & ~Joined);
  product_->for_each_own([&](std::uint32_t pair) {
    if (is_seed(pair)) joined_.push_back(pair);
  });
  for (const std::uint32_t pair : joined_) set(pair, Joined);
  std::deque<std::uint32_t> open;
  for (const std::uint32_t pair : joined_)
    product_->for_each_predecessor(pair, [&](std::uint32_t source) { open.push_back(source); });
  seen_.clear();
  product_->for_each_copy([&](std::uint32_t copy) { seen_.push_back(flags_[copy]); });
  settle(std::move(open), [&](std::uint32_t pair) {
    if (has(pair, Joined) || !is_open(pair) || !joins(pair)) return false;
    set(pair, Joined);
    joined_.push_back(pair);
    return true;
  });
  seen_.clear();
}

bool BandSets::joins_surely(std::uint32_t pair, bool by_mark) const {
  if (!has(pair, Inside)) return false;
  const auto around = product_->around(pair);
  const std::uint32_t inside = directions_into(around, Inside);
  const std::uint32_t good = by_mark ? around.marked : directions_into(around, Joined);
  for (std::uint32_t k = 0; k < 4; ++k)
    if ((product_->directions(k) & ~inside) == 0 && (product_->directions(k) & good) != 0) return true;
  if (by_mark) return false;
  for (const std::uint32_t q : product_->jumps(pair)) {
    const std::uint32_t to = product_->number(product_->place(pair), q);
    if (has(to, Inside) && has(to, Joined)) return true;
  }
  return false;
}

bool BandSets::joins_by_chance(std::uint32_t pair) const {
  if ((directions_into(product_->around(pair), Joined) & product_->all_directions()) != 0) return true;
  for (const std::uint32_t q : product_->jumps(pair))
    if (has(product_->number(product_->place(pair), q), Joined)) return true;
  return false;
}

void BandSets::replace(std::uint8_t from, std::uint8_t to) {
  for (std::uint8_t& flags : flags_) flags = static_cast<std::uint8_t>((flags & from) != 0 ? flags | to : flags & ~to);
}

bool BandSets::differ(std::uint8_t a, std::uint8_t b) const {
  bool differ = false;
  product_->for_each_own([&](std::uint32_t pair) { differ = differ || has(pair, a) != has(pair, b); });
  return ranks_->any(differ);
}

// Inside becomes what wins almost surely.
void BandSets::almost_surely() {
  replace(Reached, Inside);
  do {
    keep_inside();
    join([&](std::uint32_t pair) { return has(pair, Inside) && (product_->is_goal(pair) || joins_surely(pair, true)); },
         [&](std::uint32_t pair) { return joins_surely(pair, false); });
    if (!differ(Inside, Joined)) return;
    replace(Joined, Inside);
  } while (true);
}

void BandSets::solve(SharedMeasure measure) {
  const auto by_chance = [&](std::uint32_t pair) { return joins_by_chance(pair); };
  if (measure != SharedMeasure::Discounted) almost_surely();
  if (measure == SharedMeasure::MaxProbability) {
    replace(Inside, Target);
    join([&](std::uint32_t pair) { return has(pair, Target); }, by_chance);
  } else {
    for (std::uint32_t pair = 0; pair < flags_.size(); ++pair)
      if (has(pair, Reached) && product_->is_goal(pair)) set(pair, Target);
    if (measure == SharedMeasure::Discounted) join([&](std::uint32_t pair) { return has(pair, Target); }, by_chance);
  }
  for (std::uint32_t pair = 0; pair < flags_.size(); ++pair)
    if (has(pair, Joined) && !has(pair, Target)) set(pair, Unknown);
}

std::vector<std::uint32_t> BandSets::unknowns(std::uint32_t first_state, std::uint32_t last_state) const {
  std::vector<std::uint32_t> out;
  for (const std::uint32_t pair : joined_)
    if (const std::uint32_t q = product_->state(pair); q >= first_state && q < last_state && is_unknown(pair))
      out.push_back(pair);
  return out;
}

}  // namespace waymark::tools

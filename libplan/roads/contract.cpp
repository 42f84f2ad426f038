#include "libplan/roads/contract.hpp"

#include <algorithm>
#include <functional>
#include <numeric>
#include <queue>
#include <stdexcept>
#include <utility>
#include <vector>

#include "libplan/roads/road_shortcuts.hpp"

namespace waymark::plan {
namespace {

// What each letter means to shortcuts: nothing (the empty letter), a bit, or that its nodes stay in the core.
class LetterBits {
 public:
  static constexpr std::uint8_t none = 64, core = 65;

  LetterBits(const RoadGraph& graph, const ContractionOptions& options) : of_(graph.letters().size(), core) {
    of_[0] = none;
    std::vector<std::uint32_t> order(of_.size() - 1);
    std::iota(order.begin(), order.end(), 1U);
    std::stable_sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
      return graph.count(LetterId{a}) > graph.count(LetterId{b});
    });
    std::size_t rare = 0;
    while (!order.empty() && graph.count(LetterId{order.back()}) <= options.rare &&
           rare + graph.count(LetterId{order.back()}) <= options.most_rare) {
      rare += graph.count(LetterId{order.back()});
      order.pop_back();
    }
    if (order.size() > RoadHierarchy::most_bits) order.resize(RoadHierarchy::most_bits);
    for (std::size_t b = 0; b < order.size(); ++b) of_[order[b]] = static_cast<std::uint8_t>(b);
    letters_ = std::move(order);
  }

  std::uint8_t of(LetterId letter) const { return of_[letter.index]; }
  std::uint64_t set(LetterId letter) const { return of(letter) < none ? std::uint64_t{1} << of(letter) : 0; }
  const std::vector<std::uint32_t>& letters() const { return letters_; }  // by bit

 private:
  std::vector<std::uint8_t> of_;
  std::vector<std::uint32_t> letters_;
};

// A few nodes with their least costs, by open addressing.
class Found {
 public:
  void clear() {
    for (const std::size_t at : used_) keys_[at] = empty;
    used_.clear();
    wanted_ = 0;
  }
  std::uint64_t& operator[](std::uint32_t node) { return values_[place(node)]; }  // UINT64_MAX when it is new
  void want(std::uint32_t node) {
    const std::size_t at = place(node);
    wanted_ += is_wanted_[at] ? 0 : 1;
    is_wanted_[at] = true;
  }
  bool settle(std::uint32_t node) {  // was it wanted?
    const std::size_t at = place(node);
    const bool was = is_wanted_[at];
    wanted_ -= was ? 1 : 0;
    is_wanted_[at] = false;
    return was;
  }
  std::size_t wanted() const { return wanted_; }  // and not settled
  bool is_full() const { return used_.size() > keys_.size() / 2; }

 private:
  static constexpr unsigned bits = 13;
  static constexpr std::uint32_t empty = UINT32_MAX;
  std::size_t place(std::uint32_t node) {
    std::size_t at = (node * 0x9E3779B1U) >> (32 - bits);
    while (keys_[at] != node && keys_[at] != empty) at = (at + 1) % keys_.size();
    if (keys_[at] == empty) {
      keys_[at] = node;
      values_[at] = UINT64_MAX;
      is_wanted_[at] = false;
      used_.push_back(at);
    }
    return at;
  }
  std::vector<std::uint32_t> keys_ = std::vector<std::uint32_t>(std::size_t{1} << bits, empty);
  std::vector<std::uint64_t> values_ = std::vector<std::uint64_t>(std::size_t{1} << bits, UINT64_MAX);
  std::vector<bool> is_wanted_ = std::vector<bool>(std::size_t{1} << bits, false);
  std::vector<std::size_t> used_;
  std::size_t wanted_ = 0;
};

class Contraction {
 public:
  Contraction(const RoadGraph& graph, const ContractionOptions& options)
      : graph_(graph),
        options_(options),
        letters_(graph, options),
        roads_(graph),
        rank_(graph.nodes(), remaining),
        level_(graph.nodes(), 0) {}

  std::optional<RoadHierarchy> run() {
    if (!contract_rounds(2)) return std::nullopt;
    if (!(options_.quick ? contract_rounds(3) && contract_rounds(4) : contract_by_priority())) return std::nullopt;
    return hierarchy();
  }

 private:
  using Arc = RoadHierarchy::Arc;
  static constexpr std::uint64_t polls = 1U << 12U;  // nodes
  static constexpr std::uint32_t remaining = UINT32_MAX;
  static constexpr std::size_t nodes_a_mark = 64;  // where marks are quicker than sorting
  bool may_contract(std::uint32_t v) const {
    return rank_[v] == remaining && letters_.of(graph_.letter(v)) != LetterBits::core;
  }

  // Nodes of so many arcs at most, as long as there are any; no two neighbours in one round.
  bool contract_rounds(std::size_t most_arcs) {
    const auto is_due = [&](std::uint32_t v) { return may_contract(v) && roads_.arcs(v).size() <= most_arcs; };
    std::vector<std::uint32_t> open, next;
    for (std::uint32_t v = 0; v < graph_.nodes(); ++v)
      if (is_due(v)) open.push_back(v);
    std::vector<bool> touched(graph_.nodes(), false);
    while (!open.empty()) {
      if (options_.stop.stop_requested()) return false;
      next.clear();
      std::fill(touched.begin(), touched.end(), false);
      for (const std::uint32_t v : open) {
        if (!is_due(v)) continue;
        if (touched[v]) {
          next.push_back(v);
          continue;
        }
        for (const Arc& arc : roads_.arcs(v)) touched[arc.head] = true;
        contract_node(v, 0);
        for (const Arc& arc : roads_.arcs(v))
          if (is_due(arc.head)) next.push_back(arc.head);
      }
      put_in_order(next, touched);
      open.swap(next);
    }
    return true;
  }

  // Ascending and once each. Of many nodes by marking them, which takes a pass over a bit of every node of the map.
  void put_in_order(std::vector<std::uint32_t>& nodes, std::vector<bool>& marked) const {
    if (nodes.size() < marked.size() / nodes_a_mark) {
      std::sort(nodes.begin(), nodes.end());
      nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
      return;
    }
    std::fill(marked.begin(), marked.end(), false);
    for (const std::uint32_t v : nodes) marked[v] = true;
    nodes.clear();
    for (std::uint32_t v = 0; v < marked.size(); ++v)
      if (marked[v]) nodes.push_back(v);
  }

  bool contract_by_priority() {
    using Entry = std::pair<std::uint32_t, std::uint32_t>;  // priority, node
    std::vector<Entry> entries;
    for (std::uint32_t v = 0; v < graph_.nodes(); ++v)
      if (may_contract(v)) {
        if (entries.size() % polls == 0 && options_.stop.stop_requested()) return false;
        entries.emplace_back(priority(v), v);
      }
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> heap(std::greater<>(), std::move(entries));
    for (std::uint64_t done = 0; !heap.empty(); ++done) {
      if (done % polls == 0 && options_.stop.stop_requested()) return false;
      const std::uint32_t v = heap.top().second;
      heap.pop();
      const std::uint32_t now = priority(v);
      if (!heap.empty() && now > heap.top().first) {
        heap.emplace(now, v);
        continue;
      }
      if (roads_.arcs(v).size() > options_.most_degree) return true;
      contract_node(v, options_.settled);
    }
    return true;
  }

  // Shortcuts needed for each arc there is, and the level.
  std::uint32_t priority(std::uint32_t v) {
    std::uint32_t added = 0, removed = 0;
    for (const Arc& arc : roads_.arcs(v)) removed += (arc.ways & 1U) + (arc.ways >> 1U);
    for_each_shortcut(v, options_.settled_to_rank,
                      [&](std::uint32_t, std::uint32_t, std::uint64_t, std::uint64_t) { ++added; });
    return 1000U * level_[v] + 1000U * (added + 1) / (removed + 1);
  }

  void contract_node(std::uint32_t v, std::uint32_t settled) {
    rank_[v] = static_cast<std::uint32_t>(order_.size());
    order_.push_back(v);
    struct Shortcut {
      std::uint32_t from, to, cost;
      std::uint16_t passed;
    };
    std::vector<Shortcut> shortcuts;
    for_each_shortcut(v, settled, [&](std::uint32_t u, std::uint32_t w, std::uint64_t cost, std::uint64_t set) {
      if (cost > UINT32_MAX) throw std::invalid_argument("costs of roads add up to 2^32");
      shortcuts.push_back({u, w, static_cast<std::uint32_t>(cost), roads_.sets().number(set)});
    });
    roads_.detach(v);
    for (const Shortcut& s : shortcuts) roads_.add(s.from, {s.to, s.cost, v, s.passed, RoadHierarchy::forward});
    for (const Arc& arc : roads_.arcs(v))
      level_[arc.head] = std::max<std::uint16_t>(level_[arc.head], static_cast<std::uint16_t>(level_[v] + 1));
  }

  // visit(from, to, cost, letters passed): the pairs of arcs through v that no witness replaces.
  template <class Visit>
  void for_each_shortcut(std::uint32_t v, std::uint32_t settled, const Visit& visit) {
    const std::uint64_t here = letters_.set(graph_.letter(v));
    const auto arcs = roads_.arcs(v);
    for (const Arc& in : arcs) {
      if ((in.ways & RoadHierarchy::backward) == 0) continue;
      const std::uint64_t passed = roads_.sets()[in.passed] | here;
      std::uint64_t most = 0;
      std::size_t wanted = 0;
      for (const Arc& out : arcs)
        if (out.head != in.head && (out.ways & RoadHierarchy::forward) != 0) {
          most = std::max<std::uint64_t>(most, std::uint64_t{in.cost} + out.cost);
          ++wanted;
        }
      if (wanted == 0) continue;
      found_.clear();
      if (settled > 0) {
        for (const Arc& out : arcs)
          if (out.head != in.head && (out.ways & RoadHierarchy::forward) != 0) found_.want(out.head);
        find_witnesses(in.head, v, passed, most, settled);
      }
      for (const Arc& out : arcs) {
        if (out.head == in.head || (out.ways & RoadHierarchy::forward) == 0) continue;
        const std::uint64_t cost = std::uint64_t{in.cost} + out.cost;
        if (settled == 0 || found_[out.head] > cost) visit(in.head, out.head, cost, passed | roads_.sets()[out.passed]);
      }
    }
  }

  // Costs of ways from u that pass neither v nor letters besides those given, up to `most`: upper bounds, in found_.
  void find_witnesses(std::uint32_t u, std::uint32_t v, std::uint64_t passed, std::uint64_t most,
                      std::uint32_t settled) {
    const LetterSets& sets = roads_.sets();
    open_.clear();
    found_[u] = 0;
    open_.emplace_back(0, u);
    for (; !open_.empty() && settled > 0 && !found_.is_full(); --settled) {
      std::pop_heap(open_.begin(), open_.end(), std::greater<>());
      const auto [cost, at] = open_.back();
      open_.pop_back();
      if (cost > most) return;
      if (cost > found_[at]) continue;
      if (found_.settle(at) && found_.wanted() == 0) return;
      const LetterId letter = graph_.letter(at);
      if (at != u && (letters_.of(letter) == LetterBits::core || (letters_.set(letter) & ~passed) != 0)) continue;
      for (const Arc& arc : roads_.arcs(at)) {
        if ((arc.ways & RoadHierarchy::forward) == 0 || arc.head == v || (sets[arc.passed] & ~passed) != 0) continue;
        std::uint64_t& known = found_[arc.head];
        const std::uint64_t there = cost + arc.cost;
        if (there >= known || there > most) continue;
        known = there;
        open_.emplace_back(there, arc.head);
        std::push_heap(open_.begin(), open_.end(), std::greater<>());
      }
    }
  }

  RoadHierarchy hierarchy() {
    RoadHierarchy::Parts parts;
    parts.map = graph_.checksum();
    parts.core = static_cast<std::uint32_t>(order_.size());
    for (std::uint32_t v = 0; v < graph_.nodes(); ++v)
      if (rank_[v] == remaining) {
        rank_[v] = static_cast<std::uint32_t>(order_.size());
        order_.push_back(v);
      }
    level_ = {};
    parts.rows.reserve(order_.size());
    for (const std::uint32_t v : order_)
      parts.rows.push_back({roads_.begin(v), static_cast<std::uint16_t>(roads_.arcs(v).size()),
                            static_cast<std::uint16_t>(graph_.letter(v).index)});
    order_ = {};
    parts.arcs = roads_.take_arcs();
    parts.sets = roads_.sets().all();
    roads_ = RemainingRoads();
    for (const RoadHierarchy::Row& row : parts.rows)
      for (std::uint32_t a = row.begin; a < row.begin + row.size; ++a) {
        Arc& arc = parts.arcs[a];
        arc.head = rank_[arc.head];
        if (arc.middle != RoadHierarchy::road) arc.middle = rank_[arc.middle];
      }
    parts.rank = std::move(rank_);
    parts.bits = letters_.letters();
    return RoadHierarchy(std::move(parts));
  }

  const RoadGraph& graph_;
  const ContractionOptions& options_;
  LetterBits letters_;
  RemainingRoads roads_;
  std::vector<std::uint32_t> rank_, order_;
  std::vector<std::uint16_t> level_;
  Found found_;
  std::vector<std::pair<std::uint64_t, std::uint32_t>> open_;
};

}  // namespace

std::optional<RoadHierarchy> contract(const RoadGraph& graph, const ContractionOptions& options) {
  return Contraction(graph, options).run();
}

}  // namespace waymark::plan

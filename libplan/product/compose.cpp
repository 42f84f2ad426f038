#include "libplan/product/compose.hpp"

#include <boost/graph/breadth_first_search.hpp>
#include <boost/pending/queue.hpp>

namespace waymark::plan {
namespace {

// The colour map of the search is the order itself: what has a number is not white.
struct Colors {
  using key_type = ProductState;
  using value_type = boost::default_color_type;
  using reference = value_type;
  using category = boost::read_write_property_map_tag;
  DiscoveryOrder* order;
  friend value_type get(const Colors& colors, const ProductState& v) {
    return colors.order->contains(v) ? boost::gray_color : boost::white_color;
  }
  friend void put(const Colors& colors, const ProductState& v, value_type color) {
    if (color == boost::gray_color) colors.order->insert(v);
  }
};

struct LimitMet {};  // thrown by the visitor: the way out of a Boost.Graph search

struct LimitVisitor : boost::default_bfs_visitor {
  const DiscoveryOrder* order;
  const ltl::Limits* limits;
  std::size_t examined = 0;

  template <class Graph>
  void examine_vertex(const ProductState&, const Graph&) {
    constexpr std::size_t polling_interval = 256;
    if (order->states().size() > limits->states ||
        (examined++ % polling_interval == 0 && limits->stop.stop_requested()))
      throw LimitMet{};
  }
};

}  // namespace

std::optional<MapProduct> MapProduct::explore(const Map& map, const automata::Dfa& dfa, std::span<const PoseId> starts,
                                              const ltl::Limits& limits) {
  MapProduct out(std::make_shared<const Parts>(Parts{MapMdp(map), TaskSteps(map, dfa)}));
  for (const PoseId s : starts)
    out.for_each_start(s.index, map.label_id(s), [&](const ProductState& v) { out.starts_.push_back(v); });
  boost::queue<ProductState> open;
  LimitVisitor visitor;
  visitor.order = &out.order_;
  visitor.limits = &limits;
  try {
    boost::breadth_first_visit(out, out.starts_.begin(), out.starts_.end(), open, visitor, Colors{&out.order_});
  } catch (const LimitMet&) {
    return std::nullopt;
  }
  return out;
}

MapProduct compose(const Map& map, const automata::Dfa& dfa, std::span<const PoseId> starts) {
  return *MapProduct::explore(map, dfa, starts, {.states = SIZE_MAX});
}

}  // namespace waymark::plan

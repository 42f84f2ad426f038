#include "libplan/solve/dijkstra.hpp"

#include <algorithm>
#include <boost/graph/dijkstra_shortest_paths.hpp>
#include <boost/property_map/property_map.hpp>
#include <cmath>
#include <functional>
#include <vector>

#include "libplan/product/discovery_order.hpp"

namespace waymark::plan {
namespace {

// Least costs by Boost.Graph's Dijkstra. Of pairs at equal cost the one that was met first is settled first: a distance
// is a cost and the number of its pair.
template <Model M>
struct Dijkstra {
  static constexpr std::uint32_t nothing = UINT32_MAX;
  static constexpr std::uint64_t pairs_between_polls = 1U << 16U;

  explicit Dijkstra(const Product<M, TaskTable>& of) : product(of), order(of.model().states(), of.task().states()) {}

  std::optional<SearchAnswer> run(const ProductState& first, const ltl::Limits& limits) {
    SearchAnswer answer;
    met[meet(first)].distance.cost = 0;
    try {
      boost::dijkstra_shortest_paths_no_init(
          product, first, boost::dummy_property_map(), Distances{{}, this}, Weights{{}, this}, Numbers{{}, this},
          std::less<>(),
          [](const Distance& d, const Distance& w) {
            return Distance{d.cost + w.cost, w.pair};
          },
          Distance{}, Visitor{{}, this, &answer, &limits}, Colors{{}, this});
    } catch (const Ended& ended) {
      if (ended.goal == nothing) return std::nullopt;
      answer.route = route(ended.goal);
    }
    answer.statistics.met = met.size();
    return answer;
  }

  struct Distance {
    double cost = 0;
    std::uint32_t pair = 0;
    friend auto operator<=>(const Distance&, const Distance&) = default;
  };
  struct Met {
    Distance distance;
    std::uint32_t from = nothing, choice = 0;
    boost::default_color_type color = boost::white_color;
  };
  struct Ended {  // thrown by the visitor: the way out of a Boost.Graph search
    std::uint32_t goal;
  };

  template <class Key, class Value, class Category>
  struct PropertyMap {
    using key_type = Key;
    using value_type = Value;
    using reference = Value;
    using category = Category;
  };
  struct Distances : PropertyMap<ProductState, Distance, boost::read_write_property_map_tag> {
    Dijkstra* search;
    friend Distance get(const Distances& m, const ProductState& s) { return m.search->at(s).distance; }
    friend void put(const Distances& m, const ProductState& s, Distance d) { m.search->at(s).distance = d; }
  };
  struct Colors : PropertyMap<ProductState, boost::default_color_type, boost::read_write_property_map_tag> {
    Dijkstra* search;
    friend boost::default_color_type get(const Colors& m, const ProductState& s) { return m.search->at(s).color; }
    friend void put(const Colors& m, const ProductState& s, boost::default_color_type color) {
      m.search->at(s).color = color;
    }
  };
  struct Weights : PropertyMap<ProductEdge, Distance, boost::readable_property_map_tag> {
    Dijkstra* search;  // which numbers the pair that an edge leads to: it is asked before anything else
    friend Distance get(const Weights& m, const ProductEdge& e) {
      return {m.search->product.cost(e), m.search->meet(e.to)};
    }
  };
  struct Numbers : PropertyMap<ProductState, std::size_t, boost::readable_property_map_tag> {
    Dijkstra* search;
    friend std::size_t get(const Numbers& m, const ProductState& s) { return m.search->order.number(s); }
  };

  struct Visitor : boost::dijkstra_visitor<> {
    Dijkstra* search;
    SearchAnswer* answer;
    const ltl::Limits* limits;

    template <class Graph>
    void examine_vertex(const ProductState& s, const Graph& g) {
      if (search->met.size() > limits->states ||
          (search->settled++ % pairs_between_polls == 0 && limits->stop.stop_requested()))
        throw Ended{nothing};
      if (g.is_goal(s)) throw Ended{search->order.number(s)};
      answer->statistics.edges += g.choices(s);
    }
    template <class Graph>
    void edge_relaxed(const ProductEdge& e, const Graph&) {
      Met& to = search->at(e.to);
      to.from = search->order.number(e.from);
      to.choice = e.choice;
    }
  };

  Met& at(const ProductState& s) { return met[order.number(s)]; }
  std::uint32_t meet(const ProductState& s) {
    const auto [number, fresh] = order.insert(s);
    if (fresh) met.push_back({{INFINITY, number}});
    return number;
  }
  ChoiceRoute route(std::uint32_t goal) const {
    ChoiceRoute out;
    out.cost = met[goal].distance.cost;
    for (std::uint32_t i = goal; i != nothing; i = met[i].from) {
      out.places.push_back(order.states()[i].place);
      if (met[i].from != nothing) out.choices.push_back(met[i].choice);
    }
    std::reverse(out.places.begin(), out.places.end());
    std::reverse(out.choices.begin(), out.choices.end());
    return out;
  }

  const Product<M, TaskTable>& product;
  DiscoveryOrder order;
  std::vector<Met> met;  // by number
  std::uint64_t settled = 0;
};

}  // namespace

template <Model M>
std::optional<SearchAnswer> dijkstra(const Product<M, TaskTable>& product, const ProductState& first,
                                     const ltl::Limits& limits) {
  return Dijkstra<M>(product).run(first, limits);
}

template std::optional<SearchAnswer> dijkstra(const Product<Mdp, TaskTable>&, const ProductState&, const ltl::Limits&);
template std::optional<SearchAnswer> dijkstra(const Product<GridWorld, TaskTable>&, const ProductState&,
                                              const ltl::Limits&);

}  // namespace waymark::plan

#include "libautomata/finite/very_weak.hpp"

#include <algorithm>
#include <unordered_map>
#include <utility>

namespace waymark::automata {
namespace {

constexpr std::uint32_t none = UINT32_MAX;

class BottomUp {
 public:
  BottomUp(const Transitions& automaton, const TransitionGraph& graph)
      : automaton_(automaton),
        graph_(graph),
        image_(graph.size()),
        summit_(graph.size()),
        placeholder_(Mtbdd::terminal(static_cast<std::uint32_t>(graph.states()))) {
    partition_.class_of.assign(graph.states(), none);
  }

  void state(std::uint32_t q, const std::vector<Vertex>& loop) {
    const Vertex self = graph_.of_state(q), root = graph_.root(q);
    const bool accepting = automaton_.accepting[q];
    assign(self, placeholder_, Summit{});
    for (Vertex n : loop) update(n);
    const std::uint64_t key = std::uint64_t{image_[root].id} << 1U | (accepting ? 1U : 0U);
    const auto [known, fresh] = by_shape_.try_emplace(key, partition_.classes);
    const Summit below = summit_[root];
    std::uint32_t c = known->second;
    if (fresh && below.unique && roots_[below.highest].accepting == accepting) {
      assign(self, Mtbdd::terminal(below.highest), below);
      for (Vertex n : loop) update(n);
      if (image_[root] == roots_[below.highest].image) c = known->second = below.highest;
    }
    const bool new_class = c == partition_.classes;
    if (new_class) {
      ++partition_.classes;
      roots_.push_back({{}, below.height + 1, accepting});
    }
    assign(self, Mtbdd::terminal(c), Summit{c, roots_[c].height, true});
    for (Vertex n : loop) update(n);
    if (new_class) roots_[c].image = image_[root];
    partition_.class_of[q] = c;
  }

  // A node below which all classes are known, or are placeholders.
  void update(Vertex n) {
    const auto [low, high] = std::pair(graph_.successors(n)[0], graph_.successors(n)[1]);
    image_[n] = images_.make(automaton_.diagram.variable(graph_.node(n)), image_[low], image_[high]);
    summit_[n] = join(summit_[low], summit_[high]);
  }

  Partition partition() && {
    for (const ClassRoot& root : roots_) partition_.roots.push_back(root.image);
    partition_.diagram = std::move(images_);
    return std::move(partition_);
  }

 private:
  struct Summit {  // of the classes a diagram leads to: the highest, its height, and whether no other is as high
    std::uint32_t highest = none;
    std::uint32_t height = 0;
    bool unique = false;
  };
  struct ClassRoot {
    Mtbdd::Node image;     // over classes, itself included
    std::uint32_t height;  // longest way down
    bool accepting;
  };

  static Summit join(const Summit& a, const Summit& b) {
    if (a.highest == none || b.highest == none) return a.highest == none ? b : a;
    if (a.height != b.height) return a.height < b.height ? b : a;
    return {a.highest, a.height, a.highest == b.highest && a.unique && b.unique};
  }
  void assign(Vertex v, Mtbdd::Node image, const Summit& summit) {
    image_[v] = image;
    summit_[v] = summit;
  }

  const Transitions& automaton_;
  const TransitionGraph& graph_;
  Mtbdd images_;
  std::vector<Mtbdd::Node> image_;  // of a vertex: its diagram, or state, over classes
  std::vector<Summit> summit_;
  Mtbdd::Node placeholder_;       // "myself"
  std::vector<ClassRoot> roots_;  // by class
  std::unordered_map<std::uint64_t, std::uint32_t> by_shape_;
  Partition partition_;
};

}  // namespace

std::optional<Partition> very_weak_partition(const Transitions& automaton, const TransitionGraph& graph) {
  const Components found = components(graph);
  std::vector<std::uint32_t> state_of(found.count, none);
  for (std::uint32_t q = 0; q < graph.states(); ++q) {
    std::uint32_t& state = state_of[found.of[graph.of_state(q)]];
    if (state != none) return std::nullopt;
    state = q;
  }
  BottomUp pass(automaton, graph);
  std::vector<Vertex> loop;
  for (std::size_t i = 0; i < found.order.size();) {
    const std::uint32_t component = found.of[found.order[i]];
    loop.clear();
    for (; i < found.order.size() && found.of[found.order[i]] == component; ++i)
      if (!graph.is_state(found.order[i])) loop.push_back(found.order[i]);
    std::sort(loop.begin(), loop.end());  // children before parents
    if (state_of[component] == none) {
      pass.update(loop.front());
    } else {
      pass.state(state_of[component], loop);
    }
  }
  return std::move(pass).partition();
}

}  // namespace waymark::automata

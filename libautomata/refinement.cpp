#include "libautomata/refinement.hpp"

#include <algorithm>
#include <functional>
#include <queue>
#include <tuple>

namespace waymark::automata {
namespace {

using Vertex = TransitionGraph::Vertex;

class Refinement {
 public:
  Refinement(const Transitions& automaton, const TransitionGraph& graph)
      : diagram_(automaton.diagram),
        graph_(graph),
        reversed_(graph),
        image_(graph.size()),
        waiting_(graph.size()) {
    const auto n = static_cast<std::uint32_t>(graph.states());
    partition_.class_of.resize(n);
    for (std::uint32_t q = 0; q < n; ++q) elements_.push_back(q);
    std::stable_partition(elements_.begin(), elements_.end(),
                          [&](std::uint32_t q) { return automaton.accepting[q]; });
    place_.resize(n);
    for (std::uint32_t i = 0; i < n; ++i) place_[elements_[i]] = i;
    const auto accepting =
        static_cast<std::uint32_t>(std::count(automaton.accepting.begin(), automaton.accepting.end(), true));
    if (accepting > 0) blocks_.push_back({0, accepting});
    if (accepting < n) blocks_.push_back({accepting, n});
    for (std::uint32_t c = 0; c < blocks_.size(); ++c)
      for (std::uint32_t i = blocks_[c].begin; i < blocks_[c].end; ++i) rename(elements_[i], c);
    for (Vertex v = 0; v < graph.nodes(); ++v) image_[v] = image_of(v);
    dirty_ = elements_;
  }

  // Splits classes by the new signatures; false when nothing changed.
  bool round() {
    std::sort(dirty_.begin(), dirty_.end(),
              [&](std::uint32_t a, std::uint32_t b) { return key(a) < key(b); });
    dirty_.erase(std::unique(dirty_.begin(), dirty_.end()), dirty_.end());
    renamed_.clear();
    for (std::size_t i = 0; i < dirty_.size();) {
      std::size_t end = i;
      while (end < dirty_.size() && partition_.class_of[dirty_[end]] == partition_.class_of[dirty_[i]]) ++end;
      split(i, end);
      i = end;
    }
    dirty_.clear();
    return !renamed_.empty();
  }

  // Redoes the images above the renamed states; afterwards dirty_ holds the states whose signature changed.
  void propagate(Effort& effort) {
    std::priority_queue<Vertex, std::vector<Vertex>, std::greater<>> queue;  // children first
    const auto changed = [&](Vertex v) {
      for (Vertex u : reversed_.predecessors(v)) {
        if (graph_.is_state(u)) {
          dirty_.push_back(graph_.state(u));
        } else if (!waiting_[u]) {
          waiting_[u] = true;
          queue.push(u);
        }
      }
    };
    for (std::uint32_t q : renamed_) changed(graph_.of_state(q));
    while (!queue.empty()) {
      effort.step();
      const Vertex v = queue.top();
      queue.pop();
      waiting_[v] = false;
      const Mtbdd::Node image = image_of(v);
      if (image == image_[v]) continue;
      image_[v] = image;
      changed(v);
    }
  }

  Partition partition() && {
    partition_.classes = static_cast<std::uint32_t>(blocks_.size());
    return std::move(partition_);
  }

 private:
  struct Block {
    std::uint32_t begin, end;  // of elements_
  };

  std::tuple<std::uint32_t, Mtbdd::Node, std::uint32_t> key(std::uint32_t q) const {
    return {partition_.class_of[q], image_[graph_.root(q)], q};
  }
  Mtbdd::Node image_of(Vertex v) {
    const auto children = graph_.successors(v);
    return images_.make(diagram_.variable(graph_.node(v)), image_[children[0]], image_[children[1]]);
  }
  void rename(std::uint32_t q, std::uint32_t c) {
    partition_.class_of[q] = c;
    image_[graph_.of_state(q)] = Mtbdd::terminal(c);
  }

  // dirty_[begin, end) lie in one class, sorted by signature. The class becomes one block per signature, and one for
  // the states that are not dirty (they all kept the old signature, which no dirty state has).
  void split(std::size_t begin, std::size_t end) {
    const std::uint32_t name = partition_.class_of[dirty_[begin]];
    const Block whole = blocks_[name];
    std::vector<Block> parts;
    std::uint32_t at = whole.begin;
    for (std::size_t i = begin; i < end;) {
      const Mtbdd::Node signature = image_[graph_.root(dirty_[i])];
      Block part{at, at};
      for (; i < end && image_[graph_.root(dirty_[i])] == signature; ++i)
        exchange(place_[dirty_[i]], part.end++);
      at = part.end;
      parts.push_back(part);
    }
    if (at < whole.end) parts.push_back({at, whole.end});
    const auto largest = std::max_element(parts.begin(), parts.end(), [](const Block& a, const Block& b) {
      return a.end - a.begin < b.end - b.begin;
    });
    blocks_[name] = *largest;
    for (auto part = parts.begin(); part != parts.end(); ++part) {
      if (part == largest) continue;
      const auto fresh = static_cast<std::uint32_t>(blocks_.size());
      blocks_.push_back(*part);
      for (std::uint32_t i = part->begin; i < part->end; ++i) {
        rename(elements_[i], fresh);
        renamed_.push_back(elements_[i]);
      }
    }
  }
  void exchange(std::uint32_t i, std::uint32_t j) {
    std::swap(elements_[i], elements_[j]);
    place_[elements_[i]] = i;
    place_[elements_[j]] = j;
  }

  const Mtbdd& diagram_;
  const TransitionGraph& graph_;
  ReversedGraph reversed_;
  Mtbdd images_;
  std::vector<Mtbdd::Node> image_;  // of a vertex: its diagram, or state, over the current classes
  std::vector<bool> waiting_;       // node vertices in the queue of propagate()
  std::vector<std::uint32_t> elements_, place_, dirty_, renamed_;
  std::vector<Block> blocks_;  // by class
  Partition partition_;
};

}  // namespace

Partition coarsest_partition(const Transitions& automaton, const TransitionGraph& graph, Effort& effort) {
  Refinement refinement(automaton, graph);
  while (refinement.round()) {
    effort.poll();
    refinement.propagate(effort);
  }
  return std::move(refinement).partition();
}

}  // namespace waymark::automata

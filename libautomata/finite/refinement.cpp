#include "libautomata/finite/refinement.hpp"

#include <algorithm>
#include <bit>
#include <optional>
#include <span>
#include <utility>

namespace waymark::automata {
namespace {

// A set of vertices that is emptied in ascending order; what is added meanwhile is larger than what was taken.
class Agenda {
 public:
  explicit Agenda(std::size_t size) : words_(size / 64 + 1, 0) {}
  void add(Vertex v) { words_[v / 64] |= std::uint64_t{1} << v % 64; }
  template <class Visit>
  void drain(const Visit& visit) {
    for (std::size_t i = 0; i < words_.size(); ++i) {
      while (words_[i] != 0) {
        const auto bit = static_cast<Vertex>(std::countr_zero(words_[i]));
        words_[i] &= words_[i] - 1;
        visit(static_cast<Vertex>(64 * i) + bit);
      }
    }
  }

 private:
  std::vector<std::uint64_t> words_;
};

class Refinement {
 public:
  Refinement(const Transitions& automaton, const TransitionGraph& graph)
      : diagram_(automaton.diagram), graph_(graph), image_(graph.size()), agenda_(graph.nodes()) {
    const auto n = static_cast<std::uint32_t>(graph.states());
    partition_.class_of.resize(n);
    for (std::uint32_t q = 0; q < n; ++q) elements_.push_back(q);
    std::stable_partition(elements_.begin(), elements_.end(), [&](std::uint32_t q) { return automaton.accepting[q]; });
    place_.resize(n);
    for (std::uint32_t i = 0; i < n; ++i) place_[elements_[i]] = i;
    const auto accepting =
        static_cast<std::uint32_t>(std::count(automaton.accepting.begin(), automaton.accepting.end(), true));
    if (accepting > 0) blocks_.push_back({0, accepting});
    if (accepting < n) blocks_.push_back({accepting, n});
    for (std::uint32_t c = 0; c < blocks_.size(); ++c)
      for (std::uint32_t i = blocks_[c].begin; i < blocks_[c].end; ++i) rename(elements_[i], c);
    for (Vertex v = 0; v < graph.nodes(); ++v) image_[v] = image_of(v);
    for (std::uint32_t q = 0; q < n; ++q) dirty_.push_back(dirty(q));
  }

  // Splits classes by the new signatures; false when nothing changed.
  bool round() {
    std::sort(dirty_.begin(), dirty_.end());
    dirty_.erase(std::unique(dirty_.begin(), dirty_.end()), dirty_.end());
    renamed_.clear();
    for (std::size_t i = 0; i < dirty_.size();) {
      std::size_t end = i;
      while (end < dirty_.size() && dirty_[end].of == dirty_[i].of) ++end;
      split(i, end);
      i = end;
    }
    dirty_.clear();
    return !renamed_.empty();
  }

  // Redoes the images above the renamed states; afterwards dirty_ holds the states whose signature changed.
  void propagate(Budget& budget) {
    if (images_.live() > 2 * kept_ + graph_.nodes() / 4 + 256) collect();
    changed_.clear();
    if (renamed_.size() > partition_.class_of.size() / 8)
      pass(budget);
    else
      climb(budget);
    for (std::uint32_t q : changed_) dirty_.push_back(dirty(q));
  }

  Partition partition() && {
    partition_.classes = static_cast<std::uint32_t>(blocks_.size());
    for (const Block& block : blocks_) partition_.roots.push_back(signature(elements_[block.begin]));
    partition_.diagram = std::move(images_);
    return std::move(partition_);
  }

 private:
  struct Block {
    std::uint32_t begin, end;  // of elements_
  };

  struct Dirty {  // a state with its class and new signature
    std::uint32_t of;
    Mtbdd::Node signature;
    std::uint32_t state;
    friend auto operator<=>(const Dirty&, const Dirty&) = default;
  };

  Mtbdd::Node signature(std::uint32_t q) const { return image_[graph_.root(q)]; }
  Dirty dirty(std::uint32_t q) const { return {partition_.class_of[q], signature(q), q}; }

  bool redo(Vertex v) {  // did the image change?
    const Mtbdd::Node before = std::exchange(image_[v], image_of(v));
    return image_[v] != before;
  }

  // All nodes, children first.
  void pass(Budget& budget) {
    budget.step(graph_.nodes());
    std::vector<bool> redone(graph_.size(), false);
    for (const std::uint32_t q : renamed_) redone[graph_.of_state(q)] = true;
    for (Vertex v = 0; v < graph_.nodes(); ++v) {
      const auto children = graph_.successors(v);
      if (redone[children[0]] || redone[children[1]]) redone[v] = redo(v);
    }
    for (std::uint32_t q = 0; q < graph_.states(); ++q)
      if (redone[graph_.root(q)]) changed_.push_back(q);
  }

  // Only nodes above the renamed states, children first.
  void climb(Budget& budget) {
    if (!reversed_) reversed_.emplace(graph_);
    const auto tell = [&](Vertex v) {
      for (Vertex u : reversed_->predecessors(v)) {
        if (graph_.is_state(u))
          changed_.push_back(graph_.state(u));
        else
          agenda_.add(u);
      }
    };
    for (const std::uint32_t q : renamed_) tell(graph_.of_state(q));
    agenda_.drain([&](Vertex v) {
      budget.step();
      if (redo(v)) tell(v);
    });
  }

  // Drops the diagrams over former classes.
  void collect() {
    images_.collect(std::span(image_).first(graph_.nodes()));
    kept_ = images_.live();
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
    const std::uint32_t name = dirty_[begin].of;
    const Block whole = blocks_[name];
    std::vector<Block> parts;
    std::uint32_t at = whole.begin;
    for (std::size_t i = begin; i < end;) {
      const Mtbdd::Node same = dirty_[i].signature;
      Block part{at, at};
      for (; i < end && dirty_[i].signature == same; ++i) exchange(place_[dirty_[i].state], part.end++);
      at = part.end;
      parts.push_back(part);
    }
    if (at < whole.end) parts.push_back({at, whole.end});
    const auto largest = std::max_element(
        parts.begin(), parts.end(), [](const Block& a, const Block& b) { return a.end - a.begin < b.end - b.begin; });
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
  std::optional<ReversedGraph> reversed_;  // made when first needed
  Mtbdd images_;
  std::vector<Mtbdd::Node> image_;  // of a vertex: its diagram, or state, over the current classes
  std::size_t kept_ = 0;            // images when some were last dropped
  Agenda agenda_;                   // node vertices to redo
  std::vector<std::uint32_t> elements_, place_, renamed_, changed_;
  std::vector<Dirty> dirty_;
  std::vector<Block> blocks_;  // by class
  Partition partition_;
};

}  // namespace

Partition coarsest_partition(const Transitions& automaton, const TransitionGraph& graph, Budget& budget) {
  Refinement refinement(automaton, graph);
  while (refinement.round()) {
    budget.poll();
    refinement.propagate(budget);
  }
  return std::move(refinement).partition();
}

}  // namespace waymark::automata

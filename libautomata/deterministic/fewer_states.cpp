#include "libautomata/deterministic/fewer_states.hpp"

#include <algorithm>
#include <map>
#include <numeric>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "libautomata/bdd/joint_choices.hpp"
#include "libautomata/deterministic/colours.hpp"
#include "libautomata/deterministic/one_language.hpp"
#include "libautomata/graph/scc.hpp"

namespace waymark::automata {
namespace {

using Node = Mtbdd::Node;
constexpr std::uint32_t unset = UINT32_MAX;

// The states of one language, and what letters tell them apart.
struct Class {
  std::vector<std::uint32_t> states;
  std::uint32_t first_pair = 0;
  Node letters;                                     // terminals: tuples
  std::map<std::uint32_t, std::uint32_t> of_tuple;  // position in `branches`
  std::vector<std::vector<Branch>> branches;        // by tuple, then by state
};

// Colours of the branches of the states that stay, by (state, tuple of its class).
using Colours = std::vector<std::vector<std::uint32_t>>;

class Merging {
 public:
  Merging(const TransitionRelation& complete, const std::vector<std::uint32_t>& language, Budget& budget)
      : from_(complete), budget_(budget), joint_(diagram_, budget), image_(from_.states()) {
    std::map<std::uint32_t, std::uint32_t> number;
    for (std::uint32_t q = 0; q < from_.states(); ++q) {
      const auto [at, fresh] = number.try_emplace(language[q], static_cast<std::uint32_t>(classes_.size()));
      if (fresh) classes_.emplace_back();
      class_of_.push_back(at->second);
      position_.push_back(static_cast<std::uint32_t>(classes_[at->second].states.size()));
      classes_[at->second].states.push_back(q);
    }
    std::iota(image_.begin(), image_.end(), 0U);
    if (classes_.size() == from_.states()) return;
    const std::vector<Node> roots = diagram_.import(
        from_.diagram, from_.roots, [](std::uint32_t c) { return Mtbdd::terminal(c); },
        [](Mtbdd::Variable v) { return v; });
    for (Class& one : classes_) {
      one.first_pair = pairs_;
      pairs_ += static_cast<std::uint32_t>(one.states.size() * one.states.size());
      tell_apart(one, roots);
    }
  }

  void run() {
    for (const Class& one : classes_)
      for (std::uint32_t q : one.states)
        for (std::uint32_t r : one.states)
          if (q != r && image_[q] == q && image_[r] == r && redirected(q, r)) merged_ = true;
  }
  // The structure, coloured; nullopt when nothing was merged. States that went, and those that nothing reaches, have
  // no branches.
  std::optional<TransitionRelation> result() const {
    if (!merged_) return std::nullopt;
    std::uint32_t sets = 1;
    for (const auto& of_state : colours_)
      for (std::uint32_t colour : of_state)
        if (colour != unset) sets = std::max(sets, colour + 1);
    TransitionRelation out;
    out.acceptance = Acceptance::parity(Acceptance::Extreme::Min, Acceptance::Parity::Even, sets);
    out.initial = image_[from_.initial];
    for (std::uint32_t s = 0; s < from_.states(); ++s)
      out.roots.push_back(colours_[s].empty() ? Mtbdd::terminal(Choices::none) : coloured(s, sets, out));
    return out;
  }

 private:
  struct Edge {  // of the product
    std::uint32_t source, target;
    std::uint32_t colour;        // in the automaton of before
    std::uint32_t state, tuple;  // the branch of the structure
  };

  class Graph {  // of the edges with at least a colour
   public:
    Graph(const std::vector<Edge>& edges, std::uint32_t least) {
      std::uint32_t size = 0;
      for (const Edge& e : edges) size = std::max({size, e.source + 1, e.target + 1});
      begin_.reserve(size + 1);
      for (const Edge& e : edges) {
        if (e.colour < least) continue;
        while (begin_.size() <= e.source) begin_.push_back(targets_.size());
        targets_.push_back(e.target);
      }
      begin_.resize(size + 1, targets_.size());
    }
    std::size_t size() const { return begin_.size() - 1; }
    std::span<const std::uint32_t> successors(std::uint32_t v) const {
      return {targets_.data() + begin_[v], begin_[v + 1] - begin_[v]};
    }

   private:
    std::vector<std::size_t> begin_;
    std::vector<std::uint32_t> targets_;
  };

  void tell_apart(Class& one, const std::vector<Node>& roots) {
    one.letters = JointChoices::empty();
    for (std::uint32_t q : one.states) one.letters = joint_.extended(one.letters, roots[q]);
    const auto number = [&](std::uint32_t tuple) {
      const auto [at, fresh] = one.of_tuple.try_emplace(tuple, static_cast<std::uint32_t>(one.branches.size()));
      if (fresh) {
        std::vector<std::uint32_t> choices(one.states.size());
        joint_.read(tuple, choices);
        std::vector<Branch> branches;
        for (std::uint32_t c : choices) branches.push_back(from_.choices[c].front());
        one.branches.push_back(std::move(branches));
      }
      return tuple;
    };
    joint_.settled(one.letters, number);
  }

  bool redirected(std::uint32_t q, std::uint32_t r) {
    std::vector<std::uint32_t> image = image_;
    std::replace(image.begin(), image.end(), q, r);
    std::optional<Colours> found = colours(image);
    if (!found) return false;
    image_ = std::move(image);
    colours_ = *std::move(found);
    return true;
  }

  // Pairs (state of the structure, state of before) that some word leads to, as sources and targets of edges.
  std::vector<Edge> product(const std::vector<std::uint32_t>& image) {
    std::vector<std::uint32_t> number(pairs_, unset);
    std::vector<std::pair<std::uint32_t, std::uint32_t>> found;
    const auto of = [&](std::uint32_t s, std::uint32_t d) {
      const Class& one = classes_[class_of_[s]];
      std::uint32_t& known =
          number[one.first_pair + position_[s] * static_cast<std::uint32_t>(one.states.size()) + position_[d]];
      if (known == unset) {
        known = static_cast<std::uint32_t>(found.size());
        found.emplace_back(s, d);
      }
      return known;
    };
    std::vector<Edge> out;
    of(image[from_.initial], from_.initial);
    for (std::uint32_t i = 0; i < found.size(); ++i) {  // the pairs double as the queue
      const auto [s, d] = found[i];
      const Class& one = classes_[class_of_[s]];
      budget_.step(one.branches.size());
      for (std::uint32_t t = 0; t < one.branches.size(); ++t) {
        const Branch& mine = one.branches[t][position_[s]];
        const Branch& theirs = one.branches[t][position_[d]];
        const std::uint32_t target = of(image[mine.target], theirs.target);
        out.push_back({i, target, colour_of(from_, theirs.marks), s, t});
      }
    }
    return out;
  }

  // By edge, sources ascending: whether it lies on a cycle whose least colour has this parity.
  std::vector<bool> on_cycles(const std::vector<Edge>& edges, std::uint32_t parity) {
    std::vector<bool> out(edges.size(), false);
    for (std::uint32_t least = parity; least <= from_.acceptance.sets; least += 2) {
      budget_.step(edges.size());
      if (std::none_of(edges.begin(), edges.end(), [&](const Edge& e) { return e.colour == least; })) continue;
      const Components found = components(Graph(edges, least));
      const auto inside = [&](const Edge& e) { return e.colour >= least && found.of[e.source] == found.of[e.target]; };
      std::vector<bool> has_least(found.count, false);
      for (const Edge& e : edges)
        if (e.colour == least && inside(e)) has_least[found.of[e.source]] = true;
      for (std::size_t i = 0; i < edges.size(); ++i)
        if (inside(edges[i]) && has_least[found.of[edges[i].source]]) out[i] = true;
    }
    return out;
  }

  std::optional<Colours> colours(const std::vector<std::uint32_t>& image) {
    std::vector<Edge> edges = product(image);
    Colours out(from_.states());
    for (const Edge& e : edges) out[e.state].resize(classes_[class_of_[e.state]].branches.size(), unset);
    std::uint32_t idle = 0;
    for (std::uint32_t colour = 0; !edges.empty(); ++colour) {
      if (colour + 3 > Marks::most || idle == 2) return std::nullopt;
      const std::vector<bool> other = on_cycles(edges, 1 - colour % 2);
      Colours blocked(from_.states());
      for (std::size_t i = 0; i < edges.size(); ++i) {
        std::vector<std::uint32_t>& of_state = blocked[edges[i].state];
        of_state.resize(out[edges[i].state].size(), 0);
        if (other[i]) of_state[edges[i].tuple] = 1;
      }
      const std::size_t before = edges.size();
      edges.erase(std::remove_if(edges.begin(), edges.end(),
                                 [&](const Edge& e) {
                                   if (blocked[e.state][e.tuple] == 1) return false;
                                   out[e.state][e.tuple] = colour;
                                   return true;
                                 }),
                  edges.end());
      idle = edges.size() == before ? idle + 1 : 0;
    }
    return out;
  }

  Node coloured(std::uint32_t s, std::uint32_t sets, TransitionRelation& out) const {
    const Class& one = classes_[class_of_[s]];
    const auto leaf = [&](std::uint32_t tuple) {
      const std::uint32_t t = one.of_tuple.at(tuple);
      const std::uint32_t target = image_[one.branches[t][position_[s]].target];
      return Mtbdd::terminal(out.choices.intern({{target, mark_of(colours_[s][t], sets)}}));
    };
    const Node letters[] = {one.letters};
    return out.diagram.import(diagram_, letters, leaf, [](Mtbdd::Variable v) { return v; })[0];
  }

  const TransitionRelation& from_;
  Budget& budget_;
  Mtbdd diagram_;
  JointChoices joint_;
  std::vector<Class> classes_;
  std::uint32_t pairs_ = 0;                         // of states of one language
  std::vector<std::uint32_t> class_of_, position_;  // by state
  std::vector<std::uint32_t> image_;                // by state: where branches to it lead
  Colours colours_;
  bool merged_ = false;
};

}  // namespace

Reduced with_fewer_states(const TransitionRelation& complete, const std::vector<std::uint32_t>& language,
                          Budget& budget) {
  std::optional<Merging> merging;
  bool all_tried = true;
  try {
    merging.emplace(complete, language, budget);
    merging->run();
  } catch (const Budget::Exceeded& spent) {
    if (spent.reason == Budget::Exceeded::Reason::Stopped) throw;
    all_tried = false;
  }
  std::optional<TransitionRelation> made = merging ? merging->result() : std::nullopt;
  return {made ? *std::move(made) : complete, all_tried};
}

Reduced with_fewer_states(const TransitionRelation& automaton, Budget& budget) {
  const TransitionRelation complete = completed_parity(automaton);
  try {
    return with_fewer_states(complete, languages(complete, budget), budget);
  } catch (const Budget::Exceeded& spent) {
    if (spent.reason == Budget::Exceeded::Reason::Stopped) throw;
    return {automaton, false};
  }
}

}  // namespace waymark::automata

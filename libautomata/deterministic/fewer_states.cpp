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
constexpr std::size_t first_part = 8;  // pairs of a product

struct Step {  // of the automaton of before
  std::uint32_t target, colour;
};

// The states of one language, and what letters tell them apart.
struct Class {
  std::vector<std::uint32_t> states;
  std::uint32_t first_pair = 0;
  std::uint32_t tuples = 0;
  Node letters;                                     // terminals: tuples
  std::map<std::uint32_t, std::uint32_t> of_tuple;  // its number
  std::vector<Step> steps;                          // by tuple, then by state

  const Step* of(std::uint32_t tuple) const { return &steps[tuple * states.size()]; }
};

using Colours = std::vector<std::uint32_t>;  // by branch, a state and a tuple of its class; unset: of states that went

class Merging {
 public:
  Merging(const TransitionRelation& complete, const std::vector<std::uint32_t>& language, Budget& budget)
      : from_(complete), budget_(budget), joint_(diagram_, budget), image_(from_.states()), met_with_(from_.states()) {
    std::map<std::uint32_t, std::uint32_t> number;
    for (std::uint32_t q = 0; q < from_.states(); ++q) {
      const auto [at, fresh] = number.try_emplace(language[q], static_cast<std::uint32_t>(classes_.size()));
      if (fresh) classes_.emplace_back();
      class_of_.push_back(at->second);
      position_.push_back(static_cast<std::uint32_t>(classes_[at->second].states.size()));
      classes_[at->second].states.push_back(q);
    }
    std::iota(image_.begin(), image_.end(), 0U);
    std::iota(met_with_.begin(), met_with_.end(), 0U);
    if (classes_.size() == from_.states()) return;
    const std::vector<Node> roots = diagram_.import(
        from_.diagram, from_.roots, [](std::uint32_t c) { return Mtbdd::terminal(c); },
        [](Mtbdd::Variable v) { return v; });
    for (Class& one : classes_) {
      one.first_pair = pairs_;
      pairs_ += static_cast<std::uint32_t>(one.states.size() * one.states.size());
      tell_apart(one, roots);
    }
    for (const std::uint32_t c : class_of_) {
      first_branch_.push_back(branches_);
      branches_ += classes_[c].tuples;
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
    for (const std::uint32_t colour : colours_)
      if (colour != unset) sets = std::max(sets, colour + 1);
    TransitionRelation out;
    out.acceptance = Acceptance::parity(Acceptance::Extreme::Min, Acceptance::Parity::Even, sets);
    out.initial = image_[from_.initial];
    for (std::uint32_t s = 0; s < from_.states(); ++s)
      out.roots.push_back(colours_[first_branch_[s]] == unset ? Mtbdd::terminal(Choices::none)
                                                              : coloured(s, sets, out));
    return out;
  }

 private:
  struct Edge {  // of the product
    std::uint32_t source, target;
    std::uint32_t colour;  // in the automaton of before
    std::uint32_t branch;  // of the structure
  };

  using Pair = std::pair<std::uint32_t, std::uint32_t>;  // state of the structure, state of before
  struct Product {                                       // or a part of it
    std::vector<Pair> pairs;
    std::vector<Edge> edges;  // sources ascending
    bool is_closed = true;    // no edge leads out of it
  };

  class Graph {  // of the edges with at least a colour
   public:
    Graph(const std::vector<Edge>& edges, std::uint32_t least) {
      std::uint32_t size = 0;
      for (const Edge& e : edges) size = std::max({size, e.source + 1, e.target + 1});
      begin_.reserve(size + 1);
      std::vector<std::uint32_t> last(size, unset);  // by target: the source that an edge was added for; once is enough
      for (const Edge& e : edges) {
        if (e.colour < least || last[e.target] == e.source) continue;
        last[e.target] = e.source;
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
      const auto [at, fresh] = one.of_tuple.try_emplace(tuple, one.tuples);
      if (fresh) {
        ++one.tuples;
        std::vector<std::uint32_t> choices(one.states.size());
        joint_.read(tuple, choices);
        for (const std::uint32_t c : choices) {
          const Branch& branch = from_.choices[c].front();
          one.steps.push_back({branch.target, colour_of(from_, branch.marks)});
        }
      }
      return tuple;
    };
    joint_.settled(one.letters, number);
  }

  // Where no colours exist this mostly shows near a pair (r, d): small parts of the product are looked at first.
  bool redirected(std::uint32_t q, std::uint32_t r) {
    std::vector<std::uint32_t> image = image_;
    std::replace(image.begin(), image.end(), q, r);
    if (met_with_[q] != unset) {
      const Pair redirected{r, met_with_[q]};
      for (std::size_t most = first_part;; most *= 4) {
        const Product part = product(image, redirected, most);
        if (!colours(part)) return false;
        if (part.is_closed) break;
      }
    }
    const Product whole = product(image, {image[from_.initial], from_.initial}, SIZE_MAX);
    std::optional<Colours> found = colours(whole);
    if (!found) return false;
    image_ = std::move(image);
    colours_ = *std::move(found);
    meet(whole);
    return true;
  }

  // The first pair of each state is met without passing another pair of that state.
  void meet(const Product& whole) {
    met_with_.assign(from_.states(), unset);
    for (const auto& [s, d] : whole.pairs)
      if (met_with_[s] == unset) met_with_[s] = d;
  }

  // The pairs that some word leads to from this one, breadth first, and the edges between them.
  Product product(const std::vector<std::uint32_t>& image, const Pair& first, std::size_t most) {
    std::vector<std::uint32_t> number(pairs_, unset);
    Product out;
    const auto of = [&](std::uint32_t s, std::uint32_t d) {
      const Class& one = classes_[class_of_[s]];
      std::uint32_t& known =
          number[one.first_pair + position_[s] * static_cast<std::uint32_t>(one.states.size()) + position_[d]];
      if (known == unset && out.pairs.size() < most) {
        known = static_cast<std::uint32_t>(out.pairs.size());
        out.pairs.emplace_back(s, d);
      }
      return known;
    };
    of(first.first, first.second);
    for (std::uint32_t i = 0; i < out.pairs.size(); ++i) {  // the pairs double as the queue
      const auto [s, d] = out.pairs[i];
      const Class& one = classes_[class_of_[s]];
      budget_.step(one.tuples);
      for (std::uint32_t t = 0; t < one.tuples; ++t) {
        const Step& mine = one.of(t)[position_[s]];
        const Step& theirs = one.of(t)[position_[d]];
        const std::uint32_t target = of(image[mine.target], theirs.target);
        if (target == unset)
          out.is_closed = false;
        else
          out.edges.push_back({i, target, theirs.colour, first_branch_[s] + t});
      }
    }
    return out;
  }

  // Marks the branches of the edges, sources ascending, that lie on a cycle whose least colour has this parity.
  std::vector<bool> on_cycles(const std::vector<Edge>& edges, std::uint32_t parity) {
    std::vector<bool> out(branches_, false);
    for (std::uint32_t least = parity; least <= from_.acceptance.sets; least += 2) {
      budget_.step(edges.size());
      if (std::none_of(edges.begin(), edges.end(), [&](const Edge& e) { return e.colour == least; })) continue;
      const Components found = components(Graph(edges, least));
      const auto inside = [&](const Edge& e) { return e.colour >= least && found.of[e.source] == found.of[e.target]; };
      std::vector<bool> has_least(found.count, false);
      for (const Edge& e : edges)
        if (e.colour == least && inside(e)) has_least[found.of[e.source]] = true;
      for (const Edge& e : edges)
        if (inside(e) && has_least[found.of[e.source]]) out[e.branch] = true;
    }
    return out;
  }

  std::optional<Colours> colours(const Product& product) {
    std::vector<Edge> edges = product.edges;
    Colours out(branches_, unset);
    std::uint32_t idle = 0;
    for (std::uint32_t colour = 0; !edges.empty(); ++colour) {
      if (colour + 3 > Marks::most || idle == 2) return std::nullopt;
      const std::vector<bool> blocked = on_cycles(edges, 1 - colour % 2);
      const std::size_t before = edges.size();
      edges.erase(std::remove_if(edges.begin(), edges.end(),
                                 [&](const Edge& e) {
                                   if (!blocked[e.branch]) out[e.branch] = colour;
                                   return !blocked[e.branch];
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
      const std::uint32_t target = image_[one.of(t)[position_[s]].target];
      return Mtbdd::terminal(out.choices.intern({{target, mark_of(colours_[first_branch_[s] + t], sets)}}));
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
  std::vector<std::uint32_t> first_branch_;         // by state
  std::uint32_t branches_ = 0;                      // of all states
  std::vector<std::uint32_t> met_with_;             // by state: the state of before in its first pair
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

#include "libautomata/deterministic/fewer_states.hpp"

#include <algorithm>
#include <map>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

#include "libautomata/bdd/joint_choices.hpp"
#include "libautomata/deterministic/branch_colouring.hpp"
#include "libautomata/deterministic/colours.hpp"
#include "libautomata/deterministic/one_language.hpp"

namespace waymark::automata {
namespace {

using Node = Mtbdd::Node;
using Colours = BranchColouring::Colours;
constexpr std::uint32_t unset = UINT32_MAX;
constexpr std::size_t least_part = 8, part_growth = 4;  // pairs of a product
constexpr std::size_t chosen_after = 32;                // merges that all letters refuted: few letters are chosen
constexpr std::size_t chosen_again = 8;                 // after so many times as many

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
  std::vector<std::uint32_t> few;                   // tuples that refuted a merge by themselves

  const Step* of(std::uint32_t tuple) const { return &steps[tuple * states.size()]; }
};

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
    number_.assign(pairs_, unset);
    for (const std::uint32_t c : class_of_) {
      first_branch_.push_back(branches_);
      branches_ += classes_[c].tuples;
    }
    core_.assign(branches_, 0);
    colouring_.emplace(branches_, from_.acceptance.sets);
  }

  // Every pair is tried after the last merging, too: a merging can make another possible, which was not.
  void run() {
    std::vector<Pair> tries;
    for (const Class& one : classes_)
      for (std::uint32_t q : one.states)
        for (std::uint32_t r : one.states)
          if (q != r) tries.emplace_back(q, r);
    for (std::size_t i = 0, idle = 0; idle < tries.size(); i = (i + 1) % tries.size(), ++idle) {
      const auto [q, r] = tries[i];
      if (image_[q] != q || image_[r] != r || !redirected(q, r)) continue;
      merged_ = true;
      idle = 0;
    }
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
  using Pair = std::pair<std::uint32_t, std::uint32_t>;  // state of the structure, state of before
  enum class Letters : std::uint8_t { All, Few, FewOfCore };
  struct Refutations {
    std::size_t asked = 0, refuted = 0, steps = 0;
    void add(std::size_t more, bool yes) {
      ++asked;
      refuted += yes ? 1 : 0;
      steps += more;
    }
  };
  struct Product {  // or a part of it
    std::vector<Pair> pairs;
    std::vector<ProductEdge> edges;  // sources ascending
    std::size_t explored = 0;        // pairs whose edges it has
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

  bool redirected(std::uint32_t q, std::uint32_t r) {
    std::vector<std::uint32_t> image = image_;
    std::replace(image.begin(), image.end(), q, r);
    if (met_with_[q] != unset && !near({r, met_with_[q]}, image)) return false;
    Product& whole = begin({image[from_.initial], from_.initial});
    explore(whole, image, SIZE_MAX);
    std::optional<Colours> found = colouring_->colours(whole.edges, budget_);  // … which the product loses
    if (!found) return false;
    image_ = std::move(image);
    colours_ = *std::move(found);
    meet(whole);
    return true;
  }

  // Are there colours near this pair? Where none exist this mostly shows there: parts of the product that grow are
  // looked at, the first of the size that told the last time, or of one less.
  bool near(const Pair& pair, const std::vector<std::uint32_t>& image) {
    if (has_few_ && refuted_by_few(pair, image)) return false;
    const std::size_t steps = budget_.steps_left();
    if (parts_have_colours(pair, image)) return true;
    by_all_.add(steps - budget_.steps_left(), true);
    if (by_all_.refuted == next_choice_) choose_few(pair, image);
    return false;
  }
  bool parts_have_colours(const Pair& pair, const std::vector<std::uint32_t>& image) {
    Product& part = begin(pair);
    const std::size_t first = first_part_;
    for (std::size_t most = first; part.explored < part.pairs.size(); most *= part_growth) {
      explore(part, image, most);
      std::vector<ProductEdge> inside = part.edges;
      std::erase_if(inside, [&](const ProductEdge& e) { return e.target >= part.explored; });
      if (colouring_->colours(inside, budget_)) continue;
      first_part_ = most == first ? std::max(least_part, most / part_growth) : most;
      return false;
    }
    return true;
  }

  // Are there no colours near this pair even for the words of few letters? They are asked as long as that saves steps.
  // Where they do not know, their steps do not count.
  bool refuted_by_few(const Pair& pair, const std::vector<std::uint32_t>& image) {
    Budget spare = budget_.of_stop();
    const bool refuted = few_have_no_colours(pair, image, spare);
    const std::size_t steps = SIZE_MAX - spare.steps_left();
    by_few_.add(steps, refuted);
    has_few_ = by_few_.asked < chosen_after || by_few_.steps * by_all_.refuted <= by_all_.steps * by_few_.refuted;
    if (refuted) budget_.step(steps);
    return refuted;
  }
  // The branches that had no colour the last time are looked at first, alone.
  bool few_have_no_colours(const Pair& pair, const std::vector<std::uint32_t>& image, Budget& budget) {
    budget.poll();
    for (const Letters letters : {Letters::FewOfCore, Letters::Few}) {
      Product& part = begin(pair);
      explore(part, image, SIZE_MAX, letters, budget);
      if (colouring_->colours(part.edges, budget)) continue;
      core_.assign(branches_, 0);
      for (const ProductEdge& e : part.edges) core_[e.branch] = 1;
      return true;
    }
    return false;
  }

  // Takes letters away, from half of those of a language to one, as long as the others refute this merge.
  void choose_few(const Pair& pair, const std::vector<std::uint32_t>& image) {
    std::size_t products = by_all_.refuted / 4;  // at most
    for (Class& one : classes_) {
      one.few.resize(one.tuples);
      std::iota(one.few.begin(), one.few.end(), 0U);
    }
    Budget spare = budget_.of_stop();
    Product& whole = begin(pair);
    explore(whole, image, SIZE_MAX, Letters::All, spare);
    std::vector<bool> met(classes_.size());
    for (const Pair& p : whole.pairs) met[class_of_[p.first]] = true;
    for (std::size_t c = 0; c < classes_.size(); ++c)
      if (met[c]) choose_few(classes_[c], pair, image, products);
    has_few_ = true;
    by_few_ = {};
    next_choice_ *= chosen_again;
  }
  void choose_few(Class& one, const Pair& pair, const std::vector<std::uint32_t>& image, std::size_t& products) {
    for (std::size_t count = one.few.size() / 2; count > 0; count /= 2)
      for (std::size_t at = 0; at < one.few.size() && products > 0; --products) {
        const std::vector<std::uint32_t> before = one.few;
        const auto first = one.few.begin() + static_cast<std::ptrdiff_t>(at);
        one.few.erase(first, first + static_cast<std::ptrdiff_t>(std::min(count, one.few.size() - at)));
        Budget spare = budget_.of_stop();
        if (few_have_no_colours(pair, image, spare)) continue;
        one.few = before;
        at += count;
      }
  }

  // The first pair of each state is met without passing another pair of that state.
  void meet(const Product& whole) {
    met_with_.assign(from_.states(), unset);
    for (const auto& [s, d] : whole.pairs)
      if (met_with_[s] == unset) met_with_[s] = d;
  }

  std::uint32_t pair_id(const Pair& pair) const {
    const Class& one = classes_[class_of_[pair.first]];
    return one.first_pair + position_[pair.first] * static_cast<std::uint32_t>(one.states.size()) +
           position_[pair.second];
  }

  // The product that was begun before is not explored any more.
  Product& begin(const Pair& first) {
    for (const std::uint32_t id : numbered_) number_[id] = unset;
    numbered_.clear();
    product_.pairs.clear();
    product_.edges.clear();
    product_.explored = 0;
    product_.pairs.push_back(first);
    numbered_.push_back(pair_id(first));
    number_[numbered_.back()] = 0;
    return product_;
  }

  // The edges of so many pairs, breadth first, or of all that some word leads to.
  void explore(Product& out, const std::vector<std::uint32_t>& image, std::size_t most) {
    explore(out, image, most, Letters::All, budget_);
  }
  void explore(Product& out, const std::vector<std::uint32_t>& image, std::size_t most, Letters letters,
               Budget& budget) {
    for (; out.explored < std::min(most, out.pairs.size()); ++out.explored) {
      const auto [s, d] = out.pairs[out.explored];
      const Class& one = classes_[class_of_[s]];
      const std::size_t count = letters == Letters::All ? one.tuples : one.few.size();
      const std::uint32_t branch = first_branch_[s], at = position_[s], there = position_[d];
      budget.step(count);
      for (std::uint32_t i = 0; i < count; ++i) {
        const std::uint32_t t = letters == Letters::All ? i : one.few[i];
        if (letters == Letters::FewOfCore && core_[branch + t] == 0) continue;
        const Step& mine = one.of(t)[at];
        const Step& theirs = one.of(t)[there];
        const Pair target{image[mine.target], theirs.target};
        const std::uint32_t id = pair_id(target);
        if (number_[id] == unset) {
          number_[id] = static_cast<std::uint32_t>(out.pairs.size());
          numbered_.push_back(id);
          out.pairs.push_back(target);
        }
        out.edges.push_back({static_cast<std::uint32_t>(out.explored), number_[id], theirs.colour, branch + t});
      }
    }
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
  std::optional<BranchColouring> colouring_;
  std::vector<std::uint32_t> met_with_;  // by state: the state of before in its first pair
  std::vector<std::uint32_t> number_;    // by pair_id: in the product that grows
  std::vector<std::uint32_t> numbered_;  // the pair_ids with a number
  Product product_;                      // that grows
  Colours colours_;
  std::size_t first_part_ = least_part;
  Refutations by_all_, by_few_;  // letters
  std::size_t next_choice_ = chosen_after;
  bool has_few_ = false;            // letters are chosen, and asked
  std::vector<std::uint8_t> core_;  // by branch: had no colour when they last refuted a merge
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

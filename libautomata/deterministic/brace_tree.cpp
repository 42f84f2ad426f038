#include "libautomata/deterministic/brace_tree.hpp"

#include <algorithm>
#include <utility>

namespace waymark::automata {
namespace {

std::vector<Brace> path(const std::vector<Brace>& parent, Brace b) {
  std::vector<Brace> out;
  for (; b != no_brace; b = parent[static_cast<std::size_t>(b)]) out.push_back(b);
  std::reverse(out.begin(), out.end());
  return out;
}

// Older first, inside before outside.
bool better(const std::vector<Brace>& parent, Brace x, Brace y) {
  const std::vector<Brace> a = path(parent, x), b = path(parent, y);
  const auto [i, j] = std::mismatch(a.begin(), a.end(), b.begin(), b.end());
  if (i == a.end()) return false;
  return j == b.end() || *i < *j;
}

// Braces while a letter is read: those of before, then fresh ones, each asked for by what it is for.
class Growth {
 public:
  explicit Growth(const std::vector<Brace>& parent) : parent_(parent) {}
  Brace inside(Brace outer) { return fresh(children_, outer, outer); }
  Brace entry(std::uint32_t key) { return fresh(entries_, key, no_brace); }
  const std::vector<Brace>& parent() const { return parent_; }

 private:
  template <class Key>
  Brace fresh(std::map<Key, Brace>& known, Key key, Brace outer) {
    const auto [at, is_new] = known.try_emplace(key, static_cast<Brace>(parent_.size()));
    if (is_new) parent_.push_back(outer);
    return at->second;
  }
  std::vector<Brace> parent_;
  std::map<Brace, Brace> children_;
  std::map<std::uint32_t, Brace> entries_;
};

// Braces that accept lose what is inside them, those without runs go, the others are numbered afresh.
BraceStep settled(const std::map<std::uint32_t, Brace>& places, const std::vector<Brace>& parent, std::size_t before) {
  const std::size_t count = parent.size();
  std::vector<bool> direct(count, false), held(count, false), kept(count, false);
  for (const auto& [q, b] : places) {
    if (b != no_brace) direct[static_cast<std::size_t>(b)] = true;
    for (Brace outer : path(parent, b)) held[static_cast<std::size_t>(outer)] = true;
  }
  BraceStep out{{}, BraceStep::nothing};
  for (const auto& [q, b] : places) {
    Brace stays = b;
    for (Brace outer : path(parent, b)) {  // outermost first
      const auto i = static_cast<std::size_t>(outer);
      kept[i] = true;
      if (direct[i]) continue;
      stays = outer;
      out.colour = std::min(out.colour, static_cast<std::uint32_t>(2 * outer + 2));
      break;
    }
    out.tree.runs.emplace_back(q, stays);
  }
  std::vector<Brace> number(count, no_brace);
  for (std::size_t i = 0; i < count; ++i) {
    if (!kept[i]) {  // its number may be given again, so this counts more than its acceptance did
      if (i < before) out.colour = std::min(out.colour, static_cast<std::uint32_t>(2 * i + 1));
      continue;
    }
    number[i] = static_cast<Brace>(out.tree.parent.size());
    out.tree.parent.push_back(parent[i] == no_brace ? no_brace : number[static_cast<std::size_t>(parent[i])]);
  }
  for (auto& [q, b] : out.tree.runs)
    if (b != no_brace) b = number[static_cast<std::size_t>(b)];
  return out;
}

}  // namespace

BraceRules::BraceRules(const TransitionRelation& automaton, std::vector<std::vector<bool>> above)
    : automaton_(automaton),
      live_(live_components(BranchGraph(automaton), automaton.acceptance.condition)),
      deterministic_(live_.components.count, true),
      above_(std::move(above)) {
  for (std::uint32_t q = 0; q < automaton.states(); ++q)
    for (std::uint32_t c : choices_of(automaton, q)) {
      const auto choice = automaton.choices[c];
      const auto inside = std::count_if(choice.begin(), choice.end(),
                                        [&](const Branch& b) { return component(b.target) == component(q); });
      if (inside > 1) deterministic_[component(q)] = false;
    }
}

BraceTree BraceRules::initial() const {
  if (!accepting(automaton_.initial)) return {{{automaton_.initial, no_brace}}, {}};
  return {{{automaton_.initial, 0}}, {no_brace}};
}

BraceStep BraceRules::successor(const BraceTree& tree, std::span<const std::uint32_t> choices) const {
  Growth braces(tree.parent);
  Places places;
  for (std::size_t i = 0; i < choices.size(); ++i) {
    const auto [q, b] = tree.runs[i];
    for (const Branch& branch : automaton_.choices[choices[i]]) {
      const std::uint32_t r = branch.target;
      Brace to = no_brace;
      if (accepting(r) && component(r) != component(q))
        to = braces.entry(deterministic_[component(r)] ? live_.components.count + r : component(r));
      else if (accepting(r))
        to = branch.marks.empty() ? b : braces.inside(b);
      const auto [at, fresh] = places.try_emplace(r, to);
      if (!fresh && better(braces.parent(), to, at->second)) at->second = to;
    }
  }
  prune(places, braces.parent());
  return settled(places, braces.parent(), tree.parent.size());
}

// A run that is followed into later components, and within one into better braces, changes sides finitely often.
void BraceRules::prune(Places& places, const std::vector<Brace>& parent) const {
  const auto dominates = [&](const std::pair<const std::uint32_t, Brace>& r,
                             const std::pair<const std::uint32_t, Brace>& q) {
    if (r.first == q.first || !above_[q.first][r.first]) return false;
    if (component(r.first) != component(q.first)) return component(r.first) < component(q.first);
    if (r.second != q.second) return better(parent, r.second, q.second);
    return !above_[r.first][q.first] || r.first < q.first;
  };
  Places kept;
  for (const auto& q : places)
    if (std::none_of(places.begin(), places.end(), [&](const auto& r) { return dominates(r, q); })) kept.insert(q);
  places = std::move(kept);
}

}  // namespace waymark::automata

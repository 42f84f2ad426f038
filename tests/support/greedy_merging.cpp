#include "tests/support/greedy_merging.hpp"

#include <algorithm>
#include <map>
#include <numeric>
#include <set>
#include <utility>

namespace waymark::test {
namespace {

using Pair = std::pair<std::uint32_t, std::uint32_t>;    // state of the structure, state of the automaton
using Branch = std::pair<std::uint32_t, std::uint32_t>;  // state of the structure, letter
struct Edge {
  Pair source, target;
  std::uint32_t colour;
  Branch branch;
};

std::vector<Edge> product(const LetterwiseParity& of, const std::vector<std::uint32_t>& image) {
  std::vector<Edge> out;
  std::vector<Pair> found{{image[of.initial], of.initial}};
  std::set<Pair> known(found.begin(), found.end());
  for (std::size_t i = 0; i < found.size(); ++i)
    for (std::uint32_t a = 0; a < of.steps[0].size(); ++a) {
      const Pair from = found[i];
      const LetterwiseParity::Step mine = of.steps[from.first][a], theirs = of.steps[from.second][a];
      const Pair to{image[mine.target], theirs.target};
      if (known.insert(to).second) found.push_back(to);
      out.push_back({from, to, theirs.colour, {from.first, a}});
    }
  return out;
}

// Is the edge on a closed walk of edges with at least this colour, one of them with it?
bool on_cycle(const Edge& edge, std::uint32_t least, const std::map<Pair, std::vector<const Edge*>>& out_of) {
  if (edge.colour < least) return false;
  using Place = std::pair<Pair, bool>;  // where the walk is; has it met the colour?
  std::vector<Place> found{{edge.target, edge.colour == least}};
  std::set<Place> known(found.begin(), found.end());
  for (std::size_t i = 0; i < found.size(); ++i) {
    const Place at = found[i];
    if (at == Place(edge.source, true)) return true;
    const auto leaving = out_of.find(at.first);
    if (leaving == out_of.end()) continue;
    for (const Edge* e : leaving->second) {
      const Place to(e->target, at.second || e->colour == least);
      if (e->colour >= least && known.insert(to).second) found.push_back(to);
    }
  }
  return false;
}

bool has_colours(std::vector<Edge> left, std::uint32_t colours) {
  for (std::uint32_t colour = 0, idle = 0; !left.empty(); ++colour) {
    if (idle == 2) return false;
    std::map<Pair, std::vector<const Edge*>> out_of;
    for (const Edge& e : left) out_of[e.source].push_back(&e);
    std::set<Branch> blocked;
    for (const Edge& e : left)
      for (std::uint32_t least = 1 - colour % 2; least < colours && !blocked.contains(e.branch); least += 2)
        if (on_cycle(e, least, out_of)) blocked.insert(e.branch);
    idle = std::erase_if(left, [&](const Edge& e) { return !blocked.contains(e.branch); }) == 0 ? idle + 1 : 0;
  }
  return true;
}

}  // namespace

std::size_t merged_states(const LetterwiseParity& automaton) {
  const auto states = static_cast<std::uint32_t>(automaton.steps.size());
  std::vector<Pair> tries;
  std::set<std::uint32_t> done;
  for (std::uint32_t first = 0; first < states; ++first) {
    if (!done.insert(automaton.language[first]).second) continue;
    for (std::uint32_t q = 0; q < states; ++q)
      for (std::uint32_t r = 0; r < states; ++r)
        if (q != r && automaton.language[q] == automaton.language[first] &&
            automaton.language[r] == automaton.language[first])
          tries.emplace_back(q, r);
  }
  std::vector<std::uint32_t> image(states);
  std::iota(image.begin(), image.end(), 0U);
  for (std::size_t i = 0, idle = 0; idle < tries.size(); i = (i + 1) % tries.size(), ++idle) {
    const auto [q, r] = tries[i];
    if (image[q] != q || image[r] != r) continue;
    std::vector<std::uint32_t> redirected = image;
    std::replace(redirected.begin(), redirected.end(), q, r);
    if (!has_colours(product(automaton, redirected), automaton.colours)) continue;
    image = redirected;
    idle = 0;
  }
  std::set<std::uint32_t> reached;
  for (const Edge& e : product(automaton, image)) reached.insert(e.source.first);
  return reached.size();
}

}  // namespace waymark::test

#include "libautomata/omega/simulation.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <numeric>
#include <unordered_map>

#include "libautomata/omega/emptiness.hpp"
#include "libltl/pair_memo.hpp"
#include "libltl/random.hpp"

namespace waymark::automata {
namespace {

using Node = Mtbdd::Node;

class Simulation {
 public:
  // initial: when given, only this state is above it.
  Simulation(const Branching& automaton, Effort& effort, std::optional<std::uint32_t> initial = {})
      : automaton_(automaton), effort_(effort), below_(automaton.states() * automaton.states(), 1) {
    if (initial)
      for (std::uint32_t r = 0; r < automaton.states(); ++r)
        if (r != *initial) below_[index(*initial, r)] = 0;
    if (automaton.states() >= many_states) look_at_some_letters();
    while (round()) ++rounds_;
  }
  bool operator()(std::uint32_t q, std::uint32_t r) const { return below_[index(q, r)] != 0; }

  // By state: the first state that it simulates and that simulates it.
  std::vector<std::uint32_t> representatives() const {
    std::vector<std::uint32_t> out(automaton_.states());
    for (std::uint32_t q = 0; q < out.size(); ++q)
      for (std::uint32_t r = 0; r <= q; ++r)
        if ((*this)(q, r) && (*this)(r, q)) {
          out[q] = r;
          break;
        }
    return out;
  }

 private:
  struct Answer {
    std::uint32_t round = 0;  // when it was given; a "no" stays true, a "yes" only in its round
    bool yes = false;
  };

  static constexpr std::size_t many_states = 40;  // from here on most pairs are told apart by single letters
  static constexpr std::size_t letters = 32;

  std::size_t index(std::uint32_t q, std::uint32_t r) const { return q * automaton_.states() + r; }

  // The greatest simulation on a few letters lies above the one on all of them: what it refutes need not be compared.
  void look_at_some_letters() {
    ltl::Random random(1);  // fixed; any letters will do
    std::vector<std::array<std::uint32_t, letters>> choice(automaton_.states());
    for (std::size_t i = 0; i < letters; ++i) {
      const std::uint64_t seed = random.below(UINT64_MAX);
      const auto letter = [&](Mtbdd::Variable v) {
        return (((seed ^ (v + 1) * 0x9E37'79B9'7F4A'7C15ULL) * 0xBF58'476D'1CE4'E5B9ULL) >> 63U) != 0;
      };
      for (std::uint32_t q = 0; q < choice.size(); ++q)
        choice[q][i] = Mtbdd::payload(automaton_.diagram.evaluate(automaton_.roots[q], letter));
    }
    for (bool changed = true; changed;) {
      changed = false;
      for (std::uint32_t q = 0; q < choice.size(); ++q) {
        effort_.step(choice.size());
        for (std::uint32_t r = 0; r < choice.size(); ++r)
          for (std::size_t i = 0; i < letters && q != r && below_[index(q, r)] != 0; ++i)
            if (choice[q][i] != choice[r][i] && !covered(choice[q][i], choice[r][i])) {
              below_[index(q, r)] = 0;
              changed = true;
            }
      }
    }
  }

  bool round() {
    bool changed = false;
    for (std::uint32_t q = 0; q < automaton_.states(); ++q) {
      effort_.step(automaton_.states() / 16);
      for (std::uint32_t r = 0; r < automaton_.states(); ++r) {
        if (q == r || below_[index(q, r)] == 0 || compare(automaton_.roots[q], automaton_.roots[r])) continue;
        below_[index(q, r)] = 0;
        changed = true;
      }
    }
    return changed;
  }
  bool compare(Node x, Node y) {
    if (x == y) return true;
    if (const Answer* known = known_.find(x.id, y.id))
      if (!known->yes || known->round == rounds_) return known->yes;
    effort_.step();
    const bool yes = look(x, y);
    known_.store(x.id, y.id, {rounds_, yes});
    return yes;
  }
  bool look(Node x, Node y) {
    if (Mtbdd::is_terminal(x) && Mtbdd::is_terminal(y)) return covered(Mtbdd::payload(x), Mtbdd::payload(y));
    const Mtbdd& diagram = automaton_.diagram;
    const Mtbdd::Variable top = std::min(diagram.variable(x), diagram.variable(y));
    const auto side = [&](Node n, bool high) {
      return diagram.variable(n) != top ? n : high ? diagram.high(n) : diagram.low(n);
    };
    return compare(side(x, false), side(y, false)) && compare(side(x, true), side(y, true));
  }
  bool covered(std::uint32_t c, std::uint32_t d) const {
    const std::span<const Branch> better = automaton_.choices[d];
    for (const Branch& b : automaton_.choices[c])
      if (std::none_of(better.begin(), better.end(), [&](const Branch& a) {
            return a.marks.includes(b.marks) && below_[index(b.target, a.target)] != 0;
          }))
        return false;
    return true;
  }

  const Branching& automaton_;
  Effort& effort_;
  std::vector<std::uint8_t> below_;  // [q · states + r]
  ltl::PairMemo<Answer> known_;
  std::uint32_t rounds_ = 0;
};

// Of branches that are no better than another one, one at a time goes.
template <class NoBetter>
void drop_dominated(std::vector<Branch>& branches, const NoBetter& no_better) {
  for (std::size_t i = 0; i < branches.size();) {
    const Branch b = branches[i];
    if (std::any_of(branches.begin(), branches.end(),
                    [&](const Branch& a) { return a != b && no_better(b, a); }))
      branches.erase(branches.begin() + static_cast<std::ptrdiff_t>(i));
    else
      ++i;
  }
}

std::vector<Branch> unique(std::vector<Branch> branches) {
  std::sort(branches.begin(), branches.end());
  branches.erase(std::unique(branches.begin(), branches.end()), branches.end());
  return branches;
}

// Classes numbered by first member; `kept` holds the representatives.
struct Merging {
  std::vector<std::uint32_t> kept, number;  // number: new state of an old one
};
Merging merging(const std::vector<std::uint32_t>& representative) {
  Merging out{{}, std::vector<std::uint32_t>(representative.size())};
  for (std::uint32_t q = 0; q < representative.size(); ++q) {
    if (representative[q] == q) {
      out.number[q] = static_cast<std::uint32_t>(out.kept.size());
      out.kept.push_back(q);
    } else {
      out.number[q] = out.number[representative[q]];
    }
  }
  return out;
}

Branching merged(const Branching& automaton, const Simulation& below) {
  const std::vector<std::uint32_t> representative = below.representatives();
  const Merging merge = merging(representative);
  Branching out = rebuild(automaton, merge.kept, [&](std::uint32_t, std::span<const Branch> choice) {
    std::vector<Branch> branches(choice.begin(), choice.end());
    for (Branch& b : branches) b.target = representative[b.target];
    branches = unique(std::move(branches));
    drop_dominated(branches, [&](const Branch& b, const Branch& a) {
      return a.marks.includes(b.marks) && below(b.target, a.target);
    });
    for (Branch& b : branches) b.target = merge.number[b.target];
    return branches;
  });
  out.initial = merge.number[automaton.initial];
  return out;
}

// No two states simulate each other. A branch that leaves its component may carry any marks: a run takes such ones
// finitely often. So it may replace a branch with marks whose target it simulates.
Branching pruned(const Branching& automaton, const Simulation& below) {
  const BranchGraph graph(automaton);
  const Components found = components(graph);
  std::vector<std::uint32_t> all(automaton.states());
  std::iota(all.begin(), all.end(), 0U);
  return rebuild(automaton, all, [&](std::uint32_t source, std::span<const Branch> choice) {
    std::vector<Branch> branches(choice.begin(), choice.end());
    drop_dominated(branches, [&](const Branch& b, const Branch& a) {
      const bool leaves = found.of[source] != found.of[a.target];
      return (leaves || a.marks.includes(b.marks)) && below(b.target, a.target);
    });
    return branches;
  });
}

// δ⁻¹: the branches of q are (marks, p) for the branches (marks, q) of p.
class Reversal {
 public:
  Reversal(const Branching& automaton, Effort& effort) : from_(automaton), effort_(effort) {
    out_.roots.assign(automaton.states(), Mtbdd::terminal(Choices::none));
    out_.initial = automaton.initial;
    out_.acceptance = automaton.acceptance;
    union_ = out_.diagram.operation();
    for (std::uint32_t p = 0; p < automaton.states(); ++p) {
      known_.clear();
      for (const auto& [q, root] : into(p, automaton.roots[p]))
        out_.roots[q] = unite(out_, union_, out_.roots[q], root, effort_);
    }
  }
  Branching result() && { return std::move(out_); }

 private:
  using ByTarget = std::map<std::uint32_t, Node>;

  const ByTarget& into(std::uint32_t p, Node n) {
    if (const auto at = known_.find(n.id); at != known_.end()) return at->second;
    effort_.step();
    ByTarget out;
    if (Mtbdd::is_terminal(n)) {
      std::map<std::uint32_t, std::vector<Branch>> branches;
      for (const Branch& b : from_.choices[Mtbdd::payload(n)]) branches[b.target].push_back({p, b.marks});
      for (auto& [q, choice] : branches) out[q] = Mtbdd::terminal(out_.choices.intern(std::move(choice)));
    } else {
      const ByTarget low = into(p, from_.diagram.low(n)), high = into(p, from_.diagram.high(n));
      const auto side = [](const ByTarget& map, std::uint32_t q) {
        const auto at = map.find(q);
        return at == map.end() ? Mtbdd::terminal(Choices::none) : at->second;
      };
      const Mtbdd::Variable v = from_.diagram.variable(n);
      for (const auto& [q, root] : low) out[q] = out_.diagram.make(v, root, side(high, q));
      for (const auto& [q, root] : high)
        if (!low.contains(q)) out[q] = out_.diagram.make(v, Mtbdd::terminal(Choices::none), root);
    }
    return known_.emplace(n.id, std::move(out)).first->second;
  }
  const Branching& from_;
  Effort& effort_;
  Branching out_;
  Mtbdd::Operation union_;
  std::unordered_map<std::uint32_t, ByTarget> known_;
};

// The union of the choices of each class.
Branching united(const Branching& automaton, const std::vector<std::uint32_t>& representative,
                 Effort& effort) {
  const Merging merge = merging(representative);
  std::vector<std::uint32_t> all(automaton.states());
  std::iota(all.begin(), all.end(), 0U);
  Branching out = rebuild(automaton, all, [&](std::uint32_t, std::span<const Branch> choice) {
    std::vector<Branch> branches(choice.begin(), choice.end());
    for (Branch& b : branches) b.target = merge.number[b.target];
    return branches;
  });
  const Mtbdd::Operation operation = out.diagram.operation();
  std::vector<Node> roots(merge.kept.size(), Mtbdd::terminal(Choices::none));
  for (std::uint32_t q = 0; q < automaton.states(); ++q) {
    Node& root = roots[merge.number[q]];
    root = unite(out, operation, root, out.roots[q], effort);
  }
  out.roots = std::move(roots);
  out.initial = merge.number[automaton.initial];
  return out;
}

}  // namespace

Quotient bisimulation(const Branching& automaton, Effort& effort) {
  std::vector<std::uint32_t> class_of(automaton.states(), 0);
  std::size_t classes = 1;
  while (true) {
    Mtbdd images;
    Choices choices;
    const auto leaf = [&](std::uint32_t c) {
      effort.step();
      std::vector<Branch> branches(automaton.choices[c].begin(), automaton.choices[c].end());
      for (Branch& b : branches) b.target = class_of[b.target];
      return Mtbdd::terminal(choices.intern(std::move(branches)));
    };
    const std::vector<Node> roots =
        images.import(automaton.diagram, automaton.roots, leaf, [](Mtbdd::Variable v) { return v; });
    std::map<std::pair<std::uint32_t, Node>, std::uint32_t> names;
    std::vector<std::uint32_t> next(class_of.size()), representative(class_of.size()), first;
    for (std::uint32_t q = 0; q < next.size(); ++q) {
      const auto [at, fresh] =
          names.try_emplace({class_of[q], roots[q]}, static_cast<std::uint32_t>(names.size()));
      if (fresh) first.push_back(q);
      next[q] = at->second;
      representative[q] = first[at->second];
    }
    class_of = std::move(next);
    if (names.size() == classes) {
      Merging merge = merging(representative);
      Branching out = rebuild(automaton, merge.kept, [&](std::uint32_t, std::span<const Branch> choice) {
        std::vector<Branch> branches(choice.begin(), choice.end());
        for (Branch& b : branches) b.target = merge.number[b.target];
        return branches;
      });
      out.initial = merge.number[automaton.initial];
      return {std::move(out), std::move(merge.number)};
    }
    classes = names.size();
  }
}

std::vector<std::vector<bool>> direct_simulation(const Branching& automaton, Effort& effort) {
  const Simulation below(automaton, effort);
  std::vector<std::vector<bool>> out(automaton.states(), std::vector<bool>(automaton.states()));
  for (std::uint32_t q = 0; q < automaton.states(); ++q)
    for (std::uint32_t r = 0; r < automaton.states(); ++r) out[q][r] = below(q, r);
  return out;
}

struct Simulations::Relations {
  std::optional<Simulation> forwards, backwards;
  std::optional<Branching> reversed;
};

Simulations::Simulations(const Branching& automaton, Effort& effort)
    : automaton_(automaton), effort_(effort), relations_(std::make_unique<Relations>()) {}
Simulations::~Simulations() = default;

const Simulations::Relations& Simulations::with_forwards() {
  if (!relations_->forwards) relations_->forwards.emplace(automaton_, effort_);
  return *relations_;
}
const Simulations::Relations& Simulations::with_backwards() {
  if (relations_->backwards) return *relations_;
  relations_->reversed = Reversal(automaton_, effort_).result();
  relations_->backwards.emplace(*relations_->reversed, effort_, automaton_.initial);
  return *relations_;
}

Branching Simulations::quotient() {
  const Simulation& below = *with_forwards().forwards;
  Branching out = merged(automaton_, below);
  return out.states() == automaton_.states() ? pruned(automaton_, below) : out;
}

Branching Simulations::reverse_quotient(const std::vector<bool>& colour) {
  const Simulation& below = *with_backwards().backwards;
  std::vector<std::uint32_t> representative(automaton_.states());
  for (std::uint32_t q = 0; q < representative.size(); ++q) {
    representative[q] = q;
    for (std::uint32_t r = 0; r < q && representative[q] == q; ++r)
      if (colour[q] == colour[r] && below(q, r) && below(r, q)) representative[q] = r;
  }
  return united(automaton_, representative, effort_);
}

Branching Simulations::without_overtaken() {
  const Simulation &after = *with_forwards().forwards, &before = *with_backwards().backwards;
  Branching out = automaton_;
  const Mtbdd::Operation operation = out.diagram.operation();
  const auto decide = [&](const std::array<Node, 2>& n) -> std::optional<Node> {
    const Node none = Mtbdd::terminal(Choices::none);
    effort_.step();
    if (n[0] == none || n[1] == none) return n[0];
    if (!Mtbdd::is_terminal(n[0]) || !Mtbdd::is_terminal(n[1])) return std::nullopt;
    const auto mine = out.choices[Mtbdd::payload(n[0])], theirs = out.choices[Mtbdd::payload(n[1])];
    std::vector<Branch> kept;
    for (const Branch& b : mine)
      if (std::none_of(theirs.begin(), theirs.end(), [&](const Branch& a) {
            return a.marks.includes(b.marks) && after(b.target, a.target);
          }))
        kept.push_back(b);
    return Mtbdd::terminal(out.choices.intern(std::move(kept)));
  };
  for (std::uint32_t p = 0; p < automaton_.states(); ++p)
    for (std::uint32_t q = 0; q < automaton_.states(); ++q)
      if (before(p, q) && !before(q, p))
        out.roots[p] = out.diagram.apply(operation, std::array{out.roots[p], automaton_.roots[q]}, decide);
  return out;
}

}  // namespace waymark::automata

#include "libautomata/omega/tableau.hpp"

#include <algorithm>
#include <optional>
#include <stdexcept>
#include <unordered_map>

#include "libautomata/omega/emptiness.hpp"
#include "libltl/rewriting/implication.hpp"
#include "libltl/rewriting/pair_memo.hpp"
#include "libltl/rewriting/separate.hpp"
#include "libltl/text/bounds.hpp"

namespace waymark::automata {
namespace {

using ltl::Formula;
using ltl::Op;
using Node = Mtbdd::Node;

class Construction {
 public:
  Construction(ltl::Arena& arena, const std::vector<ltl::Proposition>& reads, Budget& budget)
      : arena_(arena), reads_(reads), budget_(budget), and_(diagram_.operation()), or_(diagram_.operation()) {}

  // The reachable part.
  Tableau tableau(Formula f) {
    std::vector<Node> roots;
    has_bounds_ = ltl::has_bounds(f);
    state_of(f);
    for (std::size_t i = 0; i < order_.size(); ++i) {  // the order doubles as the queue
      roots.push_back(order_[i]);
      for (std::uint32_t c : leaves(order_[i]))
        for (std::size_t b = 0; b < choices_[c].size(); ++b) state_of(arena_.formula(choices_[c][b].target));
    }
    TransitionRelation out;
    const Marks all = Marks::first(static_cast<std::uint32_t>(promises_.size()));
    const auto leaf = [&](std::uint32_t c) {
      std::vector<Branch> branches;
      for (const Branch& b : choices_[c])
        branches.push_back({state_of(arena_.formula(b.target)), all.without(b.marks)});
      return Mtbdd::terminal(out.choices.intern(std::move(branches)));
    };
    out.roots = out.diagram.import(diagram_, roots, leaf, [](Mtbdd::Variable v) { return v; });
    out.acceptance = Acceptance::generalized_buchi(static_cast<std::uint32_t>(promises_.size()));
    return {std::move(out), std::move(meaning_)};
  }

  bool is_satisfiable(Formula f) {
    const std::uint32_t start = state_of(f);
    if (start >= verdict_.size() || verdict_[start] == Verdict::Unknown) decide(start);
    return verdict_[start] == Verdict::Live;
  }

 private:
  enum class Verdict : std::uint8_t { Unknown, Dead, Live };

  // Settles a state and what it reaches, up to states that are settled.
  void decide(std::uint32_t start) {
    std::vector<std::uint32_t> open{start};
    std::unordered_map<std::uint32_t, std::uint32_t> number{{start, 0}};
    std::vector<bool> reaches_live;
    BranchGraph graph;
    for (std::uint32_t i = 0; i < open.size(); ++i) {  // open doubles as the queue
      graph.add_state();
      reaches_live.push_back(false);
      const std::uint32_t source = open[i];
      for (std::size_t b = 0; b < edges_of(source).size(); ++b) {
        const Branch edge = edges_of(source)[b];
        if (edge.target < verdict_.size() && verdict_[edge.target] != Verdict::Unknown) {
          reaches_live[i] = reaches_live[i] || verdict_[edge.target] == Verdict::Live;
          continue;
        }
        const auto [at, fresh] = number.try_emplace(edge.target, static_cast<std::uint32_t>(open.size()));
        if (fresh) open.push_back(edge.target);
        graph.add(i, {at->second, edge.marks});
      }
    }
    settle(open, graph, reaches_live);
  }
  // Marks are promises here: a component accepts when each is not made on some edge of it.
  void settle(const std::vector<std::uint32_t>& open, const BranchGraph& graph, std::vector<bool> reaches_live) {
    verdict_.resize(order_.size(), Verdict::Unknown);
    const Components found = components(graph);
    for (std::size_t i = 0; i < found.order.size();) {  // successors first
      const std::uint32_t c = found.of[found.order[i]];
      const std::size_t begin = i;
      Marks made_always = Marks::first(Marks::most);
      bool live = false, cyclic = false;
      for (; i < found.order.size() && found.of[found.order[i]] == c; ++i) {
        live = live || reaches_live[found.order[i]];
        for (const Branch& b : graph.branches(found.order[i])) {
          if (found.of[b.target] != c) {
            live = live || verdict_[open[b.target]] == Verdict::Live;
          } else {
            cyclic = true;
            made_always = made_always & b.marks;
          }
        }
      }
      live = live || (cyclic && made_always.empty());
      for (std::size_t j = begin; j < i; ++j) verdict_[open[found.order[j]]] = live ? Verdict::Live : Verdict::Dead;
    }
  }
  // (state, promises), letters forgotten.
  const std::vector<Branch>& edges_of(std::uint32_t state) {
    if (state >= edges_.size()) edges_.resize(state + 1);
    if (edges_[state]) return *edges_[state];
    std::vector<Branch> out;
    for (std::uint32_t c : all_leaves(order_[state]))
      for (std::size_t b = 0; b < choices_[c].size(); ++b) {
        const Branch branch = choices_[c][b];
        out.push_back({state_of(arena_.formula(branch.target)), branch.marks});
      }
    std::sort(out.begin(), out.end());
    out.erase(std::unique(out.begin(), out.end()), out.end());
    edges_[state] = std::move(out);
    return *edges_[state];
  }
  // Distinct ones below a root.
  std::vector<std::uint32_t> all_leaves(Node root) {
    ++round_;
    return leaves(root);
  }

  std::uint32_t state_of(Formula f) {
    if (const std::uint32_t* known = number_of_.find(f.id(), 0)) return *known;
    const Node root = successors(f);
    const std::uint32_t* before = number_.find(root.id, 0);
    const auto number = before != nullptr ? *before : static_cast<std::uint32_t>(order_.size());
    if (before == nullptr) {
      budget_.state();
      order_.push_back(root);
      meaning_.push_back(f);
      number_.store(root.id, 0, number);
    }
    number_of_.store(f.id(), 0, number);
    return number;
  }

  std::vector<std::uint32_t> leaves(Node root) {
    node_seen_.resize(diagram_.size(), 0);
    choice_seen_.resize(choices_.size(), 0);
    std::vector<std::uint32_t> out;
    std::vector<Node> stack{root};
    while (!stack.empty()) {
      const Node n = stack.back();
      stack.pop_back();
      const bool terminal = Mtbdd::is_terminal(n);
      std::uint32_t& seen = terminal ? choice_seen_[Mtbdd::payload(n)] : node_seen_[n.id];
      if (seen == round_) continue;  // below it everything is known
      seen = round_;
      if (terminal) {
        out.push_back(Mtbdd::payload(n));
      } else {
        stack.push_back(diagram_.high(n));
        stack.push_back(diagram_.low(n));
      }
    }
    return out;
  }

  Node successors(Formula f) {
    if (const Node* known = successors_.find(f.id(), 0)) return *known;
    const Node root = expand(f);
    successors_.store(f.id(), 0, root);
    return root;
  }

  Node expand(Formula f) {
    switch (f.op()) {
      case Op::False: return Mtbdd::terminal(Choices::none);
      case Op::True: return one(f, {});
      case Op::Atom: return literal(f, true);
      case Op::Not: return literal(f[0], false);
      case Op::And: {
        Node all = successors(f[0]);
        for (std::size_t i = 1; i < f.operands().size(); ++i) all = both(all, successors(f[i]));
        return all;
      }
      case Op::Or: {
        Node all = successors(f[0]);
        for (std::size_t i = 1; i < f.operands().size(); ++i) all = either(all, successors(f[i]));
        return purities_.of(f).both() ? postponed(f, all) : all;
      }
      case Op::Next:
      case Op::WeakNext: return one(f[0], {});
      case Op::Until: {
        const Node later = one(f, promise(f));
        const Node kept = both(successors(f[0]), later);
        return either(successors(f[1]), kept);
      }
      case Op::Release: {
        const Node later = one(f, {});
        const Node kept = either(successors(f[0]), later);
        return both(successors(f[1]), kept);
      }
      case Op::Yesterday:
      case Op::Since:  // without_past comes first
      case Op::Iff: break;
    }
    throw std::logic_error("a tableau needs negation normal form");
  }

  // A disjunction that only concerns the far end of the word may be postponed as a whole: a branch that leads to one
  // of its disjuncts and promises something may as well lead back to it, always under the same promise, so that
  // nobody postpones for ever.
  Node postponed(Formula f, Node root) {
    std::unordered_map<std::uint32_t, Node> image;
    Marks waiting;
    const auto change = [&](auto&& self, Node n) -> Node {
      if (const auto known = image.find(n.id); known != image.end()) return known->second;
      Node made;
      if (Mtbdd::is_terminal(n)) {
        std::vector<Branch> branches(choices_[Mtbdd::payload(n)].begin(), choices_[Mtbdd::payload(n)].end());
        for (Branch& b : branches) {
          const auto all = f.operands();
          if (b.marks.empty() || std::find(all.begin(), all.end(), arena_.formula(b.target)) == all.end()) continue;
          if (waiting.empty()) waiting = Marks::of(b.marks.members().front());
          b = {f.id(), waiting};
        }
        made = Mtbdd::terminal(antichain(std::move(branches)));
      } else {
        const Node low = self(self, diagram_.low(n)), high = self(self, diagram_.high(n));
        made = diagram_.make(diagram_.variable(n), low, high);
      }
      image.emplace(n.id, made);
      return made;
    };
    return change(change, root);
  }

  Node one(Formula next, Marks promises) { return Mtbdd::terminal(choices_.intern({{next.id(), promises}})); }
  Node literal(Formula atom, bool positive) {
    const auto at = std::lower_bound(reads_.begin(), reads_.end(), atom.proposition());
    const Node yes = one(arena_.constant(true), {}), no = Mtbdd::terminal(Choices::none);
    return diagram_.make(static_cast<Mtbdd::Variable>(at - reads_.begin()), positive ? no : yes, positive ? yes : no);
  }
  Marks promise(Formula until) {
    Formula right = until[1];
    while (right.op() == Op::Until) right = right[1];
    const auto [at, fresh] = promises_.try_emplace(right, static_cast<std::uint32_t>(promises_.size()));
    if (fresh && promises_.size() > Marks::most) throw Budget::Exceeded{Budget::Exceeded::Reason::States};
    return Marks::of(at->second);
  }

  Node both(Node f, Node g) {
    const Node nothing = Mtbdd::terminal(Choices::none), free = one(arena_.constant(true), {});
    const auto decide = [&](const std::array<Node, 2>& a) -> std::optional<Node> {
      budget_.step();
      if (a[0] == nothing || a[1] == nothing) return nothing;
      if (a[0] == free || a[0] == a[1]) return a[1];
      if (a[1] == free) return a[0];
      if (!Mtbdd::is_terminal(a[0]) || !Mtbdd::is_terminal(a[1])) return std::nullopt;
      return Mtbdd::terminal(product(Mtbdd::payload(a[0]), Mtbdd::payload(a[1])));
    };
    return diagram_.apply(and_, g < f ? std::array{g, f} : std::array{f, g}, decide);
  }
  Node either(Node f, Node g) {
    const Node nothing = Mtbdd::terminal(Choices::none), free = one(arena_.constant(true), {});
    const auto decide = [&](const std::array<Node, 2>& a) -> std::optional<Node> {
      budget_.step();
      if (a[0] == free || a[1] == free) return free;
      if (a[0] == nothing || a[0] == a[1]) return a[1];
      if (a[1] == nothing) return a[0];
      if (!Mtbdd::is_terminal(a[0]) || !Mtbdd::is_terminal(a[1])) return std::nullopt;
      return Mtbdd::terminal(sum(Mtbdd::payload(a[0]), Mtbdd::payload(a[1])));
    };
    return diagram_.apply(or_, g < f ? std::array{g, f} : std::array{f, g}, decide);
  }

  std::uint32_t product(std::uint32_t f, std::uint32_t g) {
    if (const std::uint32_t* known = products_.find(f, g)) return *known;
    std::vector<Branch> all;
    for (const Branch& a : choices_[f])
      for (const Branch& b : choices_[g]) {
        budget_.step();
        const Formula next = without_weaker(conjunction(arena_.formula(a.target), arena_.formula(b.target)));
        if (next.op() != Op::False) all.push_back({next.id(), a.marks | b.marks});
      }
    const std::uint32_t made = antichain(std::move(all));
    products_.store(f, g, made);
    return made;
  }
  // Without the conjuncts that follow from another one because both are of one chain of bounded operators, below as
  // many nexts.
  Formula without_weaker(Formula f) {
    if (!has_bounds_ || f.op() != Op::And) return f;
    struct Kept {
      std::size_t nexts;
      Formula inner, conjunct;
    };
    std::vector<Kept> kept;
    std::vector<Formula> out;
    for (const Formula g : f.operands()) {
      Kept candidate{0, g, g};
      for (; candidate.inner.op() == Op::Next || candidate.inner.op() == Op::WeakNext; ++candidate.nexts)
        candidate.inner = candidate.inner[0];
      const auto is_weaker = [&](const Kept& a, const Kept& b) {  // b ⇒ a
        return a.nexts == b.nexts && bounds_.implies(b.inner, a.inner);
      };
      if (std::any_of(kept.begin(), kept.end(), [&](const Kept& k) { return is_weaker(candidate, k); })) continue;
      std::erase_if(kept, [&](const Kept& k) { return is_weaker(k, candidate); });
      kept.push_back(candidate);
    }
    for (const Kept& k : kept) out.push_back(k.conjunct);
    return out.size() == f.operands().size() ? f : conjunction(arena_, out);
  }
  std::uint32_t sum(std::uint32_t f, std::uint32_t g) {
    std::vector<Branch> all(choices_[f].begin(), choices_[f].end());
    all.insert(all.end(), choices_[g].begin(), choices_[g].end());
    return antichain(std::move(all));
  }

  // A run that could take b may as well take a: it promises no more, and b's rest implies a's.
  std::uint32_t antichain(std::vector<Branch> all) {
    std::sort(all.begin(), all.end());
    all.erase(std::unique(all.begin(), all.end()), all.end());
    for (std::size_t i = 0; i < all.size();) {
      const Branch b = all[i];
      const auto better = [&](const Branch& a) {
        budget_.step();
        return a != b && b.marks.includes(a.marks) && implies_(arena_.formula(b.target), arena_.formula(a.target));
      };
      // One at a time, so that of two branches as good as each other one stays.
      if (std::any_of(all.begin(), all.end(), better))
        all.erase(all.begin() + static_cast<std::ptrdiff_t>(i));
      else
        ++i;
    }
    return choices_.intern(std::move(all));
  }

  ltl::Arena& arena_;
  const std::vector<ltl::Proposition>& reads_;
  Budget& budget_;
  ltl::Implication implies_;
  ltl::Purities purities_;
  ltl::Bounds bounds_;
  bool has_bounds_ = false;
  Mtbdd diagram_;    // terminals are choices
  Choices choices_;  // branches: target is the id of a formula, marks are promises
  Mtbdd::Operation and_, or_;
  ltl::PairMemo<std::uint32_t> products_;  // of two choices
  std::unordered_map<Formula, std::uint32_t> promises_;
  ltl::PairMemo<Node> successors_;          // of (formula, 0)
  std::vector<Node> order_;                 // roots of states
  std::vector<Formula> meaning_;            // of states
  ltl::PairMemo<std::uint32_t> number_;     // state of (root, 0)
  ltl::PairMemo<std::uint32_t> number_of_;  // … of (formula, 0)
  std::uint32_t round_ = 1;
  std::vector<std::uint32_t> node_seen_, choice_seen_;     // in which round
  std::vector<std::optional<std::vector<Branch>>> edges_;  // by state, where they were asked for
  std::vector<Verdict> verdict_;                           // by state
};

}  // namespace

Tableau tableau(Formula f, const std::vector<ltl::Proposition>& reads, Budget& budget) {
  return Construction(f.arena(), reads, budget).tableau(f);
}

class Satisfiability::Shared : public Construction {
 public:
  using Construction::Construction;
};

Satisfiability::Satisfiability(ltl::Arena& arena, const std::vector<ltl::Proposition>& reads, Budget& budget)
    : shared_(std::make_unique<Shared>(arena, reads, budget)) {}
Satisfiability::~Satisfiability() = default;
bool Satisfiability::operator()(Formula f) { return shared_->is_satisfiable(f); }

}  // namespace waymark::automata

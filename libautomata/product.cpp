#include "libautomata/product.hpp"

#include <algorithm>
#include <array>
#include <stdexcept>
#include <unordered_map>
#include <utility>

#include "libautomata/boolean.hpp"
#include "libautomata/minimize.hpp"
#include "libautomata/run.hpp"

namespace waymark::automata {
namespace {

using Node = Mtbdd::Node;

class Pairs {
 public:
  explicit Pairs(Effort& effort) : effort_(effort) {}
  std::uint32_t number(std::uint32_t p, std::uint32_t q) {
    const auto [at, fresh] =
        number_.try_emplace(std::uint64_t{p} << 32U | q, static_cast<std::uint32_t>(pairs_.size()));
    if (fresh) {
      pairs_.emplace_back(p, q);
      effort_.state();
    }
    return at->second;
  }
  std::size_t size() const { return pairs_.size(); }
  std::pair<std::uint32_t, std::uint32_t> operator[](std::size_t i) const { return pairs_[i]; }

 private:
  Effort& effort_;
  std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs_;
  std::unordered_map<std::uint64_t, std::uint32_t> number_;
};

// The same function where variable v is called name[v]; the order of variables may change.
std::vector<Node> renamed(const Mtbdd& from, const std::vector<Node>& roots,
                          const std::vector<Mtbdd::Variable>& name, Mtbdd& to) {
  Boolean logic(to);
  std::vector<Node> image(from.size());
  const auto of = [&](Node n) { return Mtbdd::is_terminal(n) ? n : image[n.id]; };
  for (Node n : from.reachable(roots))
    image[n.id] =
        logic.if_then_else(logic.variable(name[from.variable(n)]), of(from.high(n)), of(from.low(n)));
  std::vector<Node> out;
  for (Node root : roots) out.push_back(of(root));
  return out;
}

Transitions over(const Dfa& dfa, const ltl::Vocabulary& vocabulary,
                 const std::vector<ltl::Proposition>& reads) {
  std::vector<Mtbdd::Variable> name;
  for (ltl::Proposition p : dfa.reads()) {
    const ltl::Proposition q = *vocabulary.find(dfa.vocabulary().name(p));
    const auto at = std::lower_bound(reads.begin(), reads.end(), q);
    name.push_back(static_cast<Mtbdd::Variable>(at - reads.begin()));
  }
  Transitions out;
  std::vector<Node> roots;
  for (std::uint32_t q = 0; q < dfa.states(); ++q) {
    roots.push_back(dfa.root(StateId{q}));
    out.accepting.push_back(dfa.is_accepting(StateId{q}));
  }
  out.roots = renamed(dfa.diagram(), roots, name, out.diagram);
  out.initial = dfa.initial().index;
  return out;
}

}  // namespace

Transitions product(const Transitions& a, const Transitions& b, Verdict verdict, Effort& effort) {
  Mtbdd both;  // a's diagrams, b's diagrams, and those of the pairs
  const auto same = [](std::uint32_t q) { return Mtbdd::terminal(q); };
  const auto keep = [](Mtbdd::Variable v) { return v; };
  const std::vector<Node> first = both.import(a.diagram, a.roots, same, keep);
  const std::vector<Node> second = both.import(b.diagram, b.roots, same, keep);
  Pairs pairs(effort);
  const auto decide = [&](const std::array<Node, 2>& n) -> std::optional<Node> {
    effort.step();
    if (!Mtbdd::is_terminal(n[0]) || !Mtbdd::is_terminal(n[1])) return std::nullopt;
    return Mtbdd::terminal(pairs.number(Mtbdd::payload(n[0]), Mtbdd::payload(n[1])));
  };
  const Mtbdd::Operation pairing = both.operation();
  std::vector<Node> roots;
  Transitions out;
  out.initial = pairs.number(a.initial, b.initial);
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const auto [p, q] = pairs[i];
    out.accepting.push_back(verdict(a.accepting[p], b.accepting[q]));
    roots.push_back(both.apply(pairing, std::array{first[p], second[q]}, decide));
  }
  out.roots = out.diagram.import(both, roots, same, keep);
  return out;
}

Dfa product(const Dfa& a, const Dfa& b, Verdict verdict) {
  if (verdict(false, false)) throw std::invalid_argument("a product of DFAs may not accept the empty word");
  ltl::Vocabulary vocabulary = a.vocabulary();
  std::vector<ltl::Proposition> reads = a.reads();
  for (const std::string& name : b.vocabulary().names()) vocabulary.add(name);
  for (ltl::Proposition p : b.reads()) reads.push_back(*vocabulary.find(b.vocabulary().name(p)));
  std::sort(reads.begin(), reads.end());
  reads.erase(std::unique(reads.begin(), reads.end()), reads.end());
  Effort unlimited;
  const Transitions pairs =
      product(over(a, vocabulary, reads), over(b, vocabulary, reads), verdict, unlimited);
  return as_dfa(canonical(pairs), vocabulary, reads);
}

std::optional<Difference> difference(const Dfa& a, const Dfa& b) {
  const Dfa either = product(a, b, [](bool p, bool q) { return p != q; });
  std::optional<ltl::Trace> word = shortest_word(either);
  if (!word) return std::nullopt;
  const Dfa only_first = product(a, b, [](bool p, bool q) { return p && !q; });
  const bool first_accepts = accepts(only_first, *word);
  return Difference{either.vocabulary(), *std::move(word), first_accepts};
}

}  // namespace waymark::automata

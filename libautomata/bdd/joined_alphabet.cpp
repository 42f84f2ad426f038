#include "libautomata/bdd/joined_alphabet.hpp"

#include <algorithm>

#include "libautomata/bdd/boolean.hpp"

namespace waymark::automata {

JoinedAlphabet joined(const Alphabet& first, const Alphabet& second) {
  JoinedAlphabet out{first.vocabulary, {}};
  for (const std::string& name : second.vocabulary.names()) out.vocabulary.add(name);
  const auto named = [&](const Alphabet& from, ltl::Proposition p) {
    return *out.vocabulary.find(from.vocabulary.name(p));
  };
  for (const Alphabet* from : {&first, &second})
    for (ltl::Proposition p : from->reads) out.reads.push_back(named(*from, p));
  std::sort(out.reads.begin(), out.reads.end());
  out.reads.erase(std::unique(out.reads.begin(), out.reads.end()), out.reads.end());
  const auto variables = [&](const Alphabet& from) {
    std::vector<Mtbdd::Variable> variable;
    for (ltl::Proposition p : from.reads) {
      const auto at = std::lower_bound(out.reads.begin(), out.reads.end(), named(from, p));
      variable.push_back(static_cast<Mtbdd::Variable>(at - out.reads.begin()));
    }
    return variable;
  };
  out.of_first = variables(first);
  out.of_second = variables(second);
  return out;
}

std::vector<Mtbdd::Node> renamed(const Mtbdd& from, const std::vector<Mtbdd::Node>& roots,
                                 const std::vector<Mtbdd::Variable>& name, Mtbdd& to) {
  Boolean logic(to);
  std::vector<Mtbdd::Node> image(from.size());
  const auto of = [&](Mtbdd::Node n) { return Mtbdd::is_terminal(n) ? n : image[n.id]; };
  for (Mtbdd::Node n : from.reachable(roots))
    image[n.id] = logic.if_then_else(logic.variable(name[from.variable(n)]), of(from.high(n)), of(from.low(n)));
  std::vector<Mtbdd::Node> out;
  for (Mtbdd::Node root : roots) out.push_back(of(root));
  return out;
}

}  // namespace waymark::automata

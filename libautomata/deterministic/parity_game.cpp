#include "libautomata/deterministic/parity_game.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <unordered_map>
#include <utility>

#include "libautomata/bdd/boolean.hpp"

namespace waymark::automata {
namespace {

using Node = Mtbdd::Node;

class Builder {
 public:
  Builder(const Dpa& automaton, const std::vector<ltl::Proposition>& outputs, Budget& budget)
      : parity_(min_even_parity(automaton.automaton().transitions())), budget_(budget), logic_(inputs_first_) {
    const std::vector<ltl::Proposition>& reads = automaton.automaton().reads();
    const auto is_output = [&](ltl::Proposition p) {
      return std::find(outputs.begin(), outputs.end(), p) != outputs.end();
    };
    for (const bool output : {false, true}) {
      for (std::size_t v = 0; v < reads.size(); ++v)
        if (is_output(reads[v]) == output) position_[static_cast<Mtbdd::Variable>(v)] = next_position_++;
      if (!output) first_output_ = next_position_;
    }
    colours_ = static_cast<std::uint32_t>(parity_.acceptance.sets);
  }

  ParityGame build() {
    environment(parity_.initial, colours_);
    for (std::size_t i = 0; i < game_.vertices.size(); ++i) expand(static_cast<std::uint32_t>(i));
    return std::move(game_);
  }

 private:
  using Player = ParityGame::Player;

  // Colours count the other way round, their parity kept: the least one is the greatest priority.
  std::uint32_t priority(std::uint32_t colour) const { return colours_ + colours_ % 2 - colour; }

  std::uint32_t add(Player owner, std::uint32_t priority, std::string name) {
    budget_.state();
    game_.vertices.push_back({owner, priority, {}, std::move(name)});
    return static_cast<std::uint32_t>(game_.vertices.size() - 1);
  }
  std::uint32_t environment(std::uint32_t state, std::uint32_t colour) {
    const auto [at, fresh] = environment_.try_emplace({state, colour}, 0);
    if (fresh) {
      at->second = add(Player::Environment, priority(colour), std::to_string(state) + '/' + std::to_string(colour));
      what_.push_back(reordered(parity_.roots[state]));
    }
    return at->second;
  }
  std::uint32_t system(Node rest) {
    const auto [at, fresh] = system_.try_emplace(rest, 0);
    if (fresh) {
      at->second = add(Player::System, 0, "");
      what_.push_back(rest);
    }
    return at->second;
  }
  std::uint32_t lost() {
    if (!lost_) {
      lost_ = add(Player::Environment, 1, "rejected");
      what_.push_back(Mtbdd::terminal(Choices::none));
      game_.vertices[*lost_].successors = {*lost_};
    }
    return *lost_;
  }

  void expand(std::uint32_t vertex) {
    if (lost_ == vertex) return;
    const bool inputs = game_.vertices[vertex].owner == Player::Environment;
    std::vector<std::uint32_t> successors;
    for (Node n : below(what_[vertex], inputs)) {
      if (inputs) {
        successors.push_back(system(n));
        continue;
      }
      const auto branches = parity_.choices[Mtbdd::payload(n)];
      if (branches.empty()) continue;
      std::uint32_t colour = colours_;
      for (std::uint32_t mark = colours_; mark-- > 0;)
        if (branches[0].marks.contains(mark)) colour = mark;
      successors.push_back(environment(branches[0].target, colour));
    }
    if (successors.empty()) successors.push_back(lost());
    std::sort(successors.begin(), successors.end());
    successors.erase(std::unique(successors.begin(), successors.end()), successors.end());
    game_.vertices[vertex].successors = std::move(successors);
  }

  // What the values of the inputs lead to, or of the outputs: terminals.
  std::vector<Node> below(Node top, bool inputs) const {
    std::vector<Node> out, stack{top};
    std::map<Node, bool> seen{{top, true}};
    while (!stack.empty()) {
      const Node n = stack.back();
      stack.pop_back();
      if (Mtbdd::is_terminal(n) || (inputs && inputs_first_.variable(n) >= first_output_)) {
        out.push_back(n);
        continue;
      }
      for (Node side : {inputs_first_.high(n), inputs_first_.low(n)})
        if (seen.try_emplace(side, true).second) stack.push_back(side);
    }
    return out;
  }

  // The diagram over inputs, then outputs.
  Node reordered(Node n) {
    if (Mtbdd::is_terminal(n)) return n;
    if (const auto known = reordered_.find(n.id); known != reordered_.end()) return known->second;
    const Node low = reordered(parity_.diagram.low(n)), high = reordered(parity_.diagram.high(n));
    const Node variable = logic_.variable(position_.at(parity_.diagram.variable(n)));
    const Node made = logic_.if_then_else(variable, high, low);
    reordered_.emplace(n.id, made);
    return made;
  }

  TransitionRelation parity_;
  Budget& budget_;
  Mtbdd inputs_first_;  // payloads are choices
  Boolean logic_;
  std::map<Mtbdd::Variable, Mtbdd::Variable> position_;
  Mtbdd::Variable next_position_ = 0, first_output_ = 0;
  std::uint32_t colours_ = 0;
  ParityGame game_;
  std::vector<Node> what_;  // by vertex: what is left of the transition function
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> environment_;
  std::map<Node, std::uint32_t> system_;
  std::optional<std::uint32_t> lost_;
  std::unordered_map<std::uint32_t, Node> reordered_;
};

}  // namespace

ParityGame parity_game(const Dpa& automaton, const std::vector<ltl::Proposition>& outputs, Budget& budget) {
  return Builder(automaton, outputs, budget).build();
}

std::string write_pgsolver(const ParityGame& game) {
  std::string out = "parity " + std::to_string(game.vertices.size() - 1) + ";\n";
  for (std::size_t v = 0; v < game.vertices.size(); ++v) {
    const ParityGame::Vertex& vertex = game.vertices[v];
    out += std::to_string(v) + ' ' + std::to_string(vertex.priority) + ' ' +
           std::to_string(static_cast<unsigned>(vertex.owner));
    for (std::size_t i = 0; i < vertex.successors.size(); ++i)
      out += (i == 0 ? ' ' : ',') + std::to_string(vertex.successors[i]);
    if (!vertex.name.empty()) {  // the format has no escapes
      std::string name = vertex.name;
      std::replace_if(
          name.begin(), name.end(), [](char c) { return c == '"' || c == '\n'; }, '\'');
      out += " \"" + name + '"';
    }
    out += ";\n";
  }
  return out;
}

}  // namespace waymark::automata

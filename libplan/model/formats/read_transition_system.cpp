#include "libplan/model/formats/read_transition_system.hpp"

#include <yaml-cpp/yaml.h>

#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "libltl/diagnostic.hpp"
#include "libltl/meaning/semantics.hpp"
#include "libltl/structure/fragment.hpp"
#include "libltl/text/foreign.hpp"
#include "libltl/text/parse.hpp"

namespace waymark::plan {
namespace {

constexpr std::size_t most_bytes = 16U << 20U, most_states = 1'000'000, most_choices = 10'000'000;

class Reader {
 public:
  Reader(std::string_view yaml, std::string_view source) : source_(source) {
    if (yaml.size() > most_bytes) throw ltl::FormatError(source, 0, 0, "expected at most 16 MiB");
    ltl::refuse_foreign(yaml, source, "a transition system in YAML");
    try {
      document_ = YAML::Load(std::string(yaml));
      read();
    } catch (const YAML::Exception& error) {
      fail(error.mark, error.msg);
    }
  }

  Mdp build() {
    MdpBuilder builder(vocabulary_);
    State start;
    for (const Model& model : models_) start.push_back(model.initial);
    number(start);
    std::size_t choices = 0;
    for (std::size_t i = 0; i < states_.size(); ++i) {
      const State state = states_[i];
      builder.add_state(name_of(state));
      const ltl::Trace here(std::vector<ltl::Letter>{letter_of(state)});
      for (std::size_t m = 0; m < models_.size(); ++m)
        for (const Edge& edge : models_[m].nodes[state[m]].edges) {
          const Action& action = actions_[edge.action];
          if (!ltl::holds(here, action.guard)) continue;
          State next = state;
          next[m] = edge.to;
          if (++choices > most_choices) throw ltl::FormatError(source_, 0, 0, "expected at most 10,000,000 moves");
          builder.add_choice(action.name, action.weight);
          const LetterId letter = builder.letter(letter_of(next));
          builder.add_outcome(number(next), letter);
        }
    }
    const LetterId first = builder.letter(letter_of(start));
    return std::move(builder).build(0, first);
  }

 private:
  struct Edge {
    std::size_t to, action;
  };
  struct Node {
    std::string name;
    std::vector<Edge> edges;
  };
  struct Model {
    std::vector<Node> nodes;
    std::size_t initial = 0;
  };
  struct Action {
    std::string name;
    double weight;
    ltl::Formula guard;
  };
  using State = std::vector<std::size_t>;  // a node of each model

  [[noreturn]] void fail(const YAML::Mark& mark, std::string_view message) const {
    const bool known = !mark.is_null();
    throw ltl::FormatError(source_, known ? static_cast<std::size_t>(mark.line) + 1 : 0,
                           known ? static_cast<std::size_t>(mark.column) + 1 : 0, message);
  }
  YAML::Node member(const YAML::Node& map, const char* key) const {
    if (!map.IsMap() || !map[key]) fail(map.Mark(), std::string("expected a map with '") + key + "'");
    return map[key];
  }
  YAML::Node map_at(const YAML::Node& map, const char* key) const {
    YAML::Node out = member(map, key);
    if (!out.IsMap()) fail(out.Mark(), std::string("expected a map in '") + key + "'");
    return out;
  }
  std::string text(const YAML::Node& node) const {
    if (!node.IsScalar() || node.Scalar().empty()) fail(node.Mark(), "expected a name");
    return node.Scalar();
  }

  void read() {
    const YAML::Node dimensions = member(document_, "state_dim"), models = map_at(document_, "state_models");
    if (!dimensions.IsSequence() || dimensions.size() == 0) fail(dimensions.Mark(), "expected a list of state models");
    for (const YAML::Node& dimension : dimensions) nodes_of(member(models, text(dimension).c_str()));
    read_actions();
    for (std::size_t m = 0; m < models_.size(); ++m) edges_of(member(models, text(dimensions[m]).c_str()), models_[m]);
  }

  // The nodes of a model, and the start among them.
  void nodes_of(const YAML::Node& yaml) {
    Model model;
    std::optional<std::size_t> initial;
    const std::string first = text(member(yaml, "initial"));
    for (const auto& node : map_at(yaml, "nodes")) {
      if (text(node.first) == first) initial = model.nodes.size();
      model.nodes.push_back({text(node.first), {}});
      vocabulary_.add(model.nodes.back().name);
    }
    if (!initial) fail(member(yaml, "initial").Mark(), "there is no node '" + first + "'");
    model.initial = *initial;
    models_.push_back(std::move(model));
  }

  void read_actions() {
    arena_.emplace(vocabulary_);
    for (const auto& entry : map_at(document_, "actions")) {
      double weight = 0;
      const YAML::Node given = member(entry.second, "weight");
      if (!given.IsScalar() || !YAML::convert<double>::decode(given, weight) || !(weight >= 0) || weight > 1e300)
        fail(given.Mark(), "expected a weight, a number of at least 0");
      const YAML::Node guard = entry.second["guard"];
      actions_.push_back({text(entry.first), weight, guard ? formula(guard) : arena_->constant(true)});
    }
  }
  ltl::Formula formula(const YAML::Node& yaml) const {
    try {
      const ltl::Formula f = ltl::parse(text(yaml), *arena_, {.unknown = ltl::Unknown::Reject});
      if (ltl::fragments(f, ltl::Semantics::Finite).propositional) return f;
    } catch (const ltl::SyntaxError& error) {
      fail(yaml.Mark(), std::string("expected a guard over the names of nodes: ") + error.what());
    }
    fail(yaml.Mark(), "expected a guard without temporal operators");
  }

  void edges_of(const YAML::Node& yaml, Model& model) const {
    std::size_t from = 0;
    for (const auto& node : map_at(yaml, "nodes")) {
      Node& source = model.nodes[from++];
      if (!node.second.IsMap() || !node.second["connected_to"]) continue;  // a node without moves
      for (const auto& edge : node.second["connected_to"])
        source.edges.push_back({place(model.nodes, edge.first, "node"), place(actions_, edge.second, "action")});
    }
  }
  template <class Named>
  std::size_t place(const std::vector<Named>& all, const YAML::Node& yaml, std::string_view kind) const {
    const std::string name = text(yaml);
    for (std::size_t i = 0; i < all.size(); ++i)
      if (all[i].name == name) return i;
    fail(yaml.Mark(), "there is no " + std::string(kind) + " '" + name + "'");
  }

  std::uint32_t number(const State& state) {
    const auto [at, fresh] = numbers_.try_emplace(state, static_cast<std::uint32_t>(states_.size()));
    if (fresh) {
      if (states_.size() == most_states) throw ltl::FormatError(source_, 0, 0, "expected at most 1,000,000 states");
      states_.push_back(state);
    }
    return at->second;
  }
  ltl::Letter letter_of(const State& state) const {
    ltl::Letter out;
    for (std::size_t m = 0; m < models_.size(); ++m) out.insert(*vocabulary_.find(models_[m].nodes[state[m]].name));
    return out;
  }
  std::string name_of(const State& state) const {
    std::string out;
    for (std::size_t m = 0; m < models_.size(); ++m) out += (m == 0 ? "" : ",") + models_[m].nodes[state[m]].name;
    return out;
  }

  std::string source_;
  YAML::Node document_;
  ltl::Vocabulary vocabulary_;
  mutable std::optional<ltl::Arena> arena_;
  std::vector<Model> models_;  // as in state_dim
  std::vector<Action> actions_;
  std::map<State, std::uint32_t> numbers_;
  std::vector<State> states_;
};

}  // namespace

Mdp parse_transition_system(std::string_view yaml, std::string_view source) { return Reader(yaml, source).build(); }

}  // namespace waymark::plan

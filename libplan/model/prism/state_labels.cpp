#include "libplan/model/prism/state_labels.hpp"

#include <algorithm>
#include <unordered_map>

namespace waymark::plan {
namespace {

// The pairs (state, letter it is entered with) that can be reached, numbered as they are met.
struct Entered {
  std::vector<std::uint32_t> state;
  std::vector<LetterId> letter;
  std::unordered_map<std::uint64_t, std::uint32_t> number;

  std::uint32_t operator()(std::uint32_t s, LetterId l) {
    const std::uint64_t key = std::uint64_t{s} << 32U | l.index;
    const auto [at, fresh] = number.try_emplace(key, static_cast<std::uint32_t>(state.size()));
    if (fresh) {
      state.push_back(s);
      letter.push_back(l);
    }
    return at->second;
  }
};

// Outcomes with one target are one outcome.
void add(std::vector<ModelOutcome>& row, const ModelOutcome& outcome) {
  for (ModelOutcome& o : row) {
    if (o.target != outcome.target) continue;
    o.probability = std::min(1.0, o.probability + outcome.probability);
    return;
  }
  row.push_back(outcome);
}

template <class Model>
StateLabelled split(const Model& model) {
  Entered entered{};
  entered(model.initial(), model.initial_letter());
  MdpBuilder builder(model.letters().vocabulary());
  for (std::uint32_t i = 0; i < model.letters().size(); ++i) builder.letter(model.letters()[LetterId{i}]);
  std::vector<ModelOutcome> row;
  for (std::uint32_t i = 0; i < entered.state.size(); ++i) {
    const std::uint32_t s = entered.state[i];
    builder.add_state(model.name(s));
    for (std::uint32_t k = 0; k < model.choices(s); ++k) {
      builder.add_choice(model.action(s, k), model.cost(s, k));
      row.clear();
      model.for_each_outcome(s, k, [&](std::uint32_t target, LetterId letter, double probability) {
        add(row, {entered(target, letter), letter, probability});
      });
      for (const ModelOutcome& o : row) builder.add_outcome(o.target, o.letter, o.probability);
    }
    if (model.choices(s) > 0) continue;
    builder.add_choice("stay", 0);
    builder.add_outcome(i, entered.letter[i]);
  }
  return {std::move(builder).build(0, model.initial_letter()), std::move(entered.letter), std::move(entered.state), {}};
}

void add_values(StateLabelled& labelled, std::size_t states, const StateValues& own) {
  const std::size_t width = own.variables.size();
  std::vector<LetterId> last(states, LetterId{UINT32_MAX});
  bool again = false;  // one state with two letters
  for (std::size_t i = 0; i < labelled.origin.size(); ++i) {
    LetterId& before = last[labelled.origin[i]];
    again = again || before.index != UINT32_MAX;
    before = labelled.letter[i];
  }
  labelled.values.variables = own.variables;
  if (again) labelled.values.variables.emplace_back("letter");
  for (std::size_t i = 0; i < labelled.origin.size(); ++i) {
    for (std::size_t v = 0; v < width; ++v)
      labelled.values.values.push_back(own.values[labelled.origin[i] * width + v]);
    if (again) labelled.values.values.push_back(static_cast<std::int32_t>(labelled.letter[i].index));
  }
}

}  // namespace

StateLabelled with_labels_on_states(const GridWorld& model) {
  StateLabelled out = split(model);
  out.values.variables = {"x", "y"};
  for (std::uint32_t cell : out.origin)
    for (std::uint32_t value : {cell % model.width(), cell / model.width()})
      out.values.values.push_back(static_cast<std::int32_t>(value));
  return out;
}

StateLabelled with_labels_on_states(const Mdp& model, const StateValues& values) {
  StateLabelled out = split(model);
  add_values(out, model.states(), values);
  return out;
}

StateLabelled with_labels_on_states(const Mdp& model) {
  StateValues values{{"s"}, {}};
  for (std::size_t s = 0; s < model.states(); ++s) values.values.push_back(static_cast<std::int32_t>(s));
  return with_labels_on_states(model, values);
}

}  // namespace waymark::plan

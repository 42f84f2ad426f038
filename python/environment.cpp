// The product of a map and an automaton as an environment: what an agent steps in.
//
// An action is one of FORWARD, LEFT, RIGHT, or the jump of that number where the automaton is limit-deterministic. A
// finite task ends with reward 1 when the word may end there; an ongoing task gives reward 1 for every accepting edge.
// A state from which nothing can be accepted any more ends both, without reward.
#include <algorithm>
#include <array>

#include "libplan/model/map_mdp.hpp"
#include "libplan/product/product.hpp"
#include "libplan/product/task_table.hpp"
#include "python/handles.hpp"

namespace waymark::python {
namespace {

class ProductEnvironment {
 public:
  static constexpr std::uint32_t moves = 3;

  ProductEnvironment(std::shared_ptr<plan::Map> map, const automata::Dfa& dfa, const std::string& start,
                     const plan::MapNoise& noise)
      : ProductEnvironment(std::move(map), dfa, start, noise, true) {
    read_starts(dfa, [&](const ltl::Letter& letter) { return std::optional(dfa.next(dfa.initial(), letter)); });
  }
  ProductEnvironment(std::shared_ptr<plan::Map> map, const automata::MdpSafe& ldba, const std::string& start,
                     const plan::MapNoise& noise)
      : ProductEnvironment(std::move(map), ldba, start, noise, false) {
    read_starts(ldba, [&](const ltl::Letter& letter) {
      const auto step = ldba.next(ldba.initial(), letter);
      return step ? std::optional(step->target) : std::nullopt;
    });
  }

  std::uint32_t states() const { return places() * (task_.states() + 1); }  // the last task is the trap
  std::uint32_t actions() const { return moves + most_jumps_; }
  // After the label of each start pose.
  const std::vector<std::uint32_t>& starts() const { return start_states_; }
  bool is_over_in(std::uint32_t state) const {
    const std::uint32_t q = task_of(state);
    return q == task_.states() || task_.is_over(q);
  }

  py::array_t<std::int8_t> mask(std::uint32_t state) const {
    py::array_t<std::int8_t> out(static_cast<py::ssize_t>(actions()));
    for (std::uint32_t a = 0; a < actions(); ++a) out.mutable_at(a) = choice_of(state, a) ? 1 : 0;
    return out;
  }

  // (state, reward, is it over?). `draw` is uniform in [0, 1) and picks the outcome.
  std::tuple<std::uint32_t, double, bool> step(std::uint32_t state, std::uint32_t action, double draw) const {
    const auto choice = choice_of(state, action);
    if (!choice)
      throw py::value_error("action " + std::to_string(action) + " is masked in state " + std::to_string(state));
    const std::uint32_t place = place_of(state), q = task_of(state);
    if (action >= moves) return {state_of(place, task_.jumps(q)[action - moves]), 0, false};
    const auto outcomes = mdp_.outcomes(place, *choice);
    std::size_t i = 0;
    for (; i + 1 < outcomes.size() && draw >= outcomes[i].probability; ++i) draw -= outcomes[i].probability;
    const auto next = task_.next(q, outcomes[i].letter);
    const bool trapped = next.target == plan::TaskTable::trap;
    const bool rewarded = !trapped && (finite_ ? task_.is_goal(next.target) : next.marked);
    return {state_of(outcomes[i].target, next.target), rewarded ? 1 : 0, is_over(next.target)};
  }

  // (x, y, heading), state of the automaton or None in the trap
  py::tuple describe(std::uint32_t state) const {
    const plan::Pose pose = map_->pose({place_of(state)});
    const std::uint32_t q = task_of(state);
    return py::make_tuple(py::make_tuple(pose.x, pose.y, pose.heading),
                          q == task_.states() ? py::object(py::none()) : py::object(py::int_(task_.origin(q))));
  }

 private:
  template <class Automaton>
  ProductEnvironment(std::shared_ptr<plan::Map> map, const Automaton& automaton, const std::string& start,
                     const plan::MapNoise& noise, bool finite)
      : map_(std::move(map)),
        starts_(plan::parse_start(start, *map_)),
        mdp_(plan::mdp_of(*map_, starts_.front(), noise)),
        task_(automaton, mdp_.letters()),
        finite_(finite) {
    for (const ltl::Proposition p : automaton.reads())
      if (!map_->vocabulary().find(automaton.vocabulary().name(p)))
        throw plan::unknown_proposition(*map_, automaton.vocabulary().name(p));
    for (std::uint32_t q = 0; q < task_.states(); ++q)
      most_jumps_ = std::max(most_jumps_, static_cast<std::uint32_t>(task_.jumps(q).size()));
  }

  // `first`: the state of the automaton after the first letter, if there is one.
  template <class Automaton, class First>
  void read_starts(const Automaton& automaton, const First& first) {
    for (const plan::PoseId pose : starts_) {
      const auto letter =
          plan::as_read({map_->label(pose)}, map_->vocabulary(), automaton.vocabulary(), automaton.reads());
      const std::optional<automata::StateId> to = first(letter.front());
      std::uint32_t q = 0;
      while (q < task_.states() && (!to || task_.origin(q) != to->index)) ++q;  // the number of states: the trap
      start_states_.push_back(state_of(pose.index, q));
    }
  }

  std::uint32_t places() const { return static_cast<std::uint32_t>(mdp_.states()); }
  std::uint32_t place_of(std::uint32_t state) const { return state / (task_.states() + 1); }
  std::uint32_t task_of(std::uint32_t state) const { return state % (task_.states() + 1); }
  std::uint32_t state_of(std::uint32_t place, std::uint32_t q) const {
    return place * (task_.states() + 1) + (q == plan::TaskTable::trap ? task_.states() : q);
  }
  bool is_over(std::uint32_t q) const { return q == plan::TaskTable::trap || task_.is_over(q); }

  // Of a move its choice in the model; of a jump any number. Nothing where the action cannot be taken.
  std::optional<std::uint32_t> choice_of(std::uint32_t state, std::uint32_t action) const {
    if (state >= states()) throw py::index_error("there is no state " + std::to_string(state));
    const std::uint32_t place = place_of(state), q = task_of(state);
    if (q == task_.states() || task_.is_over(q)) return std::nullopt;
    if (action >= moves) {
      if (action - moves >= task_.jumps(q).size()) return std::nullopt;
      return 0;
    }
    for (std::uint32_t k = 0; k < mdp_.choices(place); ++k)
      if (mdp_.action(place, k) == plan::name(plan::all_actions[action])) return k;
    return std::nullopt;
  }

  std::shared_ptr<plan::Map> map_;
  std::vector<plan::PoseId> starts_;
  std::vector<std::uint32_t> start_states_;
  plan::Mdp mdp_;
  plan::TaskTable task_;
  bool finite_;
  std::uint32_t most_jumps_ = 0;
};

// slip: chances of FORWARD to go left, right, back; slip_turn: of a turn to fail, to go too far.
template <class Automaton>
void bind_constructor(py::class_<ProductEnvironment>& product) {
  product.def(py::init([](std::shared_ptr<plan::Map> map, const Automaton& automaton, const std::string& start,
                          const std::array<double, 3>& slip, const std::array<double, 2>& slip_turn) {
                const double forward = 1 - slip[0] - slip[1] - slip[2];
                if (*std::min_element(slip.begin(), slip.end()) < 0 || forward < 0)
                  throw py::value_error("the chances to slip are at least 0 and at most 1 in all");
                return ProductEnvironment(std::move(map), automaton, start,
                                          {{forward, slip[0], slip[1], slip[2]}, {slip_turn[0], slip_turn[1]}});
              }),
              py::arg("map"), py::arg("automaton"), py::arg("start"), py::arg("slip") = std::array<double, 3>{},
              py::arg("slip_turn") = std::array<double, 2>{});
}

}  // namespace

void bind_environment(py::module_& m) {
  py::class_<ProductEnvironment> product(m, "Product", "The product of a map and an automaton, to be stepped in.");
  bind_constructor<automata::Dfa>(product);
  bind_constructor<automata::MdpSafe>(product);
  product
      .def_property_readonly("states", &ProductEnvironment::states,
                             "Pairs of pose and task, those of the trap with them.")
      .def_property_readonly("actions", &ProductEnvironment::actions, "FORWARD, LEFT, RIGHT, and the jumps.")
      .def_property_readonly("starts", &ProductEnvironment::starts, "The state after the label of each start pose.")
      .def("is_over", &ProductEnvironment::is_over_in, py::arg("state"), "Does the task end in the state?")
      .def("mask", &ProductEnvironment::mask, py::arg("state"), "By action: 1 where it can be taken.")
      .def("step", &ProductEnvironment::step, py::arg("state"), py::arg("action"), py::arg("draw") = 0.0,
           "(state, reward, whether the task is over); `draw`, uniform in [0, 1), picks the outcome.")
      .def("describe", &ProductEnvironment::describe, py::arg("state"),
           "((x, y, heading), state of the automaton); None in the trap.");
}

}  // namespace waymark::python

#include "libparser/programs/execute.hpp"

#include <algorithm>
#include <bitset>
#include <stdexcept>

namespace waymark::parser {
namespace {

// How many obligations a step can leave pending: one for each thing it does in turn, none where nothing waits.
std::size_t pending_bits(const Step& step) {
  if (step.kind == StepKind::Stay || operands(step.kind) > 0) return 0;
  if (step.kind == StepKind::Forward) return step.count;
  return step.kind == StepKind::Past ? 2 : step.times();
}

constexpr std::size_t most_bits = 1024;

std::size_t most_pending(const Program& program) {
  std::size_t bits = 0;
  for (const Step& step : program) bits += pending_bits(step);
  if (bits > most_bits) throw std::length_error("a program with more than 1,024 pending obligations");
  return bits;
}

// The automaton of a program. A set bit is an obligation that the next letter is read with.
template <std::size_t N>
class Progress {
 public:
  using Set = std::bitset<N>;

  Progress(const Executor& executor, const Program& program) : executor_(executor), program_(program) {
    for (const Step& step : program) {
      first_bit_.push_back(bits_);
      bits_ += pending_bits(step);
    }
    after_.resize(program.size());
    guard_.resize(program.size(), nullptr);
    for (std::size_t i = 0; i < program.size();) {
      const std::size_t end = unit_end(program, i);
      lay_out(i, end, nullptr);
      i = end;
    }
  }

  // Reads the letter of `arrival` with these obligations; true when nothing need remain.
  bool read(const Set& pending, Arrival arrival, Set& rest) const {
    bool done = false;
    for (std::size_t i = 0; i < program_.size(); ++i)
      for (std::size_t k = 0; k < pending_bits(program_[i]); ++k)
        if (pending[first_bit_[i] + k]) done = read_one(i, k, arrival, rest) || done;
    return done;
  }

  // Step i is owed from this letter on.
  bool enter(std::size_t i, Arrival arrival, Set& rest) const {
    if (i == program_.size()) return true;
    const Step& step = program_[i];
    switch (step.kind) {
      case StepKind::Stay: return enter(after_[i], arrival, rest);
      case StepKind::Without:
      case StepKind::Keep: return enter(i + 1, arrival, rest);
      case StepKind::When: return enter(holds(step, arrival) ? i + 1 : after_[i], arrival, rest);
      case StepKind::Whether: return enter(holds(step, arrival) ? i + 1 : unit_end(program_, i + 1), arrival, rest);
      default: break;
    }
    if (rest[first_bit_[i]]) return false;  // it has been entered before
    if (may_wait(i, arrival)) rest.set(first_bit_[i]);
    if (step.kind == StepKind::Orient) return enter(after_[i], arrival, rest);
    return step.kind == StepKind::Reach && holds(step, arrival) && enter(after_[i], arrival, rest);
  }

 private:
  void lay_out(std::size_t i, std::size_t after, const Step* guard) {
    const Step& step = program_[i];
    after_[i] = after;
    guard_[i] = guard;
    if (step.kind == StepKind::Without || step.kind == StepKind::Keep) guard = &step;
    std::size_t operand = i + 1;
    for (std::size_t k = 0; k < operands(step.kind); ++k) {
      lay_out(operand, after, guard);
      operand = unit_end(program_, operand);
    }
  }

  bool holds(const Step& step, Arrival arrival) const {
    for (std::uint16_t p : step.literals())
      if (!executor_.holds(p, arrival)) return false;
    return true;
  }

  // Does this letter leave step i what it keeps or does without?
  bool may_wait(std::size_t i, Arrival arrival) const {
    return guard_[i] == nullptr || holds(*guard_[i], arrival) == (guard_[i]->kind == StepKind::Keep);
  }

  // Reads the letter with obligation k of step i.
  bool read_one(std::size_t i, std::size_t k, Arrival arrival, Set& rest) const {
    const Step& step = program_[i];
    const std::size_t bit = first_bit_[i] + k;
    const bool is_last = k + 1 == pending_bits(step);
    const auto done = [&] { return enter(after_[i], arrival, rest); };
    const auto wait = [&](std::size_t b) {
      if (may_wait(i, arrival)) rest.set(b);
      return false;
    };
    switch (step.kind) {
      case StepKind::Reach: return enter(i, arrival, rest);
      case StepKind::Next: return holds(step, arrival) && done();
      case StepKind::Forward:
        if (!arrival.is_move()) return false;
        return is_last ? done() : wait(bit + 1);
      case StepKind::Past:
        if (is_last) return arrival.is_move() && done();
        [[fallthrough]];
      case StepKind::Advance:
        if (!arrival.is_move()) return false;
        wait(bit);
        if (!holds(step, arrival)) return false;
        return is_last ? done() : wait(bit + 1);
      case StepKind::Orient:
      case StepKind::Face:
        if (!arrival.is_turn()) return false;
        wait(bit);
        return holds(step, arrival) && done();
      case StepKind::Stay:
      case StepKind::Without:
      case StepKind::Keep:
      case StepKind::When:
      case StepKind::Whether: break;
    }
    throw std::logic_error("a step that leaves nothing pending");
  }

  const Executor& executor_;
  const Program& program_;
  std::vector<std::size_t> first_bit_;
  std::vector<std::size_t> after_;  // by step: the one that is owed when it is done
  std::vector<const Step*> guard_;  // by step: what holds until it is done, `without` or `keep`
  std::size_t bits_ = 0;
};

template <std::size_t N>
struct SearchNode {
  Arrival arrival;
  std::int32_t from;
  std::bitset<N> pending;
};

template <class Nodes>
Plan plan_to(const Nodes& nodes, std::int32_t from, Arrival arrival) {
  Plan plan{arrival.pose(), {}};
  const auto push = [&](Arrival at) {
    if (!at.is_start()) plan.actions.push_back(at.action());
  };
  push(arrival);
  for (; from >= 0; from = nodes[static_cast<std::size_t>(from)].from)
    push(nodes[static_cast<std::size_t>(from)].arrival);
  std::reverse(plan.actions.begin(), plan.actions.end());
  return plan;
}

}  // namespace

Executor::Executor(const plan::Map& map) : map_(&map) {
  const std::size_t arrivals = 4 * map.poses();
  columns_.assign(map.vocabulary().size(), std::vector<std::uint64_t>(arrivals / 64 + 1));
  successors_.resize(map.poses());
  const auto set = [&](const ltl::Letter& letter, Arrival arrival) {
    for (ltl::Proposition p : letter.members())
      columns_[p.index][arrival.index / 64] |= std::uint64_t{1} << (arrival.index % 64);
  };
  for (std::uint32_t s = 0; s < map.poses(); ++s) {
    set(map.label({s}), Arrival::start({s}));
    for (plan::Action a : plan::all_actions) {
      set(map.letter({s}, a), Arrival::of({s}, a));
      const auto t = map.successor({s}, a);
      successors_[s][static_cast<std::size_t>(a)] = t ? static_cast<std::int32_t>(t->index) : -1;
    }
  }
}

template <std::size_t N>
std::optional<Plan> Executor::search(const Program& program, plan::PoseId start) const {
  const Progress<N> progress(*this, program);
  std::vector<SearchNode<N>> queue;
  std::vector<std::bitset<N>> seen(4 * map_->poses());

  const Arrival first = Arrival::start(start);
  std::bitset<N> pending;
  if (progress.enter(0, first, pending)) return plan_to(queue, -1, first);
  queue.push_back({first, -1, pending});
  for (std::size_t head = 0; head < queue.size(); ++head) {
    const SearchNode<N> node = queue[head];
    for (plan::Action a : plan::all_actions) {
      const std::int32_t next = successors_[node.arrival.pose().index][static_cast<std::size_t>(a)];
      if (next < 0) continue;
      const Arrival arrival = Arrival::of({static_cast<std::uint32_t>(next)}, a);
      std::bitset<N> rest;
      if (progress.read(node.pending, arrival, rest)) {
        // The first in breadth-first order is the least word only if no other word of this length is less; words of
        // one length leave the queue in order, so it is.
        return plan_to(queue, static_cast<std::int32_t>(head), arrival);
      }
      rest &= ~seen[arrival.index];
      if (rest.none()) continue;
      seen[arrival.index] |= rest;
      queue.push_back({arrival, static_cast<std::int32_t>(head), rest});
    }
  }
  return std::nullopt;
}

std::optional<Plan> Executor::run(const Program& program, plan::PoseId start, Then then) const {
  if (then == Then::Stepwise) {
    Plan whole{start, {}};
    for (std::size_t i = 0; i < program.size();) {
      const std::size_t begin = i;
      while (program[i].kind == StepKind::Orient && i + 1 < program.size()) ++i;
      i = unit_end(program, i);
      const Program unit(program.begin() + static_cast<std::ptrdiff_t>(begin),
                         program.begin() + static_cast<std::ptrdiff_t>(i));
      const auto part = run(unit, whole.end);
      if (!part) return std::nullopt;
      whole.end = part->end;
      whole.actions.insert(whole.actions.end(), part->actions.begin(), part->actions.end());
    }
    return whole;
  }
  return most_pending(program) <= 64 ? search<64>(program, start) : search<most_bits>(program, start);
}

// Every program is co-safe: once nothing need remain, whatever follows is allowed.
template <std::size_t N>
bool Executor::progresses(const plan::Trajectory& trajectory, const Program& program) const {
  const Progress<N> progress(*this, program);
  std::bitset<N> pending;
  if (progress.enter(0, Arrival::start(trajectory.poses.front()), pending)) return true;
  for (std::size_t i = 0; i < trajectory.actions.size() && pending.any(); ++i) {
    std::bitset<N> rest;
    if (progress.read(pending, Arrival::of(trajectory.poses[i + 1], trajectory.actions[i]), rest)) return true;
    pending = rest;
  }
  return false;
}

bool Executor::satisfies(const plan::Trajectory& trajectory, const Program& program) const {
  return most_pending(program) <= 64 ? progresses<64>(trajectory, program) : progresses<most_bits>(trajectory, program);
}

std::vector<Executor::Reached> Executor::horizon(StepKind kind, plan::PoseId start, bool oriented) const {
  std::vector<Reached> order{{Arrival::start(start), -1, kind == StepKind::Reach}};
  std::vector<bool> seen(4 * map_->poses(), false);
  for (std::size_t head = 0; head < order.size(); ++head) {
    if (kind == StepKind::Next && head > 0) break;
    for (plan::Action a : plan::all_actions) {
      const bool turn = a != plan::Action::Forward;
      if (kind == StepKind::Advance && turn && !(oriented && !order[head].arrival.is_move())) continue;
      if (kind == StepKind::Face && !turn) continue;
      const std::int32_t next = successors_[order[head].arrival.pose().index][static_cast<std::size_t>(a)];
      if (next < 0) continue;
      const Arrival arrival = Arrival::of({static_cast<std::uint32_t>(next)}, a);
      if (seen[arrival.index]) continue;
      seen[arrival.index] = true;
      order.push_back({arrival, static_cast<std::int32_t>(head), kind != StepKind::Advance || !turn});
    }
  }
  return order;
}

}  // namespace waymark::parser

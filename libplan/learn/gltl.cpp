#include "libplan/learn/gltl.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>
#include <unordered_map>

#include "libltl/rewriting/nnf.hpp"

namespace waymark::plan {
namespace {

// A monotone function of pending subformulas: its minimal sets, sorted. {} is false, {∅} is true.
using Pending = std::vector<std::uint64_t>;

Pending minimal(Pending sets) {
  std::sort(sets.begin(), sets.end());
  sets.erase(std::unique(sets.begin(), sets.end()), sets.end());
  Pending kept;
  for (const std::uint64_t set : sets)
    if (std::none_of(sets.begin(), sets.end(),
                     [&](std::uint64_t other) { return other != set && (other & set) == other; }))
      kept.push_back(set);
  return kept;
}
Pending either(Pending a, const Pending& b) {
  a.insert(a.end(), b.begin(), b.end());
  return minimal(std::move(a));
}
Pending both(const Pending& a, const Pending& b) {
  Pending sets;
  for (const std::uint64_t x : a)
    for (const std::uint64_t y : b) sets.push_back(x | y);
  return minimal(std::move(sets));
}
Pending constant(bool value) { return value ? Pending{0} : Pending{}; }

class Progression {
 public:
  explicit Progression(ltl::Formula phi) {
    for (const ltl::Formula f : ltl::subformulas(phi)) {
      if (f.op() == ltl::Op::And || f.op() == ltl::Op::Or) continue;
      place_.emplace(f, pending_.size());
      pending_.push_back(f);
      if (f.op() == ltl::Op::Until || f.op() == ltl::Op::Release) coin_.emplace(f, coin_.size());
    }
  }

  std::size_t coins() const { return coin_.size(); }
  bool fits(const Gltl& limits) const { return coins() <= limits.most_coins && pending_.size() <= 64; }
  // f is still to be read.
  Pending owed(ltl::Formula f) const {
    if (f.op() == ltl::Op::And || f.op() == ltl::Op::Or)
      return junction(f, [this](ltl::Formula g) { return owed(g); });
    return {std::uint64_t{1} << place_.at(f)};
  }
  // What is owed after a letter; coins: bit set, the operator of that coin has not expired.
  Pending after(const Pending& state, const ltl::Letter& letter, std::uint64_t coins) const {
    Pending result;
    for (const std::uint64_t set : state) {
      Pending all = constant(true);
      for (std::size_t i = 0; i < pending_.size(); ++i)
        if (((set >> i) & 1U) != 0) all = both(all, read(pending_[i], letter, coins));
      result = either(std::move(result), all);
    }
    return result;
  }

 private:
  template <class Part>
  Pending junction(ltl::Formula f, Part&& part) const {
    Pending result = constant(f.op() == ltl::Op::And);
    for (const ltl::Formula g : f.operands())
      result = f.op() == ltl::Op::And ? both(result, part(g)) : either(std::move(result), part(g));
    return result;
  }

  Pending read(ltl::Formula f, const ltl::Letter& letter, std::uint64_t coins) const {
    const auto now = [&](ltl::Formula g) { return read(g, letter, coins); };
    switch (f.op()) {
      case ltl::Op::False: return constant(false);
      case ltl::Op::True: return constant(true);
      case ltl::Op::Atom: return constant(letter.contains(f.proposition()));
      case ltl::Op::Not: return constant(!letter.contains(f[0].proposition()));
      case ltl::Op::And:
      case ltl::Op::Or: return junction(f, now);
      case ltl::Op::Next:
      case ltl::Op::WeakNext: return owed(f[0]);
      case ltl::Op::Until:
        return either(now(f[1]), both(now(f[0]), kept(f, coins) ? owed(f) : constant(false)));
      case ltl::Op::Release:
        return both(now(f[1]), either(now(f[0]), kept(f, coins) ? owed(f) : constant(true)));
      case ltl::Op::Iff: break;  // not in negation normal form
    }
    throw std::logic_error("not in negation normal form");
  }
  bool kept(ltl::Formula f, std::uint64_t coins) const { return ((coins >> coin_.at(f)) & 1U) != 0; }

  std::vector<ltl::Formula> pending_;
  std::unordered_map<ltl::Formula, std::size_t> place_, coin_;
};

// Fewest letters to acceptance, backwards from it.
std::vector<std::uint32_t> distances(const TaskRows& table) {
  std::vector<std::uint32_t> distance(table.tasks, TaskRows::unreachable);
  for (std::uint32_t q = 0; q < table.tasks; ++q)
    if (table.ending[q] == Ending::Accepting) distance[q] = 0;
  for (bool changed = true; changed;) {
    changed = false;
    for (std::uint32_t q = 0; q < table.tasks; ++q)
      for (std::uint32_t letter = 0; letter < table.letters; ++letter) {
        const std::uint32_t next = distance[table.after(q, letter)];
        if (next == TaskRows::unreachable || next + 1 >= distance[q]) continue;
        distance[q] = next + 1;
        changed = true;
      }
  }
  return distance;
}

}  // namespace

std::optional<TaskRows> gltl_tasks(ltl::Formula phi, const Letters& letters, const Gltl& options) {
  const ltl::Formula f = ltl::nnf(phi);
  const LetterProjection classes(letters, f.arena().vocabulary(), ltl::propositions(f));
  const Progression progression(f);
  if (!progression.fits(options)) return std::nullopt;
  const std::uint64_t patterns = std::uint64_t{1} << progression.coins();
  TaskRows table;
  table.letters = static_cast<std::uint32_t>(classes.carried.size() * patterns);
  table.vocabulary = f.arena().vocabulary();
  for (const ltl::Letter& letter : classes.carried)
    for (std::uint64_t coins = 0; coins < patterns; ++coins) table.carried.push_back(letter);
  for (const std::uint32_t letter : classes.of) {
    auto& readings = table.readings.emplace_back();
    for (std::uint64_t coins = 0; coins < patterns; ++coins) {
      double probability = 1;
      for (std::size_t i = 0; i < progression.coins(); ++i)
        probability *= ((coins >> i) & 1U) != 0 ? options.keep : 1 - options.keep;
      if (probability > 0)
        readings.push_back({static_cast<std::uint32_t>(letter * patterns + coins), probability});
    }
  }
  std::map<Pending, std::uint32_t> number{{progression.owed(f), 0}};
  std::vector<Pending> states{progression.owed(f)};
  for (std::size_t i = 0; i < states.size(); ++i) {  // grows while we look
    table.ending.push_back(states[i] == constant(true)    ? Ending::Accepting
                           : states[i] == constant(false) ? Ending::Trap
                                                          : Ending::Open);
    for (std::uint32_t letter = 0; letter < table.letters; ++letter) {
      Pending next = progression.after(states[i], table.carried[letter], letter % patterns);
      const auto [it, is_new] = number.try_emplace(next, static_cast<std::uint32_t>(states.size()));
      if (is_new) states.push_back(std::move(next));
      if (states.size() > options.most_states) return std::nullopt;
      table.next.push_back(it->second);
    }
  }
  table.tasks = static_cast<std::uint32_t>(states.size());
  table.distance = distances(table);
  return table;
}

TaskRows without_expiry(TaskRows table) {
  for (auto& readings : table.readings) {
    const TaskRows::Reading all_kept{readings.back().letter,
                                     1};  // the last pattern: every coin has its bit set
    readings.assign(1, all_kept);
  }
  return table;
}

}  // namespace waymark::plan

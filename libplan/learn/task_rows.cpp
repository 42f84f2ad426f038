#include "libplan/learn/task_rows.hpp"

#include <map>
#include <optional>
#include <string>

#include "libltl/diagnostic.hpp"

namespace waymark::plan {
namespace {

ltl::FormatError unknown(const ltl::Vocabulary& model, const std::string& name) {
  const auto nearest = model.nearest(name);
  return ltl::FormatError(
      "", 0, 0,
      "the model has no proposition '" + name + "'" + (nearest ? " (did you mean '" + *nearest + "'?)" : ""));
}

}  // namespace

LetterProjection::LetterProjection(const Letters& letters, const ltl::Vocabulary& task,
                                   const std::vector<ltl::Proposition>& reads) {
  std::vector<ltl::Proposition> ours;
  for (const ltl::Proposition p : reads) {
    const auto found = letters.vocabulary().find(task.name(p));
    if (!found) throw unknown(letters.vocabulary(), task.name(p));
    ours.push_back(*found);
  }
  Letters classes(task);
  for (std::uint32_t i = 0; i < letters.size(); ++i) {
    ltl::Letter read;
    for (std::size_t k = 0; k < reads.size(); ++k)
      if (letters[LetterId{i}].contains(ours[k])) read.insert(reads[k]);
    of.push_back(classes.intern(read).index);
    if (of.back() == carried.size()) carried.push_back(read);
  }
}

TaskRows tabulate(const automata::Dfa& dfa, const Letters& letters) {
  LetterProjection classes(letters, dfa.vocabulary(), dfa.reads());
  TaskRows table;
  table.tasks = static_cast<std::uint32_t>(dfa.states());
  table.letters = static_cast<std::uint32_t>(classes.carried.size());
  table.initial = dfa.initial().index;
  for (std::uint32_t q = 0; q < table.tasks; ++q) {
    const automata::StateId state{q};
    for (const ltl::Letter& letter : classes.carried) table.next.push_back(dfa.next(state, letter).index);
    table.ending.push_back(dfa.is_accepting(state) ? Ending::Accepting
                           : dfa.is_trap(state)    ? Ending::Trap
                                                   : Ending::Open);
    table.distance.push_back(dfa.distance_to_acceptance(state));
  }
  for (const std::uint32_t letter : classes.of) table.readings.push_back({{letter, 1.0}});
  table.vocabulary = dfa.vocabulary();
  table.carried = std::move(classes.carried);
  return table;
}

}  // namespace waymark::plan

#include "libparser/domain/commands/command_reader.hpp"

#include <algorithm>
#include <cmath>

#include "libautomata/omega/containment.hpp"

namespace waymark::parser {

bool same_language(ltl::Formula a, ltl::Formula b, std::size_t steps) {
  if (a == b) return true;
  std::vector<ltl::Proposition> reads = ltl::propositions(a);
  for (const ltl::Proposition p : ltl::propositions(b))
    if (std::find(reads.begin(), reads.end(), p) == reads.end()) reads.push_back(p);
  automata::Budget budget(20 * steps, steps, {});
  automata::Containment contained(reads, budget);
  return contained(a, b) && contained(b, a);
}

namespace {

void vote(std::vector<CommandReading>& all, const CommandReading& reading) {
  const auto same =
      std::find_if(all.begin(), all.end(), [&](const CommandReading& r) { return r.formula == reading.formula; });
  if (same == all.end())
    all.push_back(reading);
  else
    same->probability += reading.probability;
}

void sort(std::vector<CommandReading>& all) {
  std::stable_sort(all.begin(), all.end(),
                   [](const CommandReading& a, const CommandReading& b) { return a.probability > b.probability; });
}

}  // namespace

CommandReadings read_lifts(const LiftedReader& reader, std::span<const BoundLift> lifts,
                           const ReadCommandOptions& options) {
  CommandReadings out;
  double heaviest = 0;
  for (const BoundLift& lift : lifts) {
    double command = 0;
    for (const LiftedReading& r : reader.read(lift.text, options.beam))
      if (r.lifted.front() != LiftedSymbol::Route && r.lifted.front() != LiftedSymbol::Nothing)
        if (const auto formula = formula_of(r.lifted, lift.bindings)) {
          vote(out.readings, {*formula, lift.probability * std::exp(r.log_probability)});
          command += std::exp(r.log_probability);
        }
    if (lift.probability * command <= heaviest) continue;
    heaviest = lift.probability * command;
    out.understood = command;
  }
  sort(out.readings);
  for (std::size_t i = 1; i < std::min(out.readings.size(), options.compared); ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (out.readings[i].probability > 0 && same_language(out.readings[j].formula, out.readings[i].formula)) {
        out.readings[j].probability += out.readings[i].probability;
        out.readings[i].probability = 0;
      }
  std::erase_if(out.readings, [](const CommandReading& r) { return r.probability <= 0; });
  sort(out.readings);
  double total = 0;
  for (const CommandReading& r : out.readings) total += r.probability;
  for (CommandReading& r : out.readings) r.probability /= total;
  return out;
}

CommandReadings read_command(const LiftedReader& reader, const CommandDomain& domain, const std::string& text,
                             ltl::Arena& arena, const ReadCommandOptions& options) {
  std::vector<BoundLift> lifts;
  for (CommandDomain::Lift& lift : domain.lift(text, reader.mentions())) {
    if (!options.names_domain) lift.text.domain.clear();
    lifts.push_back({std::move(lift.text), lift.probability, domain.bindings(arena, lift.slots)});
  }
  return read_lifts(reader, lifts, options);
}

}  // namespace waymark::parser

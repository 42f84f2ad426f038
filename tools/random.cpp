// waymark random: formulas or automata drawn at random; the same seed gives the same ones on every machine.
#include <charconv>
#include <iostream>
#include <memory>
#include <unordered_set>

#include "libautomata/hoa/omega.hpp"
#include "libautomata/omega/random_automaton.hpp"
#include "libltl/structure/random.hpp"
#include "libltl/text/print.hpp"
#include "tools/shell/json.hpp"
#include "tools/shell/subcommand.hpp"

namespace waymark::tools {
namespace {

struct RandomOptions {
  std::size_t props = 4, count = 1;
  std::string size = "15..30", semantics = "infinite";
  std::uint64_t seed = 1;
  bool automata = false, deterministic = false, json = false;
  std::uint32_t states = 5, sets = 1;
};

struct Sizes {
  std::size_t least = 0, most = 0;
};

std::size_t number_of(std::string_view text) {
  std::size_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || value < 1 || value > 1'000'000)
    throw UsageError("--size takes a number of nodes from 1 to 1000000, or two as 15..30, not '" + std::string(text) +
                     "'");
  return value;
}

Sizes sizes_of(std::string_view text) {
  const std::size_t dots = text.find("..");
  if (dots == std::string_view::npos) return {number_of(text), number_of(text)};
  const Sizes sizes{number_of(text.substr(0, dots)), number_of(text.substr(dots + 2))};
  if (sizes.least > sizes.most) throw UsageError("--size: the first number is the smaller one");
  return sizes;
}

std::vector<std::string> names_of(const RandomOptions& options) {
  std::vector<std::string> names;
  for (std::size_t p = 0; p < options.props; ++p) names.push_back("p" + std::to_string(p));
  return names;
}

// In HOA, one a line; any condition over the sets that there are.
ExitCode run_random_automata(const RandomOptions& options, const Session& session) {
  if (options.props > 16) throw UsageError("random automata read at most 16 propositions");
  const ltl::Vocabulary vocabulary(names_of(options));
  ltl::Random random(options.seed);
  for (std::size_t i = 0; i < options.count; ++i) {
    if (session.stop.stop_requested()) throw Interrupted();
    const automata::Automaton automaton =
        automata::random_automaton(random, vocabulary,
                                   {.states = options.states,
                                    .atoms = options.props,
                                    .sets = options.sets,
                                    .branches = options.deterministic ? std::size_t{1} : std::size_t{2}});
    const std::string hoa = automata::write_hoa(automaton, {.layout = {.one_line = true}});
    std::cout << (options.json ? JsonObject().add("hoa", hoa).text() + '\n' : hoa);
  }
  return ExitCode::Done;
}

// Different formulas, none a constant: drawing goes on until there are enough, or new ones stay away.
ExitCode run_random(const RandomOptions& options, const Session& session) {
  const Sizes sizes = sizes_of(options.size);
  const std::vector<std::string> names = names_of(options);
  ltl::Random random(options.seed);
  std::unordered_set<std::string> drawn;
  constexpr std::size_t patience = 10'000;
  std::size_t in_vain = 0;
  while (drawn.size() < options.count) {
    if (session.stop.stop_requested()) throw Interrupted();
    ltl::Arena arena{ltl::Vocabulary(names)};
    const ltl::Formula f = ltl::random_formula(random, arena,
                                               {.size = sizes.least + random.below(sizes.most - sizes.least + 1),
                                                .atoms = options.props,
                                                .constants = false,
                                                .weak_next = options.semantics == "finite"});
    const bool constant = ltl::propositions(f).empty();
    const std::string text = ltl::print(f);
    if (constant || !drawn.insert(text).second) {
      if (++in_vain == patience)
        throw GaveUp("only " + std::to_string(drawn.size()) + " different formulas were found");
      continue;
    }
    in_vain = 0;
    std::cout << (options.json ? JsonObject().add("formula", text).text() : text) << '\n';
  }
  return ExitCode::Done;
}

}  // namespace

Runner setup_random(Command command) {
  const auto options = std::make_shared<RandomOptions>();
  command.add_option("--props", options->props, "propositions p0, p1, … (of automata: at most 16)")
      .type_name("N")
      .between(1, 1'000)
      .show_default();
  command.add_option("--size", options->size, "nodes of the formula as drawn, before constants are folded")
      .type_name("N..M")
      .show_default();
  command.add_option("--count", options->count, "how many different formulas").type_name("N").show_default();
  command.add_option("--seed", options->seed, "where the drawing begins").type_name("N").show_default();
  command.add_option("--semantics", options->semantics, "finite: the weak next N occurs as well")
      .one_of({"finite", "infinite"})
      .show_default();
  command.add_flag("--automata", options->automata, "automata on infinite words in the place of formulas");
  command.add_option("--states", options->states, "of automata, at most: what is not reached is dropped")
      .type_name("N")
      .between(1, 100'000)
      .show_default();
  command.add_option("--sets", options->sets, "acceptance sets of automata")
      .type_name("N")
      .between(0, 64)
      .show_default();
  command.add_flag("--deterministic", options->deterministic, "automata with at most one edge for each letter");
  command.add_flag("--json", options->json, "one JSON object a line");
  return [options](const Session& session) {
    return options->automata ? run_random_automata(*options, session) : run_random(*options, session);
  };
}

}  // namespace waymark::tools

// waymark random: formulas drawn at random, one a line; the same seed gives the same lines on every machine.
#include <CLI/App.hpp>
#include <charconv>
#include <iostream>
#include <memory>
#include <unordered_set>

#include "libltl/print.hpp"
#include "libltl/random.hpp"
#include "tools/subcommand.hpp"

namespace waymark::tools {
namespace {

struct Options {
  std::size_t props = 4, count = 1;
  std::string size = "15..30", semantics = "infinite";
  std::uint64_t seed = 1;
};

struct Sizes {
  std::size_t least = 0, most = 0;
};

std::size_t size_of(std::string_view text) {
  std::size_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || value < 1 || value > 1'000'000)
    throw UsageError("--size takes a number of nodes from 1 to 1000000, or two as 15..30, not '" +
                     std::string(text) + "'");
  return value;
}

Sizes sizes_of(std::string_view text) {
  const std::size_t dots = text.find("..");
  if (dots == std::string_view::npos) return {size_of(text), size_of(text)};
  const Sizes sizes{size_of(text.substr(0, dots)), size_of(text.substr(dots + 2))};
  if (sizes.least > sizes.most) throw UsageError("--size: the first number is the smaller one");
  return sizes;
}

// Different formulas, none a constant: drawing goes on until there are enough, or new ones stay away.
ExitCode run_random(const Options& options, const Session& session) {
  const Sizes sizes = sizes_of(options.size);
  std::vector<std::string> names;
  for (std::size_t p = 0; p < options.props; ++p) names.push_back("p" + std::to_string(p));
  ltl::Random random(options.seed);
  std::unordered_set<std::string> drawn;
  constexpr std::size_t patience = 10'000;
  std::size_t in_vain = 0;
  while (drawn.size() < options.count) {
    if (session.stop.stop_requested()) throw Interrupted();
    ltl::Arena arena{ltl::Vocabulary(names)};
    const ltl::Formula f =
        ltl::random_formula(random, arena,
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
    std::cout << text << '\n';
  }
  return ExitCode::Done;
}

}  // namespace

Runner setup_random(CLI::App& command) {
  const auto options = std::make_shared<Options>();
  command.add_option("--props", options->props, "propositions p0, p1, …")
      ->type_name("N")
      ->check(CLI::Range(1, 1'000))
      ->capture_default_str();
  command.add_option("--size", options->size, "nodes of the formula as drawn, before constants are folded")
      ->type_name("N..M")
      ->capture_default_str();
  command.add_option("--count", options->count, "how many different formulas")
      ->type_name("N")
      ->capture_default_str();
  command.add_option("--seed", options->seed, "where the drawing begins")
      ->type_name("N")
      ->capture_default_str();
  command.add_option("--semantics", options->semantics, "finite: the weak next N occurs as well")
      ->check(CLI::IsMember({"finite", "infinite"}))
      ->capture_default_str();
  return [options](const Session& session) { return run_random(*options, session); };
}

}  // namespace waymark::tools

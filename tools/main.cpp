// waymark: from an English route instruction to a certified route, one subcommand per stage.
//
// Parses the command line, runs one subcommand, and turns what comes out into an exit code (docs/cli.md): a value, or
// one message on standard error for an input that is wrong. Nothing is caught on the way to here.
#include <unistd.h>

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <array>
#include <exception>
#include <iostream>
#include <new>

#include "libltl/diagnostic.hpp"
#include "libltl/vocabulary.hpp"
#include "tools/shell/interrupt.hpp"
#include "tools/shell/subcommand.hpp"

namespace waymark::tools {
namespace {

struct Row {
  const char* name;
  const char* summary;
  Runner (*setup)(Command);
};

constexpr std::array rows{
    Row{"run", "walk the whole corridor: instruction, formula, automaton, product, certified route",
        setup_run},
    Row{"ground", "instruction → formulas, best first", setup_ground},
    Row{"translate", "formula → automaton", setup_translate},
    Row{"automaton", "automata of HOA files → operations, questions, other formats", setup_automaton},
    Row{"compose", "formula or automaton, and a map → their product", setup_compose},
    Row{"plan", "formula or automaton, and a map → a certified route of least cost", setup_plan},
    Row{"check", "does this trajectory satisfy this formula?", setup_check},
    Row{"move", "formula and a map → a certified motion of a robot with a body", setup_move},
    Row{"compare", "exact search, value iteration and learners on one task, side by side", setup_compare},
    Row{"train", "corpus → model", setup_train},
    Row{"evaluate", "corpus → accuracy, leaving one map out", setup_evaluate},
    Row{"experiment", "a whole table of results, which goes on where it was stopped", setup_experiment},
    Row{"tune", "which settings of training validate best", setup_tune},
    Row{"import", "a corpus as it was released → ours", setup_import},
    Row{"corpus", "how large a corpus is, in texts and trajectories", setup_corpus},
    Row{"draw", "map, with or without a route → picture", setup_draw},
    Row{"generate", "random maps to plan on", setup_generate},
    Row{"patterns", "specification patterns by name → formula", setup_patterns},
    Row{"random", "random formulas", setup_random},
    Row{"version", "version, build, and what it was built with", setup_version},
};

// Every subcommand is known by name; only the one that is called gets its options, which take longer to set up than
// a small formula to translate.
struct Called {
  CLI::App* command = nullptr;
  Runner runner;
};

Called add_subcommands(CLI::App& app, std::string_view called) {
  Called found;
  for (const Row& row : rows) {
    CLI::App* command = app.add_subcommand(row.name, row.summary);
    if (called == row.name) found = {command, row.setup(Command(*command))};
  }
  return found;
}

// A first argument that is neither an option nor a subcommand: most likely a slip of the fingers.
void reject_unknown_subcommand(int argc, char** argv) {
  if (argc < 2) throw UsageError("no subcommand given; see waymark --help");
  if (argv[1][0] == '-') return;
  ltl::Vocabulary known;
  for (const Row& row : rows) known.add(row.name);
  const std::string_view given = argv[1];
  if (given.empty()) throw UsageError("the name of the subcommand is empty; see waymark --help");
  if (known.find(given)) return;
  const auto nearest = known.nearest(given);
  throw UsageError("there is no subcommand '" + std::string(given) + "'" +
                   (nearest ? " (did you mean '" + *nearest + "'?)" : "; see waymark --help"));
}

ExitCode parse_and_run(int argc, char** argv) {
  reject_unknown_subcommand(argc, argv);
  CLI::App app{"waymark: English route instructions → LTL → automata → certified routes"};
  app.require_subcommand(1);
  app.get_formatter()->column_width(34);
  const Called called = add_subcommands(app, argv[1]);
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& help) {  // --help
    app.exit(help, std::cout, std::cerr);
    return ExitCode::Done;
  } catch (const CLI::ParseError& error) {
    throw UsageError(error.what() + std::string("; see waymark ") +
                     (called.command != nullptr ? called.command->get_name() + " " : "") + "--help");
  }
  if (!called.runner) throw UsageError("the subcommand comes first; see waymark --help");
  const Interrupt interrupt;
  const ExitCode code = called.runner({.stop = interrupt.token(), .out = terminal_of(STDOUT_FILENO)});
  std::cout.flush();
  if (!std::cout) throw ltl::FormatError("standard output", 0, 0, "cannot be written");
  return code;
}

ExitCode guarded_main(int argc, char** argv) {
  try {
    return parse_and_run(argc, argv);
  } catch (const UsageError& error) {
    complain("error", error.what());
    return ExitCode::Usage;
  } catch (const ltl::SyntaxError& error) {
    complain("error", error.what());
    return ExitCode::BadInput;
  } catch (const ltl::FormatError& error) {
    complain("error", error.what());
    return ExitCode::BadInput;
  } catch (const GaveUp& error) {
    complain("error", error.what());
    return ExitCode::GaveUp;
  } catch (const std::bad_alloc&) {
    complain("error", "out of memory");
    return ExitCode::GaveUp;
  } catch (
      const std::exception& error) {  // an assertion of ours that did not hold: said so, never passed over
    complain("error", std::string("this is a bug in waymark: ") + error.what());
    return ExitCode::OurBug;
  }
}

}  // namespace
}  // namespace waymark::tools

int main(int argc, char** argv) {
  std::ios::sync_with_stdio(false);
  return static_cast<int>(waymark::tools::guarded_main(argc, argv));
}

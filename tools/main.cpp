// waymark: from an English route instruction to a certified route, one subcommand per stage.
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstddef>
#include <cstdlib>
#include <span>
#include <string>
#include <string_view>
#include <system_error>

#include "tools/help/topics.hpp"
#include "tools/shell/data_directory.hpp"
#include "tools/shell/program.hpp"
#include "tools/shell/seat.hpp"

namespace waymark::tools {

Runner setup_run(Command);
Runner setup_ground(Command);
Runner setup_translate(Command);
Runner setup_automaton(Command);
Runner setup_compose(Command);
Runner setup_plan(Command);
Runner setup_check(Command);
Runner setup_verify(Command);
Runner setup_monitor(Command);
Runner setup_compare_formulas(Command);
Runner setup_explain(Command);
Runner setup_compare(Command);
Runner setup_train(Command);
Runner setup_evaluate(Command);
Runner setup_import(Command);
Runner setup_corpus(Command);
Runner setup_move(Command);
Runner setup_map(Command);
Runner setup_generate(Command);
Runner setup_preprocess(Command);
Runner setup_draw(Command);
Runner setup_patterns(Command);
Runner setup_random(Command);
Runner setup_help(Command);
Runner setup_version(Command);

namespace {

constexpr std::array rows{
    Subcommand{"run", "walk the whole corridor: instruction, formula, automaton, product, certified route", setup_run,
               "run \"walk past the lamp to the easel\" --map grid --start 1,9,0\n"
               "run \"keep coming back to the lamp\" --json"},
    Subcommand{"ground", "instruction → formulas, best first", setup_ground,
               "ground \"turn left and walk to the chair\" --map grid --top 3\n"
               "ground \"walk to the sofa\" --map jelly --json"},
    Subcommand{"translate", "formula → automaton", setup_translate,
               "translate 'F(chair & X F sofa)' --to dfa\n"
               "translate 'G F a -> G F b' --to parity --format stats"},
    Subcommand{"automaton", "automata of HOA files → operations, questions, other formats", setup_automaton,
               "translate 'G F a' | waymark automaton - --to buchi\n"
               "translate 'F a' --to dfa | waymark automaton - --complement --format dot"},
    Subcommand{"compose", "formula or automaton, and a map → their product", setup_compose,
               "compose 'F easel' --map grid\n"
               "compose 'F easel' --map grid --format json"},
    Subcommand{"plan", "formula or automaton, and a map → a certified route of least cost", setup_plan,
               "plan 'F chair & G !blue' --map grid --start 1,9,0\n"
               "plan 'G F chair & G F sofa' --semantics infinite --order cycle"},
    Subcommand{"check", "does this trajectory satisfy this formula?", setup_check,
               "plan 'F sofa' --json | waymark check 'F sofa' --trajectory -\n"
               "check 'a U b' --word '{a}; {a}; {b}'"},
    Subcommand{"verify", "is what a printed answer claims true? by code that did not find it", setup_verify,
               "plan 'F chair & G !blue' --map grid --json | waymark verify\n"
               "translate 'G(a -> F b)' --format json | waymark verify --words 10000"},
    Subcommand{"monitor", "formulas and letters as they come → verdicts, and what remains", setup_monitor,
               "monitor 'G(a -> F b)' --letters <(printf '{a}\\n{}\\n{b}\\n')\n"
               "monitor 'F b' 'a U b' --semantics finite --letters <(echo 'a; a; b') --json"},
    Subcommand{"compare-formulas", "two formulas → equivalent, stronger, weaker or incomparable, with words",
               setup_compare_formulas,
               "compare-formulas 'F a & F b' 'F(a & F b) | F(b & F a)'\n"
               "compare-formulas 'G(p -> F p)' true --semantics infinite"},
    Subcommand{"explain", "formula → English, with a word that satisfies it and one that does not", setup_explain,
               "explain 'G(request -> F grant)' --semantics infinite\n"
               "explain 'F chair & G !blue' --map grid"},
    Subcommand{"move", "formula and a map → a certified motion of a robot with a body", setup_move,
               "move 'F chair' --map grid --start 1,9,0\n"
               "move 'F chair & G !blue' --map grid --start 1,9,0 --svg motion.svg"},
    Subcommand{"compare", "exact search, value iteration and learners on one task, side by side", setup_compare,
               "compare 'F easel' --map grid --methods search,value-iteration\n"
               "compare 'F easel' --map grid --methods q-learning --seeds 2 --steps 500"},
    Subcommand{"train", "corpus → model", setup_train,
               "train --corpus DIR --model linear --seed 1 --out model.waymark\n"
               "train --supervised DIR/pairs.tsv --out model.waymark"},
    Subcommand{"evaluate", "corpus → accuracy, leaving one map out", setup_evaluate,
               "evaluate --corpus DIR --leave-one-map-out --model linear\n"
               "evaluate --corpus DIR --train-all --test-corpus DIR2 --json"},
    Subcommand{"experiment", experiment_summary, nullptr, experiment_examples},
    Subcommand{"tune", tune_summary, nullptr, tune_examples},
    Subcommand{"import", "a corpus as it was released → ours; OpenStreetMap → roads of DIMACS", setup_import,
               "import sail DIR --out DIR2\n"
               "import osm country.osm --out country"},
    Subcommand{"corpus", "how large a corpus is, in texts and trajectories", setup_corpus,
               "corpus DIR\n"
               "corpus DIR --json"},
    Subcommand{"map", "what a map knows: places, names, and propositions with their meanings", setup_map,
               "map grid\n"
               "map jelly --all"},
    Subcommand{"draw", "formula, automaton, map, product, route, lasso, policy or values → picture", setup_draw,
               "draw formula --formula 'G(a -> F b)' --svg tree.svg\n"
               "draw route --map grid --formula 'F sofa' --start 1,9,0 --terminal"},
    Subcommand{"serve", serve_summary, nullptr, serve_examples},
    Subcommand{"generate", generate_summary, setup_generate,
               "generate map --kind maze --width 20 --height 20 --seed 3\n"
               "generate map --kind hallway --landmarks 4"},
    Subcommand{"preprocess", "roads → a contraction hierarchy, by which tasks on them are planned in milliseconds",
               setup_preprocess,
               "preprocess country.gr --out country.ch\n"
               "preprocess town.gr --json"},
    Subcommand{"patterns", "specification patterns by name → formula", setup_patterns,
               "patterns --list\n"
               "patterns response-globally p s"},
    Subcommand{"random", "random formulas", setup_random,
               "random --count 3 --seed 1\n"
               "random --props 2 --size 5..8 --semantics finite --count 3"},
    Subcommand{"help", "pages of the manual: formulas, maps, automata in HOA, conventions, …", setup_help,
               "help\n"
               "help maps"},
    Subcommand{"version", "version, build, and what it was built with", setup_version,
               "version\n"
               "--version"},
};

// Experiments, which need more of the libraries than a route does, are run by waymark-lab.
bool is_for_the_lab(std::span<char* const> arguments) {
  if (arguments.size() < 2) return false;
  const std::string_view command = arguments[1];
  return command == "experiment" || command == "tune" ||
         (command == "generate" && arguments.size() > 2 && std::string_view(arguments[2]) == "corpus");
}

// Was this process started by mpirun, or by another that starts ranks? A process that a rank started has a seat and is
// none.
bool is_rank() {
  if (std::getenv(seat_variable) != nullptr) return false;
  return std::getenv("OMPI_COMM_WORLD_RANK") != nullptr || std::getenv("PMIX_RANK") != nullptr ||
         std::getenv("PMI_RANK") != nullptr;
}

// Texts and experiments, which ranks deal out.
bool is_for_the_farm(std::span<char* const> arguments) {
  if (arguments.size() < 2) return false;
  const std::string_view command = arguments[1];
  return command == "translate" || command == "ground" || command == "experiment" || command == "tune";
}

// Planning cases, which ranks solve together.
bool is_distributed(std::span<char* const> arguments) {
  return arguments.size() > 2 && std::string_view(arguments[1]) == "plan" &&
         std::any_of(arguments.begin() + 2, arguments.end(),
                     [](std::string_view argument) { return argument == "--case" || argument.starts_with("--case="); });
}

// waymark-farm starts this program again, which it knows by its argv[0].
[[noreturn]] void become_rank(char** argv) {
  const auto program = helper("waymark-farm");
  if (program.empty())
    throw UsageError(
        "waymark-farm, which shares work among the ranks of mpirun, is not built; to build it: ./dev "
        "setup mpi && cmake --preset release -DWAYMARK_WITH_MPI=ON && cmake --build --preset release");
  std::string path = executable().string();
  argv[0] = path.data();
  ::execv(program.c_str(), argv);
  throw std::system_error(errno, std::generic_category(), "cannot start " + program.string());
}

// `waymark help plan` is `waymark plan --help`.
bool is_subcommand(std::string_view name) {
  return std::any_of(rows.begin(), rows.end(), [&](const Subcommand& row) { return row.name == name; });
}

// The helper takes the place of this process: its streams, its signals and its exit code are those of the command.
[[noreturn]] void become(std::string_view helper_name, std::string_view what_it_does, char** argv) {
  const auto program = needed_helper(helper_name, what_it_does);
  ::execv(program.c_str(), argv);
  throw std::system_error(errno, std::generic_category(), "cannot start " + program.string());
}

[[noreturn]] void become_solver(char** argv) {
  if (helper("waymark-distributed").empty())
    throw UsageError(
        "waymark-distributed, which solves planning cases among the ranks of mpirun, is not built; to build it: ./dev "
        "setup petsc && cmake --preset release -DWAYMARK_WITH_PETSC=ON && cmake --build --preset release");
  become("waymark-distributed", "solves planning cases among the ranks of mpirun", argv);
}

}  // namespace
}  // namespace waymark::tools

int main(int argc, char** argv) {
  using namespace waymark::tools;
  std::ios::sync_with_stdio(false);
  return static_cast<int>(guarded([&] {
    const std::span<char* const> arguments(argv, static_cast<std::size_t>(argc));
    if (is_for_the_farm(arguments) && is_rank()) become_rank(argv);
    if (is_distributed(arguments) && is_rank()) become_solver(argv);
    if (is_for_the_lab(arguments)) become("waymark-lab", "runs experiments", argv);
    if (argc > 1 && std::string_view(argv[1]) == "serve")
      become("waymark-serve", "serves the studio (it needs libcpp-httplib-dev)", argv);
    if (argc == 3 && std::string_view(argv[1]) == "help" && find_topic(argv[2]) == nullptr && is_subcommand(argv[2])) {
      std::string flag = "--help";
      std::array<char*, 4> asked{argv[0], argv[2], flag.data(), nullptr};
      if (is_for_the_lab({asked.data(), 3})) become("waymark-lab", "runs experiments", asked.data());
      return run_subcommand(rows, 3, asked.data());
    }
    return run_subcommand(rows, argc, argv);
  }));
}

#include "tools/shell/program.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <cerrno>
#include <exception>
#include <filesystem>
#include <iostream>
#include <map>
#include <memory>
#include <new>
#include <set>
#include <sstream>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include "libltl/diagnostic.hpp"
#include "libltl/text/xxhash.hpp"
#include "libltl/vocabulary.hpp"
#include "tools/shell/help_page.hpp"
#include "tools/shell/input.hpp"
#include "tools/shell/interrupt.hpp"
#include "tools/shell/output.hpp"
#include "tools/shell/shell_files.hpp"

namespace waymark::tools {
namespace {

// Every subcommand is known by name; only the one that is called gets its options, which take longer to set up than
// a small formula to translate.
struct Called {
  CLI::App* command = nullptr;
  Runner runner;
};

std::string examples_of(const Subcommand& row) {
  std::string text = "Examples:";
  std::istringstream lines(row.examples);
  for (std::string line; std::getline(lines, line);) text += "\n  waymark " + line;
  return text;
}

// Help as help_page.hpp sets it, in the place of CLI11's.
class HelpFormatter : public CLI::FormatterBase {
 public:
  std::string make_help(const CLI::App* app, std::string, CLI::AppFormatMode mode) const override {
    HelpText text{.usage = "waymark", .summary = app->get_description(), .options = options_of(*app, false)};
    std::string path;
    for (const CLI::App* at = app; at->get_parent() != nullptr; at = at->get_parent())
      path = ' ' + at->get_name() + path;
    text.usage += path;
    if (app->get_parent() == nullptr) text.options.clear();  // --version alone, which the usage names
    for (const CLI::App* below : app->get_subcommands([](const CLI::App*) { return true; }))
      text.commands.emplace_back(below->get_name(), below->get_description());
    text.usage += text.commands.empty() ? " [OPTIONS]" : " SUBCOMMAND [OPTIONS]";
    for (const OptionText& option : text.options)
      if (option.names.empty()) text.usage += " [" + option.place + ']';
    if (app->get_parent() == nullptr) text.usage += ", waymark help [TOPIC], waymark --version";
    text.examples = app->get_footer();
    return help_page(text, mode == CLI::AppFormatMode::All);
  }
};

Called add_subcommands(CLI::App& app, std::span<const Subcommand> rows, std::string_view called) {
  Called found;
  for (const Subcommand& row : rows) {
    CLI::App* command = app.add_subcommand(row.name, row.summary);
    if (row.examples != nullptr) command->footer(examples_of(row));
    if (called != row.name || row.setup == nullptr) continue;
    command->set_help_all_flag("--help-all", "help with every option");
    found = {command, row.setup(Command(*command))};
  }
  return found;
}

CommandText described(const Subcommand& row) {
  CLI::App app{row.summary};
  const Runner kept = row.setup != nullptr ? row.setup(Command(app)) : Runner();  // owns what the options fill
  CommandText out{row.name, row.summary, Command(app).options(), {}};
  std::istringstream lines(row.examples != nullptr ? row.examples : "");
  for (std::string line; std::getline(lines, line);) out.examples.push_back("waymark " + line);
  return out;
}

// A first argument that is neither an option nor a subcommand: most likely a slip of the fingers.
void reject_unknown_subcommand(std::span<const Subcommand> rows, int argc, char** argv) {
  if (argc < 2) throw UsageError("no subcommand given; see waymark --help");
  if (argv[1][0] == '-') return;
  ltl::Vocabulary known;
  for (const Subcommand& row : rows) known.add(row.name);
  const std::string_view given = argv[1];
  if (given.empty()) throw UsageError("the name of the subcommand is empty; see waymark --help");
  if (known.find(given)) return;
  const auto nearest = known.nearest(given);
  throw UsageError("there is no subcommand '" + std::string(given) + "'" +
                   (nearest ? " (did you mean '" + *nearest + "'?)" : "; see waymark --help"));
}

const std::set<std::string>& options_written_to() {
  static const std::set<std::string> names{"--svg",           "--png",
                                           "--pdf",           "--hoa",
                                           "--out",           "--strategy",
                                           "--predictions",   "--paragraph-predictions",
                                           "--behavior-tree", "--command-predictions"};
  return names;
}

// Before the work and not after it. --out may name a folder, or the beginning of several names: its command looks.
void check_files_can_be_written(const CLI::App& command) {
  for (const CLI::Option* option : command.get_options())
    if (options_written_to().contains(option->get_name()) && option->get_name() != "--out")
      for (const std::string& file : option->results()) check_writable(file);
}

// A file that is written may be no other option's file: what was read would be lost, or one picture of two.
void check_distinct_files(const CLI::App& command) {
  std::map<std::filesystem::path, const CLI::Option*> outputs;
  std::error_code ignored;
  const auto each = [&](auto visit) {
    for (const CLI::Option* option : command.get_options())
      for (const std::string& value : option->results())
        if (!value.empty() && value != "-" &&
            (std::filesystem::is_regular_file(value, ignored) || !std::filesystem::exists(value, ignored)))
          visit(*option, value, std::filesystem::weakly_canonical(std::filesystem::absolute(value, ignored), ignored));
  };
  each([&](const CLI::Option& option, const std::string& value, const std::filesystem::path& file) {
    if (!options_written_to().contains(option.get_name())) return;
    const auto [other, fresh] = outputs.emplace(file, &option);
    if (!fresh) throw UsageError(option.get_name() + " and " + other->second->get_name() + " name one file: " + value);
  });
  each([&](const CLI::Option& option, const std::string& value, const std::filesystem::path& file) {
    const auto output = outputs.find(file);
    if (output != outputs.end() && output->second != &option && std::filesystem::exists(file, ignored))
      throw UsageError(output->second->get_name() + " would overwrite what " + option.get_name() + " reads: " + value);
  });
}

// How many work at it, and where it goes, is of no influence on the answers; texts are compared by themselves.
bool is_of_influence(const CLI::Option& option) {
  static const std::set<std::string> others{"--threads", "--share", "--kept", "--checkpoints"};
  return !others.contains(option.get_name()) && !option.get_positional();
}

std::string settings_of(const CLI::App& command, const std::set<std::string>& without) {
  std::ostringstream out;
  out << command.get_name() << '\n';
  std::error_code ignored;
  for (const CLI::Option* option : command.get_options()) {
    if (option->empty() || !is_of_influence(*option) || without.contains(option->get_name())) continue;
    for (const std::string& value : option->results()) {
      out << option->get_name() << ' ' << value;
      const bool is_read = option->get_name() != "--file" && std::filesystem::is_regular_file(value, ignored);
      if (is_read) out << ' ' << hexadecimal(ltl::xxh64(read_file(value)));
      out << '\n';
    }
  }
  out << "version " << WAYMARK_VERSION << "\nprogram " << hexadecimal(ltl::xxh64(read_file("/proc/self/exe"))) << '\n';
  return out.str();
}

// A descriptor that the caller closed would be given to the next file that is opened: to the pipe of signals, say.
void open_missing_streams() {
  for (int stream = 0; stream <= 2; ++stream)
    if (::fcntl(stream, F_GETFD) == -1 && errno == EBADF &&
        ::open("/dev/null", stream == 0 ? O_RDONLY : O_WRONLY) == -1)
      throw std::system_error(errno, std::generic_category(), "/dev/null");
}

void check_written() {
  std::cout.flush();
  if (!std::cout) throw ltl::FormatError("standard output", 0, 0, "cannot be written");
}

}  // namespace

ExitCode run_subcommand(std::span<const Subcommand> rows, int argc, char** argv) {
  reject_unknown_subcommand(rows, argc, argv);
  if (argc == 3 && std::string_view(argv[1]) == "--write-shell-files") {  // of the build: cmake/WaymarkInstall.cmake
    std::vector<CommandText> commands;
    for (const Subcommand& row : rows) commands.push_back(described(row));
    write_shell_files(commands, argv[2]);
    return ExitCode::Done;
  }
  CLI::App app{"waymark: English route instructions → LTL → automata → certified routes"};
  app.require_subcommand(1);
  app.formatter(std::make_shared<HelpFormatter>());
  app.set_version_flag("--version", "waymark " WAYMARK_VERSION);
  const Called called = add_subcommands(app, rows, argv[1]);
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& help) {  // --help, --version
    app.exit(help, std::cout, std::cerr);
    check_written();
    return ExitCode::Done;
  } catch (const CLI::ParseError& error) {
    throw UsageError(error.what() + std::string("; see waymark ") +
                     (called.command != nullptr ? called.command->get_name() + " " : "") + "--help");
  }
  if (!called.runner) throw UsageError("the subcommand comes first; see waymark --help");
  check_distinct_files(*called.command);
  check_files_can_be_written(*called.command);
  const Interrupt interrupt;
  const auto settings = [&](const auto& without) { return settings_of(*called.command, without); };
  const ExitCode code =
      called.runner({.stop = interrupt.token(), .out = terminal_of(STDOUT_FILENO), .settings = settings});
  check_written();
  return code;
}

ExitCode guarded(const std::function<ExitCode()>& run) {
  try {
    open_missing_streams();
    return run();
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
  } catch (const std::exception& error) {  // an assertion of ours that did not hold: said so, never passed over
    complain("error", std::string("this is a bug in waymark: ") + error.what());
    return ExitCode::OurBug;
  }
}

}  // namespace waymark::tools

// A program of subcommands: parses the command line, runs one subcommand, and turns what comes out into an exit code
// (docs/cli.md): a value, or one message on standard error for an input that is wrong.
#pragma once
#include <functional>
#include <span>

#include "tools/shell/subcommand.hpp"

namespace waymark::tools {

// Runs the subcommand of the table that argv[1] names.
ExitCode run_subcommand(std::span<const Subcommand> rows, int argc, char** argv);

// Every exception of run() becomes a message and an exit code here, and nowhere before.
ExitCode guarded(const std::function<ExitCode()>& run);

}  // namespace waymark::tools

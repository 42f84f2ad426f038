// waymark patterns: the catalogues of specification patterns, and formulas made from them.
#include <iostream>
#include <memory>

#include "libltl/patterns/patterns.hpp"
#include "libltl/text/print.hpp"
#include "tools/shell/json.hpp"
#include "tools/shell/subcommand.hpp"

namespace waymark::tools {
namespace {

struct PatternsOptions {
  bool list = false, json = false;
  std::string name;
  std::vector<std::string> arguments;
};

void list(bool json) {
  std::vector<ltl::Pattern> all = ltl::property_patterns();
  for (ltl::Pattern& pattern : ltl::mission_patterns()) all.push_back(std::move(pattern));
  for (const ltl::Pattern& pattern : all) {
    if (json)
      std::cout << JsonObject()
                       .add("name", pattern.name)
                       .add("parameters", pattern.parameters)
                       .add("sentence", pattern.sentence)
                       .add("source", pattern.source)
                       .add("formula", pattern.formula)
                       .text()
                << '\n';
    else
      std::cout << pattern.name << '\t' << pattern.parameters << '\t' << pattern.sentence << '\t' << pattern.formula
                << '\t' << pattern.source << '\n';
  }
}

ExitCode run_patterns(const PatternsOptions& options) {
  if (options.list || options.name.empty()) {
    list(options.json);
    return ExitCode::Done;
  }
  ltl::Arena arena;
  try {
    const std::string formula = ltl::print(ltl::instantiate(options.name, options.arguments, arena));
    if (options.json)
      std::cout << JsonObject().add("name", options.name).add("formula", formula).text() << '\n';
    else
      std::cout << formula << '\n';
  } catch (const std::invalid_argument& error) {
    throw UsageError(error.what() + std::string("; see waymark patterns --list"));
  }
  return ExitCode::Done;
}

}  // namespace

Runner setup_patterns(Command command) {
  const auto options = std::make_shared<PatternsOptions>();
  command.add_option("name", options->name, "pattern, as --list names them").type_name("NAME");
  command.add_option("arguments", options->arguments, "formulas in the place of its parameters").type_name("ARGUMENT");
  command.add_flag("--list", options->list, "all patterns: name, parameters, sentence, formula, source");
  command.add_flag("--json", options->json, "one object a line");
  return [options](const Session&) { return run_patterns(*options); };
}

}  // namespace waymark::tools

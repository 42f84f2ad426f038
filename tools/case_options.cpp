#include "tools/case_options.hpp"

#include <algorithm>

#include "tools/shell/exit_code.hpp"

namespace waymark::tools {
namespace {

// What some queries take, and what is answered besides the value.
void add_answer_options(Command command, CaseChoice& choice) {
  command.add_option("--discount", choice.discount, "of query discounted, for every action after the first")
      .between(0.0, 1.0)
      .show_default();
  command
      .add_option("--order", choice.order,
                  "of lassos: least prefix, then cycle; least cycle, then prefix; least mean cost a round of "
                  "the cycle, then prefix")
      .one_of({"prefix", "cycle", "mean"})
      .show_default();
  command.add_option("--top", choice.top, "the K cheapest routes").type_name("K").between(1, 100'000).show_default();
  command
      .add_option("--strategy", choice.strategy,
                  "with --case and --model: write what to do in every state that is met, JSON lines; - is "
                  "standard output")
      .type_name("FILE");
  command
      .add_option("--strategy-format", choice.strategy_format,
                  "with --strategy and --model: as PRISM's -exportstrat or Storm's --exportscheduler writes it")
      .one_of({"waymark", "prism", "storm"})
      .show_default();
  command
      .add_option("--values-in", choice.values_in,
                  "keep the values of large grids in files in this folder, where memory does not suffice")
      .type_name("DIR");
  command
      .add_option("--scheduler", choice.scheduler,
                  "with --model: the value of this scheduler of PRISM or Storm, as a Markov chain")
      .type_name("FILE");
}

void add_prism_options(Command command, CaseChoice& choice) {
  command
      .add_option("--const", choice.constants,
                  "with --model in the language of PRISM or in JANI: values of its constants, N=3,p=0.5")
      .type_name("LIST");
  command
      .add_option(
          "--rewards", choice.rewards,
          "with --model in the language of PRISM or in JANI: the rewards that are costs; else \"cost\" or \"steps\", "
          "or the first")
      .type_name("NAME");
  command
      .add_option("--properties", choice.properties,
                  "with --model in the language of PRISM: answer its P and R operators instead of a formula, and "
                  "compare with their RESULT comments; in JANI: answer those of the document, the same FILE")
      .type_name("FILE");
}

}  // namespace

plan::LassoOrder order_of(const std::string& name) {
  if (name == "cycle") return plan::LassoOrder::Cycle;
  return name == "mean" ? plan::LassoOrder::Mean : plan::LassoOrder::Prefix;
}

plan::PrismConstants constants_of(const std::string& text) {
  plan::PrismConstants out;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find(',', at), text.size()), equals = text.find('=', at);
    if (equals == std::string::npos || equals >= end || equals == at || equals + 1 == end)
      throw UsageError("expected --const NAME=VALUE,…, not '" + text + "'");
    if (!out.emplace(text.substr(at, equals - at), text.substr(equals + 1, end - equals - 1)).second)
      throw UsageError("--const gives a value twice");
    at = end + 1;
  }
  return out;
}

void add_case_options(Command command, CaseChoice& choice) {
  command = command.in("Other models than a map, and what may fail");
  command.add_option("--case", choice.file, "a planning case (ltlgrid/1 or ltlmap/1) instead of a formula and a map")
      .type_name("FILE");
  command
      .add_option("--model", choice.model,
                  "a formula's value on another model than a map: PRISM's FILE.nm or FILE.tra, FILE.jani, roads "
                  "(FILE.gr, FILE.osm, "
                  "FILE.geojson, FILE.graphml), a street graph or planning case (JSON), a transition system (YAML)")
      .type_name("FILE");
  command
      .add_option("--hierarchy", choice.hierarchy,
                  "with --model FILE.gr: what waymark preprocess made of it; none: search the product instead")
      .type_name("FILE");
  command
      .add_option("--query", choice.query,
                  "with --model: greatest or least probability, least or greatest expected cost until the formula is "
                  "sure to hold; steps: least cost of a finite word; lasso: a walk without end; discounted: greatest "
                  "expected "
                  "reward")
      .one_of({"pmax", "pmin", "rmin", "rmax", "steps", "lasso", "discounted"})
      .show_default();
  add_prism_options(command, choice);
  add_answer_options(command, choice);
  command.add_option("--task", choice.task, "with --case: this task only").type_name("ID");
  command.add_option("--method", choice.method, "with --case: how it is solved; best picks by model and query")
      .one_of({"best", "search", "vi", "pi"})
      .show_default();
  command
      .add_option("--tolerance", choice.tolerance,
                  "with --case: proved error of values, absolute for probabilities, relative for costs")
      .between(1e-12, 1.0)  // doubles carry no less
      .show_default();
  add_work_limits(command, choice.parallel.limits, "a formula or task, or the reading of a model");
  command.add_option("--threads", choice.parallel.threads, "formulas or tasks answered at a time (0: all cores)")
      .type_name("N")
      .show_default();
}

}  // namespace waymark::tools

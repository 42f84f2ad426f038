// waymark preprocess: roads → a contraction hierarchy in a file, for waymark plan --hierarchy.
#include <iostream>
#include <memory>

#include "libplan/model/formats/read_dimacs.hpp"
#include "tools/answer.hpp"
#include "tools/plan_roads.hpp"
#include "tools/shell/json.hpp"
#include "tools/shell/output.hpp"
#include "tools/shell/output_file.hpp"
#include "tools/shell/subcommand.hpp"

namespace waymark::tools {
namespace {

struct PreprocessOptions {
  std::string roads, out;
  bool json = false;
};

ExitCode run_preprocess(const PreprocessOptions& options, const Session& session) {
  check_writable(options.out);
  StopWatch watch;
  const plan::RoadGraph graph = plan::read_dimacs(options.roads);
  const double read = watch.lap();
  plan::ContractionOptions contraction;
  contraction.stop = session.stop;
  const plan::RoadHierarchy hierarchy = hierarchy_of(graph, contraction);
  const double contracted = watch.lap();
  if (!options.out.empty()) {
    OutputFile file(options.out);
    plan::write_hierarchy(file.stream(), hierarchy);
    file.finish();
  }
  if (options.json) {
    std::cout << JsonObject()
                     .add("nodes", graph.nodes())
                     .add("arcs", graph.arcs())
                     .add("core", graph.nodes() - hierarchy.core())
                     .add("hierarchy_arcs", hierarchy.arcs())
                     .add("letter_sets", hierarchy.sets().size())
                     .add("seconds", JsonObject().add("read", read).add("contract", contracted))
                     .text()
              << '\n';
    return ExitCode::Done;
  }
  std::cout << "roads      " << counted(graph.nodes(), "node") << ", " << counted(graph.arcs(), "arc") << '\n'
            << "hierarchy  " << counted(hierarchy.arcs(), "arc") << ", with shortcuts; "
            << counted(graph.nodes() - hierarchy.core(), "node") << " in the core\n";
  return ExitCode::Done;
}

}  // namespace

Runner setup_preprocess(Command command) {
  const auto options = std::make_shared<PreprocessOptions>();
  command.add_option("roads", options->roads, "roads of DIMACS, with labels beside them")
      .type_name("FILE.gr")
      .required();
  command.add_option("--out", options->out, "write the hierarchy there").type_name("FILE");
  command.add_flag("--json", options->json, "one JSON object");
  return [options](const Session& session) { return run_preprocess(*options, session); };
}

}  // namespace waymark::tools

// waymark import: a corpus as it was released → our JSON Lines, with everything odd that was met on the way; an extract
// of OpenStreetMap → roads of DIMACS.
#include <iostream>
#include <memory>

#include "libltl/text/read_text.hpp"
#include "libparser/corpus/import/import_sail.hpp"
#include "libplan/model/formats/osm_roads.hpp"
#include "tools/answer.hpp"
#include "tools/shell/exit_code.hpp"
#include "tools/shell/json.hpp"
#include "tools/shell/output.hpp"
#include "tools/shell/output_file.hpp"
#include "tools/shell/subcommand.hpp"

namespace waymark::tools {
namespace {

struct ImportOptions {
  std::string directory, out;
  bool json = false;
};

Json irregularity_json(const parser::Irregularity& irregularity) {
  return JsonObject()
      .add("file", irregularity.file)
      .add("line", irregularity.line)
      .add("kind", irregularity.kind)
      .add("message", irregularity.message);
}

void write_corpus(const std::filesystem::path& folder, const parser::ImportedCorpus& corpus) {
  make_directory(folder / "maps");
  for (const auto& [name, text] : corpus.maps) write_file(folder / "maps" / (name + ".json"), text);
  write_file(folder / "instructions.jsonl", corpus.instructions);
}

ExitCode run_import(const ImportOptions& options) {
  const parser::ImportedCorpus corpus = parser::import_sail(options.directory);
  if (!options.out.empty()) write_corpus(options.out, corpus);
  if (options.json) {
    JsonArray irregularities;
    for (const parser::Irregularity& i : corpus.irregularities) irregularities.add(irregularity_json(i));
    std::cout << JsonObject()
                     .add("format", corpus.format)
                     .add("maps", corpus.maps.size())
                     .add("paragraphs", corpus.paragraphs)
                     .add("sentences", corpus.sentences)
                     .add("out", options.out)
                     .add("irregularities", irregularities)
                     .text()
              << '\n';
    return ExitCode::Done;
  }
  for (const parser::Irregularity& i : corpus.irregularities)
    std::cout << i.file << ':' << i.line << ": " << i.kind << ": " << i.message << '\n';
  std::cout << corpus.format << ": " << corpus.paragraphs << " paragraphs, " << corpus.sentences << " sentences, "
            << corpus.maps.size() << " maps, " << corpus.irregularities.size() << " irregularities\n";
  return ExitCode::Done;
}

struct ImportOsmOptions {
  std::string file, out;
  std::vector<std::string> names, tags;
  bool json = false;
};

ExitCode run_import_osm(const ImportOsmOptions& options, const Session& session) {
  plan::OsmChoice choice{options.names, {}, session.stop};
  for (const std::string& tag : options.tags) {
    const std::size_t equals = tag.find('=');
    if (equals == std::string::npos || equals == 0 || equals + 1 == tag.size())
      throw UsageError("expected --tag KEY=VALUE, here is '" + tag + "'");
    choice.tags.emplace_back(tag.substr(0, equals), tag.substr(equals + 1));
  }
  auto osm = ltl::open_text(options.file);
  OutputFile gr(options.out + ".gr"), co(options.out + ".co"), lab(options.out + ".lab");
  const plan::OsmRoads made = plan::write_osm_roads(osm, options.file, choice, gr.stream(), co.stream(), lab.stream());
  if (made.stopped) throw Interrupted();
  gr.finish();
  co.finish();
  lab.finish();
  if (options.json)
    std::cout << JsonObject()
                     .add("nodes", made.nodes)
                     .add("arcs", made.arcs)
                     .add("missing", made.missing)
                     .add("labelled", made.labelled)
                     .add("labels", made.labels)
                     .text()
              << '\n';
  else
    std::cout << "roads      " << counted(made.nodes, "node") << ", " << counted(made.arcs, "arc") << "; "
              << counted(made.missing, "node") << " not in the extract\n"
              << "landmarks  " << counted(made.labels, "name") << " at " << counted(made.labelled, "node") << '\n';
  return ExitCode::Done;
}

void add_osm_options(Command command, const std::shared_ptr<ImportOsmOptions>& options) {
  command.add_option("file", options->file, "OSM XML, nodes before ways").type_name("FILE.osm").required();
  command.add_option("--out", options->out, "write PREFIX.gr, PREFIX.co and PREFIX.lab").type_name("PREFIX").required();
  command.add_option("--name", options->names, "only landmarks of this name, in snake_case (may be repeated)");
  command.add_option("--tag", options->tags, "landmarks with this tag, too; VALUE names them (may be repeated)")
      .type_name("KEY=VALUE");
  command.add_flag("--json", options->json, "one JSON object");
}

}  // namespace

Runner setup_import(Command command) {
  const auto options = std::make_shared<ImportOptions>();
  Command sail = command.add_subcommand("sail", "the route instructions of SAIL: XML, .settrc, or ours");
  sail.add_option("directory", options->directory, "looked through with all its folders").type_name("DIR").required();
  sail.add_option("--out", options->out, "write instructions.jsonl and maps/ there").type_name("DIR");
  sail.add_flag("--json", options->json, "one JSON object");
  const auto roads = std::make_shared<ImportOsmOptions>();
  Command osm = command.add_subcommand("osm", "an extract of OpenStreetMap of any size → roads of DIMACS");
  add_osm_options(osm, roads);
  return [options, roads, osm](const Session& session) {
    return osm.parsed() ? run_import_osm(*roads, session) : run_import(*options);
  };
}

}  // namespace waymark::tools

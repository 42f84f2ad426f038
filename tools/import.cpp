// waymark import: a corpus as it was released → our JSON Lines, with everything odd that was met on the way.
#include <iostream>
#include <memory>

#include "libparser/corpus/import/import_sail.hpp"
#include "tools/shell/json.hpp"
#include "tools/shell/output.hpp"
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

}  // namespace

Runner setup_import(Command command) {
  const auto options = std::make_shared<ImportOptions>();
  Command sail = command.add_subcommand("sail", "the route instructions of SAIL: XML, .settrc, or ours");
  sail.add_option("directory", options->directory, "looked through with all its folders").type_name("DIR").required();
  sail.add_option("--out", options->out, "write instructions.jsonl and maps/ there").type_name("DIR");
  sail.add_flag("--json", options->json, "one JSON object");
  return [options](const Session&) { return run_import(*options); };
}

}  // namespace waymark::tools

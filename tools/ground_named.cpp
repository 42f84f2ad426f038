#include "tools/ground_named.hpp"

#include <algorithm>
#include <filesystem>

#include "libltl/diagnostic.hpp"
#include "libltl/text/print.hpp"
#include "libparser/grounding/missing_name.hpp"
#include "tools/shell/json.hpp"
#include "tools/shell/terminal.hpp"
#include "tools/understood.hpp"

namespace waymark::tools {
namespace {

const parser::LiftedReader& reader_of(const parser::Grounder& model) {
  if (!model.commands) throw UsageError("the model has no reader of commands");
  return *model.commands;
}

std::string english(ltl::Formula formula) { return in_english(formula, ltl::Semantics::Infinite); }

}  // namespace

void add_named_options(Command command, NamedOptions& options) {
  const std::string group = "Named things instead of a hallway map";
  command.add_option("--landmarks", options.landmarks, "a map of landmarks: names, other names, tags")
      .type_name("FILE")
      .group(group);
  command.add_option("--propositions", options.propositions, "propositions with names, tags, descriptions")
      .type_name("FILE")
      .group(group);
  command
      .add_option("--domains", options.domains,
                  "lines are commands {\"id\",\"domain\",\"text\"} of the domains of this file")
      .type_name("FILE")
      .group(group);
  command.add_option("--maps", options.maps, "maps of landmarks, for domains \"osm:CITY\"")
      .type_name("DIR")
      .group(group);
}

NamedGrounding::NamedGrounding(const NamedOptions& options, const parser::Grounder& model, std::size_t top, bool json,
                               bool force)
    : reader_(reader_of(model)), top_(std::max<std::size_t>(top, 1)), json_(json), force_(force) {
  if (int{!options.landmarks.empty()} + int{!options.propositions.empty()} + int{!options.domains.empty()} > 1)
    throw UsageError("--landmarks, --propositions and --domains exclude one another: what do the texts name?");
  if (!options.domains.empty()) {
    domains_.emplace(options.domains, options.maps);
    return;
  }
  file_ = options.landmarks.empty() ? options.propositions : options.landmarks;
  const auto things = options.landmarks.empty() ? parser::read_propositions(file_) : parser::read_landmarks(file_);
  if (things.empty()) throw ltl::FormatError(file_, 0, 0, "names nothing");
  things_ = parser::CommandDomain::city(std::filesystem::path(file_).stem().string(), things);
}

Reply NamedGrounding::operator()(const parser::Instruction& instruction, const Text& line) {
  return things_ ? of_things(instruction.text) : of_domain(instruction, domain_of(instruction, line));
}

const parser::CommandDomain& NamedGrounding::domain_of(const parser::Instruction& instruction, const Text& line) {
  if (!instruction.domain)
    throw ltl::FormatError(line.source, line.line, 0, "with --domains each line is a JSON object with a 'domain'");
  const std::lock_guard lock(reading_);
  return domains_->of(*instruction.domain);
}

Reply NamedGrounding::of_domain(const parser::Instruction& instruction, const parser::CommandDomain& domain) const {
  ltl::Arena arena;
  const auto read = parser::read_command(reader_, domain, instruction.text, arena);
  const bool understood = !read.readings.empty();
  const std::string formula = understood ? ltl::print(read.readings.front().formula) : "";
  const double probability = understood ? read.readings.front().probability : 0;
  if (!json_) return {.text = fixed(probability, 4) + "  " + formula + '\n'};
  JsonObject json;
  if (instruction.id) json.add("id", *instruction.id);
  json.add("formula", understood ? Json(formula) : Json())
      .add("english", understood ? Json(english(read.readings.front().formula)) : Json())
      .add("probability", probability);
  return {.text = json.text() + '\n'};
}

Reply NamedGrounding::of_things(const std::string& text) const {
  ltl::Arena arena;
  auto [readings, understood] = parser::read_command(reader_, *things_, text, arena);
  if (readings.empty() || (understood < parser::least_understood && !force_)) return not_understood(text, understood);
  if (readings.size() > top_) readings.erase(readings.begin() + static_cast<std::ptrdiff_t>(top_), readings.end());
  if (!json_) {
    std::string out;
    for (const parser::CommandReading& r : readings)
      out += fixed(r.probability, 4) + "  " + ltl::print(r.formula) + '\n';
    return {.text = out};
  }
  JsonArray array;
  for (const parser::CommandReading& r : readings)
    array.add(JsonObject()
                  .add("formula", ltl::print(r.formula))
                  .add("english", english(r.formula))
                  .add("probability", r.probability));
  return {.text = JsonObject()
                      .add("instruction", text)
                      .add("map", things_->name())
                      .add("formula", ltl::print(readings.front().formula))
                      .add("english", english(readings.front().formula))
                      .add("readings", array)
                      .text() +
                  '\n'};
}

Reply NamedGrounding::not_understood(const std::string& text, double probability) const {
  parser::Understanding understood;
  understood.probability = probability;
  understood.missing =
      parser::missing_name(reader_, things_->lift(text, reader_.mentions()).front().text, things_->named_things());
  return {.code = ExitCode::NotUnderstood,
          .text = json_ ? not_understood_json(text, things_->name(), understood).text() + '\n' : std::string(),
          .problem = not_understood_message(text, understood)};
}

}  // namespace waymark::tools

#include "libplan/model/formats/read_model.hpp"

#include <algorithm>
#include <iterator>

#include "libltl/diagnostic.hpp"
#include "libltl/text/foreign.hpp"
#include "libltl/text/read_text.hpp"
#include "libplan/model/formats/read_dimacs.hpp"
#include "libplan/model/formats/read_geojson.hpp"
#include "libplan/model/formats/read_graphml.hpp"
#include "libplan/model/formats/read_osm.hpp"
#include "libplan/model/formats/read_streets.hpp"
#include "libplan/model/formats/read_transition_system.hpp"
#include "libplan/model/jani/read_jani.hpp"
#include "libplan/model/prism/read_prism_explicit.hpp"
#include "libplan/world/json_reader.hpp"

namespace waymark::plan {
namespace {

bool is_case(std::string_view text, std::string_view source) {
  const JsonReader::Value document = JsonReader(text, source).parse();
  return !document.is_object() || document.contains("format");
}

}  // namespace

PlanningCase read_model(const std::filesystem::path& file, std::string_view start, const ltl::Limits& limits,
                        const PrismOptions& prism) {
  const std::string name = file.stem().string(), source = file.string();
  const auto no_start = [&] {
    if (!start.empty()) throw ltl::FormatError(source, 0, 0, "this model says itself where it starts");
  };
  constexpr std::string_view other_kinds[] = {".tra", ".gr", ".osm", ".geojson", ".graphml", ".json", ".yaml", ".yml"};
  if ((!prism.constants.empty() || !prism.rewards.empty()) &&
      std::find(std::begin(other_kinds), std::end(other_kinds), file.extension().string()) != std::end(other_kinds))
    throw ltl::FormatError(source, 0, 0,
                           "constants and rewards are chosen for models in the language of PRISM and in JANI");
  if (file.extension() == ".tra") {
    no_start();
    return {name, read_prism_explicit(file), {}};
  }
  if (file.extension() == ".gr") return {name, model_of(read_dimacs(file, start)), {}};
  const std::string text = ltl::read_text(file);
  if (file.extension() == ".osm") return {name, parse_osm(text, source, start), {}};
  if (file.extension() == ".geojson") return {name, parse_geojson(text, source, start), {}};
  if (file.extension() == ".graphml") return {name, parse_graphml(text, source, start), {}};
  if (file.extension() == ".json" && !is_case(text, source)) return {name, parse_streets(text, source, start), {}};
  no_start();
  if (file.extension() == ".yaml" || file.extension() == ".yml")
    return {name, parse_transition_system(text, source), {}};
  if (file.extension() == ".json") return parse_case(text, source);
  if (file.extension() == ".jani") return {name, parse_jani(text, source, limits, prism), {}};
  ltl::refuse_foreign(text, source, "a model in the language of PRISM", "a PRISM model");
  return {name, parse_prism(text, source, limits, prism), {}};
}

}  // namespace waymark::plan

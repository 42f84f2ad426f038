// Roads with landmarks in GeoJSON, OSM XML, GraphML and DIMACS (with the labels behind a line %%): refused with a
// FormatError, or a model whose moves stay in it and cost a finite number. Roads written out of OSM XML are read again.
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <sstream>
#include <string>
#include <string_view>

#include "libltl/diagnostic.hpp"
#include "libplan/model/formats/osm_roads.hpp"
#include "libplan/model/formats/read_dimacs.hpp"
#include "libplan/model/formats/read_geojson.hpp"
#include "libplan/model/formats/read_graphml.hpp"
#include "libplan/model/formats/read_osm.hpp"

namespace {

waymark::plan::Mdp dimacs(std::string_view gr, std::string_view lab) {
  std::istringstream roads{std::string(gr)}, labels{std::string(lab)};
  return model_of(waymark::plan::parse_dimacs(roads, labels, "roads.gr"));
}

void written_out_of_osm(std::string_view xml) {
  using namespace waymark;
  std::istringstream osm{std::string(xml)};
  std::stringstream gr, co, lab;
  plan::OsmRoads made;
  try {
    made = plan::write_osm_roads(osm, "roads.osm", {}, gr, co, lab);
  } catch (const ltl::FormatError&) {
    return;
  }
  if (plan::parse_dimacs(gr, lab, "roads.gr").nodes() != made.nodes) std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace waymark;
  if (size > 4'096) return 0;
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  if (text.substr(0, 1) == "<") written_out_of_osm(text);
  try {
    const std::size_t labels = text.find("\n%%\n");
    const plan::Mdp model = labels != std::string_view::npos
                                ? dimacs(text.substr(0, labels + 1), text.substr(labels + 4))
                            : text.substr(0, 1) == "{"                        ? plan::parse_geojson(text)
                            : text.find("<graphml") != std::string_view::npos ? plan::parse_graphml(text)
                                                                              : plan::parse_osm(text);
    for (std::uint32_t s = 0; s < model.states(); ++s)
      for (std::uint32_t k = 0; k < model.choices(s); ++k)
        if (model.outcome_count(s, k) != 1 || model.outcome(s, k, 0).target >= model.states() ||
            !std::isfinite(model.cost(s, k)) || model.cost(s, k) < 0)
          std::abort();
  } catch (const ltl::FormatError&) {
  }
  return 0;
}

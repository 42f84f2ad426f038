// Every reader names the well-known format that it was given in the place of its own.
#include <gtest/gtest.h>

#include <functional>
#include <sstream>
#include <string>

#include "libltl/diagnostic.hpp"
#include "libplan/model/formats/prism_properties.hpp"
#include "libplan/model/formats/read_case.hpp"
#include "libplan/model/formats/read_dimacs.hpp"
#include "libplan/model/formats/read_geojson.hpp"
#include "libplan/model/formats/read_graphml.hpp"
#include "libplan/model/formats/read_osm.hpp"
#include "libplan/model/formats/read_transition_system.hpp"
#include "libplan/model/formats/xml_stream.hpp"
#include "libplan/model/jani/read_jani.hpp"
#include "libplan/world/letter_source.hpp"
#include "libplan/world/read_map.hpp"

namespace waymark::plan {
namespace {

using Read = std::function<void(const std::string&)>;

std::string refusal(const Read& read, const std::string& text) {
  try {
    read(text);
  } catch (const ltl::FormatError& error) {
    return error.what();
  }
  return "read";
}

TEST(Foreign, IsNamedByEveryReader) {
  constexpr const char* model = "mdp\nmodule m\n s : [0..1] init 0;\n [] true -> (s'=s);\nendmodule\n";
  const std::pair<const char*, Read> readers[] = {
      {"yaml", [](const std::string& t) { parse_transition_system(t, "t"); }},
      {"osm", [](const std::string& t) { parse_osm(t); }},
      {"graphml", [](const std::string& t) { parse_graphml(t); }},
      {"geojson", [](const std::string& t) { parse_geojson(t); }},
      {"case", [](const std::string& t) { parse_case(t); }},
      {"map", [](const std::string& t) { parse_map(t); }},
      {"jani", [](const std::string& t) { parse_jani(t); }},
      {"letters", [](const std::string& t) { read_traces(t, {}, "t"); }},
      {"props",
       [&](const std::string& t) {
         parse_prism_properties({model, "m"}, {t, "t"});
       }},
      {"dimacs",
       [](const std::string& t) {
         std::istringstream gr(t), lab("0=\"init\"\n1: 0\n");
         parse_dimacs(gr, lab, "t");
       }},
      {"extract",
       [](const std::string& t) {
         std::istringstream in(t);
         XmlStream xml(in, "t");
         xml.next();
       }},
  };
  const std::pair<const char*, const char*> texts[] = {
      {"digraph g {\n a -> b\n}\n", "this is a DOT graph"},
      {"never { /* F a */\nT0:\n}\n", "this is a never claim"},
      {"<?xml version=\"1.0\"?>\n<log><trace/></log>\n", "this is an XES log"},
      {"HOA: v1\nStates: 0\n", "this is an automaton in HOA"},
      {"MODULE main\nVAR x : boolean;\n", "this is an SMV model"},
      {model, "this is a PRISM model"},
  };
  for (const auto& [name, read] : readers)
    for (const auto& [text, message] : texts)
      EXPECT_NE(refusal(read, text).find(message), std::string::npos) << name << ": " << refusal(read, text);
}

}  // namespace
}  // namespace waymark::plan

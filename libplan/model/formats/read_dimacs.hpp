// Roads in the format of the ninth DIMACS implementation challenge [DGJ09], FILE.gr, with labels in PRISM's FILE.lab
// beside it (docs/formats/roads.md).
//
// Of the formats for road networks this one is read and written by most tools for shortest paths, and by line, so that
// 10⁷ nodes need no document in memory. It knows neither names nor places; the labels are those of PRISM's explicit
// files, with the numbers that the nodes have in FILE.gr.
#pragma once
#include <filesystem>
#include <iosfwd>
#include <string_view>

#include "libplan/model/prism/state_labels.hpp"
#include "libplan/model/road_graph.hpp"

namespace waymark::plan {

// `start`: a number of a node, or a label; empty: the node with the label "init", else the first with any label.
// O(bytes), 26 bytes an arc at most. Throws ltl::FormatError with the line: no such file, a line of another kind, an
// arc between nodes that do not exist, another number of arcs than promised, many more nodes than arcs, no label at
// all, no such start.
RoadGraph read_dimacs(const std::filesystem::path& gr, std::string_view start = "");
// The same from streams; `source` names the roads in errors.
RoadGraph parse_dimacs(std::istream& gr, std::istream& lab, std::string_view source, std::string_view start = "");

// A deterministic model as FILE.gr and FILE.lab: state i is node i + 1. Costs that are not whole are written in
// hundredths, rounded; a comment says so. Throws std::invalid_argument for a model with chances, and for costs out of
// range.
void write_dimacs(std::ostream& gr, std::ostream& lab, const StateLabelled& model);

}  // namespace waymark::plan

// waymark-layout: DOT on standard input, laid out by Graphviz, SVG on standard output.
//
// A helper that waymark starts when it draws an automaton, as git starts its subcommands: so that commands which draw
// nothing never load Graphviz. Arguments: NAME=VALUE, attributes of the graph (rankdir=TB) that override the text's.
#include <gvc.h>

#include <iostream>
#include <iterator>
#include <string>

#include "tools/shell/with_parent.hpp"

namespace {

constexpr int bad_input = 21, our_bug = 30;  // docs/cli.md

struct Context {
  GVC_t* gvc = gvContext();
  Agraph_t* graph = nullptr;
  ~Context() {
    if (graph != nullptr) {
      gvFreeLayout(gvc, graph);
      agclose(graph);
    }
    gvFreeContext(gvc);
  }
};

int fail(int code, const std::string& message) {
  std::cerr << "error: waymark-layout: " << message << '\n';
  return code;
}

// Graphviz sets labels close to their edges: a blank on either side keeps the two apart.
void pad_labels(Agraph_t* graph) {
  std::string name = "label";
  for (Agnode_t* node = agfstnode(graph); node != nullptr; node = agnxtnode(graph, node))
    for (Agedge_t* edge = agfstout(graph, node); edge != nullptr; edge = agnxtout(graph, edge)) {
      const char* text = agget(edge, name.data());
      if (text == nullptr || *text == '\0') continue;
      std::string padded = ' ' + std::string(text) + ' ';
      if (aghtmlstr(const_cast<char*>(text)) == 0) {
        agset(edge, name.data(), padded.data());
      } else {  // agset takes any text for plain, unless the graph already knows it as markup
        char* markup = agstrdup_html(graph, padded.data());
        agset(edge, name.data(), markup);
        agstrfree(graph, markup);
      }
    }
}

}  // namespace

int main(int argc, char** argv) {
  waymark::tools::end_with_parent();
  const std::string dot{std::istreambuf_iterator<char>(std::cin), std::istreambuf_iterator<char>()};
  Context context;
  context.graph = agmemread(dot.c_str());
  if (context.graph == nullptr) return fail(bad_input, "standard input is not a DOT graph");
  std::string nothing;
  for (int i = 1; i < argc; ++i) {
    std::string attribute = argv[i];
    const auto equals = attribute.find('=');
    if (equals == std::string::npos) return fail(bad_input, "'" + attribute + "' is not NAME=VALUE");
    std::string value = attribute.substr(equals + 1);
    attribute.resize(equals);
    agsafeset(context.graph, attribute.data(), value.data(), nothing.data());
  }
  pad_labels(context.graph);
  if (gvLayout(context.gvc, context.graph, "dot") != 0) return fail(our_bug, "Graphviz could not lay the graph out");
  char* svg = nullptr;
  unsigned length = 0;
  if (gvRenderData(context.gvc, context.graph, "svg", &svg, &length) != 0)
    return fail(our_bug, "Graphviz could not render SVG");
  std::cout.write(svg, static_cast<std::streamsize>(length));
  gvFreeRenderData(svg);
  return std::cout.flush() ? 0 : fail(bad_input, "standard output cannot be written");
}

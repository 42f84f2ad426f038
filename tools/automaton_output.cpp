#include "tools/automaton_output.hpp"

#include <algorithm>
#include <optional>

#include "libautomata/deterministic/parity_game.hpp"
#include "libautomata/finite/guard.hpp"
#include "libautomata/hoa/dot_finite.hpp"
#include "libautomata/hoa/dot_omega.hpp"
#include "libautomata/hoa/exchange.hpp"
#include "libautomata/hoa/finite.hpp"
#include "libautomata/hoa/omega.hpp"
#include "libautomata/omega/edges.hpp"
#include "libltl/text/print.hpp"
#include "tools/answer.hpp"
#include "tools/picture.hpp"
#include "tools/shell/json.hpp"

namespace waymark::tools {
namespace {

// What all formats say of an automaton before its edges are looked at one by one.
struct Size {
  std::size_t states = 0, symbolic_nodes = 0, sets = 0;
  std::optional<std::size_t> edges;  // none: more than the limit
  bool deterministic = false;
};

Size measure(const automata::Dfa& dfa, std::size_t most_edges) {
  return {dfa.states(), automata::count_nodes(dfa), 1, automata::count_edges(dfa, most_edges), true};
}

Size measure(const automata::Automaton& automaton, std::size_t most_edges) {
  return {automaton.states(), automata::count_nodes(automaton), automaton.acceptance().sets,
          automata::count_edges(automaton.transitions(), most_edges),
          automata::is_deterministic(automaton.transitions())};
}

// In one line, without tabs.
std::string flat(std::string text) {
  std::replace_if(
      text.begin(), text.end(), [](char c) { return c == '\t' || c == '\n' || c == '\r'; }, ' ');
  return text;
}

constexpr std::string_view columns =
    "line\tstates\tedges\tsets\tdeterministic\tseconds\tstatus\tsymbolic_nodes\tformula\n";

// One row, tab-separated.
std::string row(const Shown& about, const std::optional<Size>& size) {
  const auto number = [](const std::optional<std::size_t>& n) { return n ? std::to_string(*n) : "-"; };
  std::string out = std::to_string(about.line) + '\t';
  if (size)
    out += std::to_string(size->states) + '\t' + number(size->edges) + '\t' + std::to_string(size->sets) +
           (size->deterministic ? "\t1\t" : "\t0\t");
  else
    out += "-\t-\t-\t-\t";
  out += fixed(about.seconds, 6) + '\t' + about.status + '\t';
  return out + (size ? std::to_string(size->symbolic_nodes) : "-") + '\t' + flat(about.text) + '\n';
}

JsonObject json_size(const Size& size, std::size_t propositions) {
  JsonObject out;
  out.add("states", size.states);
  if (size.edges) out.add("edges", *size.edges);
  return out.add("symbolic_nodes", size.symbolic_nodes).add("propositions", propositions);
}

template <class Any>
JsonArray reads_of(const Any& automaton) {
  JsonArray reads;
  for (const ltl::Proposition p : automaton.reads()) reads.add(automaton.vocabulary().name(p));
  return reads;
}

// All of JSON but the automaton itself.
template <class Any>
JsonObject automaton_json(const Any& automaton, const Size& size, const Shown& about, std::string_view status) {
  JsonObject out;
  out.add("formula", about.name)
      .add("semantics", about.semantics)
      .add("status", std::string(status))
      .add("automaton", json_size(size, automaton.reads().size()))
      .add("sets", size.sets)
      .add("deterministic", size.deterministic)
      .add("reads", reads_of(automaton))
      .add("seconds", about.seconds);
  if (!about.certificate.empty()) out.add("certificate", about.certificate);
  return out;
}

std::string none_within(Shown about, const std::string& problem, const OutputOptions& options) {
  about.status = "limit";
  return show_none(about, problem, options);
}

template <class Any>
Reply too_large(const Any& automaton, const Size& size, const Shown& about, const OutputOptions& options) {
  const std::string problem = "more than " + counted(options.edges, "edge") +
                              " (symbolic: " + counted(size.states, "state") + ", " +
                              counted(size.symbolic_nodes, "node") + ")";
  Reply reply{ExitCode::GaveUp, {}, problem};
  if (options.format == "json")
    reply.text = automaton_json(automaton, size, about, "limit").text() + '\n';
  else
    reply.text = none_within(about, problem, options);
  return reply;
}

template <class Any>
Reply show_or_refuse(const Any& automaton, const std::optional<std::string>& text, const Shown& about,
                     const OutputOptions& options) {
  if (text) return {ExitCode::Done, *text};
  return too_large(automaton, measure(automaton, options.edges), about, options);
}

// A comment: whose rows follow.
std::string whose(const Shown& about) {
  return "# line " + std::to_string(about.line) + (about.text.empty() ? "" : ": " + flat(about.text)) + '\n';
}

std::optional<std::string> with_whose(const std::optional<std::string>& table, const Shown& about) {
  return table ? std::optional(whose(about) + *table) : std::nullopt;
}

// A heading, then one edge a line; marks: "stop" where the word may stop behind the edge.
std::optional<std::string> dfa_table(const automata::Dfa& dfa, std::size_t most_edges) {
  if (!automata::count_edges(dfa, most_edges)) return std::nullopt;
  ltl::Arena arena(dfa.vocabulary());
  automata::Edges edges(dfa);
  std::string out = "source\ttarget\tmarks\tguard\n";
  for (std::uint32_t q = 0; q < dfa.states(); ++q) {
    const auto from = edges.from(automata::StateId{q}, most_edges);
    if (!from) return std::nullopt;
    for (const automata::Edge& edge : *from)
      out += std::to_string(q) + '\t' + std::to_string(edge.target.index) + '\t' +
             (dfa.is_accepting(edge.target) ? "stop" : "-") + '\t' +
             ltl::print(automata::to_formula(edge.guard, dfa, arena)) + '\n';
  }
  return out;
}

// In a format that knows fewer acceptance conditions; counters are added where states must accept.
std::optional<std::string> exchanged(const automata::Automaton& automaton, const Shown& about,
                                     const OutputOptions& options) {
  if (!automaton.acceptance().is_generalized_buchi())
    throw UsageError("--format " + options.format + " takes generalised Büchi automata, not " +
                     automata::print(automaton.acceptance().condition));
  if (options.format == "lbtt") return automata::write_lbtt(automaton, options.edges);
  automata::Budget budget;
  const automata::Automaton states = *automata::make_state_based(automaton, budget);
  if (options.format == "ba") return automata::write_ba(states, options.edges);
  return automata::write_never_claim(states, options.edges, about.name);
}

// Jumps as dotted arrows, which HOA cannot have.
std::optional<std::string> dot_of(const automata::MdpSafe& ldba, const Shown& about, std::size_t most_edges) {
  automata::OmegaDotOptions layout{.name = about.unicode_name};
  for (std::uint32_t q = 0; q < ldba.states(); ++q)
    for (const automata::StateId target : ldba.jumps(automata::StateId{q})) layout.jumps.emplace_back(q, target.index);
  const automata::Automaton steps(ldba.vocabulary(), ldba.reads(), ldba.steps());
  return automata::write_dot_within(steps, most_edges, layout);
}

std::optional<std::string> dot_of(const automata::Dfa& dfa, const Shown& about, std::size_t most_edges) {
  if (!automata::count_edges(dfa, most_edges)) return std::nullopt;
  return automata::write_dot(dfa, {.name = about.unicode_name});
}

std::optional<std::string> dot_of(const automata::Automaton& automaton, const Shown& about, std::size_t most_edges) {
  return automata::write_dot_within(automaton, most_edges, {.name = about.unicode_name});
}

// The parity game of the automaton, some propositions being those of the system.
std::string game_text(const automata::Automaton& automaton, const OutputOptions& options) {
  const auto parity = automata::Dpa::checked(automaton);
  if (!parity) throw UsageError("--format pgsolver takes deterministic parity automata: add --to parity");
  std::vector<ltl::Proposition> outputs;
  std::string_view rest = options.outputs;
  while (!rest.empty()) {
    const std::string_view name = rest.substr(0, rest.find(','));
    rest.remove_prefix(std::min(rest.size(), name.size() + 1));
    const auto output = automaton.vocabulary().find(name);
    if (!output) throw UsageError("--outputs: the formula has no proposition '" + std::string(name) + "'");
    outputs.push_back(*output);
  }
  automata::Budget budget(SIZE_MAX, options.edges, {});
  return automata::write_pgsolver(automata::parity_game(*parity, outputs, budget));
}

// Of limit-deterministic automata: what their HOA and JSON say besides.
struct Guesses {
  std::vector<std::string> properties, headers;
  JsonArray accepting_part, jumps;
};

Reply shown_omega(const automata::Automaton& automaton, const std::optional<Guesses>& guesses, const Shown& about,
                  const OutputOptions& options) {
  const std::string& format = options.format;
  const std::size_t most = options.edges;
  if (format == "stats") return {ExitCode::Done, row(about, measure(automaton, most))};
  if (format == "dot") return show_or_refuse(automaton, dot_of(automaton, about, most), about, options);
  if (format == "tsv")
    return show_or_refuse(automaton, with_whose(automata::write_table(automaton, most), about), about, options);
  if (format == "pgsolver") return {ExitCode::Done, game_text(automaton, options)};
  if (format == "never" || format == "lbtt" || format == "ba")
    return show_or_refuse(automaton, exchanged(automaton, about, options), about, options);
  automata::OmegaHoaOptions layout{
      .name = about.name,
      .marks_on_states = options.acceptance == "state",
      .layout = {.aliases = options.aliases, .one_line = options.one_line && format == "hoa"}};
  if (guesses) {
    layout.properties = guesses->properties;
    layout.headers = guesses->headers;
  }
  const std::optional<std::string> hoa = automata::write_hoa_within(automaton, most, layout);
  if (format == "hoa" || !hoa) return show_or_refuse(automaton, hoa, about, options);
  JsonObject out = automaton_json(automaton, measure(automaton, most), about, about.status);
  if (guesses) out.add("accepting_part", guesses->accepting_part).add("jumps", guesses->jumps);
  return {ExitCode::Done, out.add("hoa", *hoa).text() + '\n'};
}

// The reply, once the picture is drawn that was asked for.
template <class Any>
Reply drawn(Reply reply, const Any& automaton, const Shown& about, const OutputOptions& options) {
  if (options.svg.empty() || reply.code != ExitCode::Done) return reply;
  const auto dot = automaton.states() > most_drawn_states ? std::nullopt : dot_of(automaton, about, most_drawn_edges);
  if (dot) {
    draw_graph(*dot, options.svg, about.stop);
  } else {
    reply.code = ExitCode::GaveUp;
    reply.problem = "not drawn: more than " + counted(most_drawn_states, "state") + " or " +
                    counted(most_drawn_edges, "edge") + "; --format dot gives the graph as text";
  }
  return reply;
}

}  // namespace

void add_output_options(Command command, OutputOptions& options) {
  command = command.in("Output");
  command
      .add_option("--format", options.format,
                  "HOA, Graphviz DOT, one row of counts, JSON, a table; of infinite words also: never claim, "
                  "LBTT, BA, a parity game")
      .one_of({"hoa", "dot", "stats", "json", "tsv", "never", "lbtt", "ba", "pgsolver"})
      .show_default();
  command.add_flag_callback(
      "--json", [&options] { options.format = "json"; }, "the same as --format json");
  command.add_option("--outputs", options.outputs, "with --format pgsolver: the propositions that the system chooses")
      .type_name("a,b");
  command.add_flag("--one-line", options.one_line, "HOA: each automaton on one line");
  command.add_flag("--aliases", options.aliases, "HOA: labels that occur more than once get a name");
  command
      .add_option("--acceptance", options.acceptance,
                  "HOA: marks on states or edges; on states only where all edges of each state agree")
      .one_of({"state", "edge"})
      .show_default();
  command.add_option("--svg", options.svg, "draw the automaton; for a single one").type_name("FILE");
  command.add_option("--limit-edges", options.edges, "write no automaton with more edges; they are counted before")
      .type_name("N")
      .show_default();
}

std::string show_none(const Shown& about, const std::string& message, const OutputOptions& options) {
  if (options.format == "stats") return row(about, std::nullopt);
  if (options.format == "json")
    return JsonObject().add("line", about.line).add("status", about.status).add("message", message).text() + '\n';
  if (options.format == "hoa") return automata::aborted_hoa("", {.one_line = options.one_line});
  if (options.format == "tsv") return whose(about) + "# " + about.status + ": " + flat(message) + '\n';
  return "";
}

std::string heading(const OutputOptions& options) { return options.format == "stats" ? std::string(columns) : ""; }

namespace {

Reply shown_dfa(const automata::Dfa& dfa, const Shown& about, const OutputOptions& options) {
  if (options.format == "stats") return {ExitCode::Done, row(about, measure(dfa, options.edges))};
  if (options.format == "never" || options.format == "lbtt" || options.format == "ba" || options.format == "pgsolver")
    throw UsageError("--format " + options.format + " is one for infinite words");
  if (options.format == "tsv")
    return show_or_refuse(dfa, with_whose(dfa_table(dfa, options.edges), about), about, options);
  if (options.format == "dot") return show_or_refuse(dfa, dot_of(dfa, about, options.edges), about, options);
  const std::optional<std::string> hoa = automata::write_hoa_within(
      dfa, options.edges,
      {.name = about.name,
       .marks_on_edges = options.acceptance == "edge",
       .layout = {.aliases = options.aliases, .one_line = options.one_line && options.format == "hoa"}});
  if (!hoa) return too_large(dfa, measure(dfa, options.edges), about, options);
  if (options.format == "hoa") return {ExitCode::Done, *hoa};
  return {ExitCode::Done,
          automaton_json(dfa, measure(dfa, options.edges), about, about.status).add("hoa", *hoa).text() + '\n'};
}

Reply shown_ldba(const automata::MdpSafe& automaton, const Shown& about, const OutputOptions& options) {
  if (options.format == "dot")
    return show_or_refuse(automaton.automaton(), dot_of(automaton, about, options.edges), about, options);
  Guesses guesses;
  if (!automaton.is_deterministic()) guesses.properties.emplace_back("semi-deterministic");
  std::string parts = "waymark-accepting-part:", jumps = "waymark-jumps:";
  for (std::uint32_t q = 0; q < automaton.states(); ++q) {
    if (automaton.in_accepting_part(automata::StateId{q})) {
      guesses.accepting_part.add(std::size_t{q});
      parts += ' ' + std::to_string(q);
    }
    for (const automata::StateId target : automaton.jumps(automata::StateId{q})) {
      guesses.jumps.add(JsonObject().add("from", std::size_t{q}).add("to", std::size_t{target.index}));
      jumps += ' ' + std::to_string(q) + ' ' + std::to_string(target.index);
    }
  }
  guesses.headers = {parts, jumps};
  return shown_omega(automaton.automaton(), guesses, about, options);
}

}  // namespace

Reply show(const automata::Dfa& dfa, const Shown& about, const OutputOptions& options) {
  return drawn(shown_dfa(dfa, about, options), dfa, about, options);
}

Reply show(const automata::Automaton& automaton, const Shown& about, const OutputOptions& options) {
  return drawn(shown_omega(automaton, {}, about, options), automaton, about, options);
}

Reply show(const automata::MdpSafe& automaton, const Shown& about, const OutputOptions& options) {
  return drawn(shown_ldba(automaton, about, options), automaton, about, options);
}

}  // namespace waymark::tools

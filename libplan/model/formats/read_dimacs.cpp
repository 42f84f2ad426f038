#include "libplan/model/formats/read_dimacs.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fstream>
#include <map>
#include <optional>
#include <ostream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "libltl/diagnostic.hpp"
#include "libltl/text/foreign.hpp"
#include "libltl/text/read_text.hpp"
#include "libplan/model/prism/explicit_lines.hpp"

namespace waymark::plan {
namespace {

// Characters of a stream through one block of memory.
class Characters {
 public:
  explicit Characters(std::istream& in) : in_(in), block_(std::size_t{1} << 16U) {}
  static constexpr int end = -1;
  int peek() {
    if (at_ == size_ && !fill()) return end;
    return static_cast<unsigned char>(block_[at_]);
  }
  void skip() { ++at_; }
  std::string_view ahead() {
    return peek() == end ? std::string_view() : std::string_view(block_.data() + at_, size_ - at_);
  }

 private:
  bool fill() {
    in_.read(block_.data(), static_cast<std::streamsize>(block_.size()));
    at_ = 0;
    size_ = static_cast<std::size_t>(in_.gcount());
    return size_ > 0;
  }
  std::istream& in_;
  std::vector<char> block_;
  std::size_t at_ = 0, size_ = 0;
};

class ArcReader {
 public:
  ArcReader(std::istream& in, std::string_view source) : in_(in), source_(source) {}

  // Tails and arcs; the letters are left to be filled in.
  RoadGraph::Parts read() {
    ltl::refuse_foreign(in_.ahead(), source_, "roads in the format of DIMACS");
    for (; in_.peek() != Characters::end; end_line()) {
      const int kind = in_.peek();
      if (kind == 'a')
        arc();
      else if (kind == 'p')
        problem();
      else if (kind == 'c')
        while (in_.peek() != '\n' && in_.peek() != Characters::end) in_.skip();
      else if (kind != '\n' && kind != '\r')
        fail("expected a line c, p or a");
    }
    if (nodes_ == 0) fail("expected a line p sp NODES ARCS");
    if (parts_.arcs.size() != arcs_)
      fail("expected " + std::to_string(arcs_) + " arcs, there are " + std::to_string(parts_.arcs.size()));
    if (nodes_ > 1'000'000 + 16 * arcs_)
      fail("expected at most a million nodes, and 16 more for each arc");  // memory for nodes that a small file claims
    parts_.letter.assign(nodes_, 0);
    return std::move(parts_);
  }

 private:
  [[noreturn]] void fail(const std::string& message) const { throw ltl::FormatError(source_, line_, 0, message); }
  void end_line() {
    while (in_.peek() == ' ' || in_.peek() == '\t' || in_.peek() == '\r') in_.skip();
    if (in_.peek() != '\n' && in_.peek() != Characters::end) fail("expected the end of the line");
    if (in_.peek() == '\n') in_.skip();
    ++line_;
  }
  std::uint64_t number(std::uint64_t most) {
    while (in_.peek() == ' ' || in_.peek() == '\t') in_.skip();
    std::uint64_t out = 0;
    if (in_.peek() < '0' || in_.peek() > '9') fail("expected a whole number from 0 on");
    for (int c = in_.peek(); c >= '0' && c <= '9'; c = in_.peek()) {
      out = out * 10 + static_cast<std::uint64_t>(c - '0');
      if (out > most) fail("expected a number up to " + std::to_string(most));
      in_.skip();
    }
    return out;
  }
  std::uint32_t node() {
    const std::uint64_t out = number(nodes_);
    if (out == 0) fail("expected the number of a node, from 1 on");
    return static_cast<std::uint32_t>(out - 1);
  }
  void problem() {
    if (nodes_ != 0) fail("a second line p");
    for (const char c : std::string_view("p sp")) {
      if (in_.peek() != c) fail("expected p sp NODES ARCS");
      in_.skip();
    }
    nodes_ = number(RoadGraph::most_nodes);
    arcs_ = number(UINT32_MAX - 1);
    if (nodes_ == 0) fail("expected a node at least");
    make_room(std::size_t{1} << 20U);
  }
  // Of what the line p claims, no more than so many times the arcs that were read.
  void make_room(std::size_t most) {
    const std::size_t believed = std::min<std::size_t>(arcs_, most);
    parts_.tails.reserve(believed);
    parts_.arcs.reserve(believed + 1);
  }
  void arc() {
    if (nodes_ == 0) fail("expected the line p sp NODES ARCS before arcs");
    in_.skip();
    if (in_.peek() != ' ' && in_.peek() != '\t') fail("expected a FROM TO COST");
    const std::uint32_t tail = node(), head = node();
    if (parts_.tails.size() == parts_.tails.capacity()) make_room(64 * parts_.tails.size());
    parts_.tails.push_back(tail);
    parts_.arcs.push_back({head, static_cast<std::uint32_t>(number(RoadGraph::most_arc_cost))});
    if (parts_.arcs.size() > arcs_) fail("expected " + std::to_string(arcs_) + " arcs, here is one more");
  }

  Characters in_;
  std::string source_;
  std::size_t line_ = 1;
  std::uint64_t nodes_ = 0, arcs_ = 0;
  RoadGraph::Parts parts_;
};

struct Label {
  std::string name;
  std::optional<ltl::Proposition> proposition;  // none: init, deadlock
};

// The first line: 0="init" 1="a" …
std::map<std::uint32_t, Label> read_names(ExplicitLines& in, ltl::Vocabulary& vocabulary) {
  std::map<std::uint32_t, Label> out;
  if (!in.next()) in.fail(R"(expected the labels, such as 0="init" 1="a")");
  while (!in.at_end()) {
    const std::uint32_t number = in.index();
    in.expect('=');
    in.expect('"');
    const std::string name(in.until('"'));
    if (name.empty()) in.fail("a label without a name");
    Label label{name, {}};
    if (name != "init" && name != "deadlock") label.proposition = vocabulary.add(name);
    if (!out.emplace(number, label).second) in.fail("two labels have this number");
  }
  return out;
}

// Fills in letters and start.
void read_labels(std::istream& lab, const std::string& source, std::string_view start, RoadGraph::Parts& parts) {
  ExplicitLines in(lab, source);
  ltl::Vocabulary vocabulary;
  const std::map<std::uint32_t, Label> labels = read_names(in, vocabulary);
  if (vocabulary.size() == 0) in.fail("there is no label: nothing has a name that a formula could use");
  parts.letters = Letters(vocabulary);
  parts.letters.intern({});
  std::uint64_t number = 0;
  const bool numbered =
      std::from_chars(start.data(), start.data() + start.size(), number).ptr == start.data() + start.size() &&
      !start.empty();
  std::optional<std::uint32_t> named, first;
  const std::string_view wanted = start.empty() ? "init" : start;
  while (in.next()) {
    const std::uint32_t node = in.index_below(parts.letter.size() + 1, "node");
    if (node == 0) in.fail("nodes are numbered from 1");
    in.expect(':');
    ltl::Letter letter = parts.letters[LetterId{parts.letter[node - 1]}];
    while (!in.at_end()) {
      const std::uint32_t which = in.index();
      const auto label = labels.find(which);
      if (label == labels.end()) in.fail("there is no label " + std::to_string(which));
      if (label->second.proposition) letter.insert(*label->second.proposition);
      if (!named && label->second.name == wanted) named = node - 1;
      if (!first && label->second.proposition) first = node - 1;
    }
    const LetterId id = parts.letters.intern(letter);
    if (id.index >= RoadGraph::most_letters) in.fail("expected at most 65,536 different sets of labels");
    parts.letter[node - 1] = static_cast<std::uint16_t>(id.index);
  }
  if (numbered && number >= 1 && number <= parts.letter.size()) named = static_cast<std::uint32_t>(number - 1);
  if (!named && start.empty()) named = first;
  if (!named) {
    if (start.empty()) throw ltl::FormatError(source, 0, 0, "no node has a label");
    std::string message = "there is no node or label '" + std::string(start) + "'";
    if (const auto meant = vocabulary.nearest(start)) message += " (did you mean '" + *meant + "'?)";
    throw ltl::FormatError(source, 0, 0, message);
  }
  parts.start = *named;
}

}  // namespace

RoadGraph parse_dimacs(std::istream& gr, std::istream& lab, std::string_view source, std::string_view start) {
  RoadGraph::Parts parts = ArcReader(gr, source).read();
  std::filesystem::path labels(source);
  read_labels(lab, labels.replace_extension(".lab").string(), start, parts);
  return RoadGraph(std::move(parts));
}

RoadGraph read_dimacs(const std::filesystem::path& gr, std::string_view start) {
  std::filesystem::path lab = gr;
  std::ifstream roads = ltl::open_text(gr), labels = ltl::open_text(lab.replace_extension(".lab"));
  return parse_dimacs(roads, labels, gr.string(), start);
}

void write_dimacs(std::ostream& gr, std::ostream& lab, const StateLabelled& model) {
  const Mdp& mdp = model.mdp;
  if (!mdp.is_deterministic())
    throw std::invalid_argument("DIMACS roads have no chances: the model is not deterministic");
  bool whole = true;
  for (std::uint32_t s = 0; s < mdp.states(); ++s)
    for (std::uint32_t k = 0; k < mdp.choices(s); ++k)
      whole = whole && std::nearbyint(mdp.cost(s, k)) == mdp.cost(s, k);
  const double scale = whole ? 1 : 100;
  gr << "c nodes are the states of the model, counted from 1; costs in "
     << (whole ? "its unit" : "hundredths of its unit") << "\np sp " << mdp.states() << ' ' << mdp.choices() << '\n';
  lab << "0=\"init\"";
  const ltl::Vocabulary& names = mdp.letters().vocabulary();
  for (std::size_t p = 0; p < names.size(); ++p) lab << ' ' << p + 1 << "=\"" << names.names()[p] << '"';
  lab << '\n';
  for (std::uint32_t s = 0; s < mdp.states(); ++s) {
    for (std::uint32_t k = 0; k < mdp.choices(s); ++k) {
      const double cost = std::nearbyint(mdp.cost(s, k) * scale);
      if (!(cost <= RoadGraph::most_arc_cost)) throw std::invalid_argument("a cost of 2^31 or more");
      gr << "a " << s + 1 << ' ' << mdp.outcome(s, k, 0).target + 1 << ' ' << static_cast<std::uint32_t>(cost) << '\n';
    }
    const auto& members = mdp.letters()[model.letter[s]].members();
    if (members.empty() && s != mdp.initial()) continue;
    lab << s + 1 << ':';
    if (s == mdp.initial()) lab << " 0";
    for (const ltl::Proposition p : members) lab << ' ' << p.index + 1;
    lab << '\n';
  }
}

}  // namespace waymark::plan

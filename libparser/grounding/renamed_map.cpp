#include "libparser/grounding/renamed_map.hpp"

#include <algorithm>
#include <optional>
#include <set>

#include "libltl/structure/substitute.hpp"
#include "libplan/world/labelling.hpp"

namespace waymark::parser {
namespace {

using plan::Kind;

bool is_named(Kind kind) { return kind == Kind::Object || kind == Kind::Floor || kind == Kind::Painting; }

// The names of one kind, each once, in the order of the vocabulary.
std::vector<std::string> names_of(const std::vector<plan::Observable>& observables, Kind kind) {
  std::vector<std::string> out;
  for (const plan::Observable& o : observables)
    if (o.kind == kind && std::find(out.begin(), out.end(), o.name) == out.end()) out.push_back(o.name);
  return out;
}

int places_of(const std::vector<plan::Observable>& observables) {
  int most = 0;
  for (const plan::Observable& o : observables)
    if (o.kind == Kind::PlaceNumber) most = std::max(most, std::stoi(o.name));
  return most;
}

std::vector<std::pair<Kind, std::string>> mentioned_in(const ltl::Vocabulary& own, const std::vector<Mention>& mentions,
                                                       const std::vector<NamedThing>& things) {
  const std::vector<plan::Observable> observables = plan::observables_of(own);
  std::vector<std::pair<Kind, std::string>> out;
  for (const Mention& mention : mentions)
    if (const auto p = own.find(things[mention.thing].name))
      out.emplace_back(observables[p->index].kind, observables[p->index].name);
  return out;
}

}  // namespace

RenamedMap::Names RenamedMap::assigned(const ltl::Vocabulary& trained, const ltl::Vocabulary& own,
                                       const std::vector<Key>& mentioned) {
  const std::vector<plan::Observable> theirs = plan::observables_of(trained), ours = plan::observables_of(own);
  Names names;
  for (const Kind kind : {Kind::Object, Kind::Floor, Kind::Painting}) {
    std::vector<std::string> wanted;  // what is mentioned first
    const auto want = [&](const std::string& name) {
      if (std::find(wanted.begin(), wanted.end(), name) == wanted.end()) wanted.push_back(name);
    };
    for (const auto& [of_kind, name] : mentioned)
      if (of_kind == kind) want(name);
    for (const std::string& name : names_of(ours, kind)) want(name);
    std::vector<std::string> free = names_of(theirs, kind);
    const auto take = [&](const std::string& name, std::vector<std::string>::iterator at) {
      names.trained_for[{kind, name}] = *at;
      names.own_for[{kind, *at}] = name;
      free.erase(at);
    };
    for (const std::string& name : wanted)  // names that both have stay
      if (const auto same = std::find(free.begin(), free.end(), name); same != free.end()) take(name, same);
    for (const std::string& name : wanted)
      if (!free.empty() && !names.trained_for.contains({kind, name})) take(name, free.begin());
  }
  return names;
}

plan::Map RenamedMap::renamed(const ltl::Vocabulary& trained, const plan::Map& map, const Names& names) {
  const std::vector<plan::Observable> observables = plan::observables_of(trained);
  const auto renamed_to = [&](Kind kind, const std::string& name) -> std::optional<std::string> {
    const auto found = names.trained_for.find({kind, name});
    return found == names.trained_for.end() ? std::nullopt : std::optional(found->second);
  };
  const int places = places_of(observables);
  std::vector<plan::Node> nodes = map.nodes();
  bool has_last = places == 0;
  for (plan::Node& node : nodes) {
    if (node.object) node.object = renamed_to(Kind::Object, *node.object);
    if (node.place && *node.place > places) node.place.reset();
    has_last = has_last || node.place == places;
  }
  if (!has_last) {  // the vocabulary of a map goes as far as its numbers of places
    const auto unnumbered = std::find_if(nodes.rbegin(), nodes.rend(), [](const auto& n) { return !n.place; });
    (unnumbered == nodes.rend() ? nodes.back() : *unnumbered).place = places;
  }
  std::vector<plan::Edge> edges = map.edges();
  for (plan::Edge& edge : edges) {
    edge.floor = renamed_to(Kind::Floor, edge.floor).value_or("");
    edge.wall = renamed_to(Kind::Painting, edge.wall).value_or("");
  }
  return {map.name(),
          nodes,
          edges,
          names_of(observables, Kind::Object),
          names_of(observables, Kind::Floor),
          names_of(observables, Kind::Painting)};
}

RenamedMap::RenamedMap(const ltl::Vocabulary& trained, const plan::Map& map, const std::vector<std::string>& tokens,
                       const std::vector<Mention>& mentions, const std::vector<NamedThing>& things)
    : names_(assigned(trained, map.vocabulary(), mentioned_in(map.vocabulary(), mentions, things))),
      observables_(plan::observables_of(trained)),
      map_(renamed(trained, map, names_)) {
  const std::vector<plan::Observable> own = plan::observables_of(map.vocabulary());
  static const std::set<std::string, std::less<>> ways{"floor",    "hall", "hallway", "corridor", "path",
                                                       "flooring", "way",  "alley",   "tiles",    "carpet"};
  const auto add = [&](const std::string& word) { text_ += (text_.empty() ? "" : " ") + word; };
  std::size_t at = 0;
  for (const Mention& mention : mentions) {
    for (; at < mention.begin; ++at) add(tokens[at]);
    const auto p = map.vocabulary().find(things[mention.thing].name);
    const auto alias = p ? names_.trained_for.find({own[p->index].kind, own[p->index].name}) : names_.trained_for.end();
    if (alias == names_.trained_for.end()) {
      for (; at < mention.end; ++at) add(tokens[at]);
      continue;
    }
    add(alias->second);
    at = mention.end;
    if (own[p->index].kind == Kind::Floor && (at == tokens.size() || !ways.contains(tokens[at]))) add("hallway");
  }
  for (; at < tokens.size(); ++at) add(tokens[at]);
}

ltl::Formula RenamedMap::in_own_names(ltl::Formula f, ltl::Arena& arena) const {
  return ltl::substitute(f, arena, [&](ltl::Proposition p) {
    plan::Observable observable = observables_[p.index];
    if (is_named(observable.kind)) {
      const auto own = names_.own_for.find({observable.kind, observable.name});
      if (own == names_.own_for.end()) return arena.constant(false);
      observable.name = own->second;
    }
    const auto ours = arena.vocabulary().find(plan::proposition_name(observable));
    return ours ? arena.atom(*ours) : arena.constant(false);
  });
}

}  // namespace waymark::parser

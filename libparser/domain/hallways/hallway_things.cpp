#include "libparser/domain/hallways/hallway_things.hpp"

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

#include "libparser/corpus/token.hpp"
#include "libparser/lexicon/lexicon.hpp"
#include "libplan/world/observable.hpp"

namespace waymark::parser {
namespace {

using plan::Direction;
using plan::Kind;

std::vector<std::string> words_of(const std::string& name) {
  std::string text = name;
  std::replace(text.begin(), text.end(), '_', ' ');
  std::vector<std::string> words = tokenize(text);
  for (std::string& word : words) word = singular(std::move(word));
  return words;
}

// Names of furniture that commands use and the lexicon of route instructions lacks.
constexpr std::array<std::pair<std::string_view, std::string_view>, 20> more_names{
    {{"sofa", "settee"},       {"sofa", "divan"},           {"sofa", "davenport"},      {"sofa", "loveseat"},
     {"sofa", "love seat"},    {"hatrack", "hat stand"},    {"hatrack", "coat stand"},  {"hatrack", "coat tree"},
     {"hatrack", "hat tree"},  {"hatrack", "hatstand"},     {"lamp", "lantern"},        {"lamp", "lampstand"},
     {"lamp", "light bulb"},   {"barstool", "bar chair"},   {"barstool", "high stool"}, {"easel", "art stand"},
     {"easel", "paint stand"}, {"easel", "painting stand"}, {"easel", "canvas stand"},  {"chair", "arm chair"}}};

std::string joined(const std::vector<std::string>& words) {
  std::string out;
  for (const std::string& word : words) out += (out.empty() ? "" : " ") + word;
  return out;
}

NamedThing named(const plan::Observable& observable) {
  NamedThing thing{observable.name, {}};
  if (observable.kind == Kind::PlaceNumber) {
    for (const char* noun : {"position", "place", "spot", "number", "location", "node", "point", "pos", "no"}) {
      thing.phrases.push_back({noun, observable.name});
      thing.phrases.push_back({noun, "number", observable.name});
    }
    return thing;
  }
  thing.phrases.push_back(words_of(observable.name));
  for (const std::string& other : other_names(observable.name)) thing.phrases.push_back(words_of(other));
  for (const auto& [name, other] : more_names)
    if (name == observable.name) thing.phrases.push_back(words_of(std::string(other)));
  if (observable.name == "concrete") thing.phrases.push_back({"stone"});  // before gravel, which the lexicon prefers
  return thing;
}

template <std::size_t n>
bool is_among(const std::array<std::string_view, n>& words, const std::string& word) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

constexpr std::array<std::string_view, 30> surfaces{
    "hall", "hallway", "floor",   "flooring", "path",    "corridor", "alley",   "tile",    "carpet", "carpeting",
    "road", "street",  "lane",    "area",     "section", "passage",  "stretch", "surface", "patch",  "rug",
    "bit",  "part",    "pathway", "walkway",  "picture", "painting", "poster",  "mural",   "ground", "passageway"};
constexpr std::array<std::string_view, 8> joints{"with", "of", "has", "have", "that", "the", "a", "in"};

class Absorbing {
 public:
  Absorbing(const std::vector<std::string>& tokens, std::vector<Mention> mentions, const std::vector<Kind>& kinds)
      : mentions_(std::move(mentions)), kinds_(kinds) {
    for (const std::string& token : tokens) words_.push_back(singular(token));
  }

  // Neighbouring words for one thing are one mention, with the nouns around them that say what kind of thing it is.
  std::vector<Mention> run() {
    std::vector<Mention> out;
    for (Mention m : mentions_) {
      if (!out.empty() && out.back().end == m.begin && kinds_[out.back().thing] == kinds_[m.thing] &&
          (out.back().thing == m.thing || kinds_[m.thing] == Kind::Floor)) {
        out.back().end = extended(m).end;
        continue;
      }
      if (!out.empty() && out.back().end > m.begin) continue;
      out.push_back(extended(m));
    }
    return out;
  }

 private:
  bool is_surface(std::size_t at) const { return at < words_.size() && is_among(surfaces, words_[at]); }

  Mention extended(Mention m) const {
    if (kinds_[m.thing] != Kind::Floor && kinds_[m.thing] != Kind::Painting) return m;
    while (is_surface(m.end)) ++m.end;
    if (m.end + 2 < words_.size() && (words_[m.end] == "on" || words_[m.end] == "in") && words_[m.end + 1] == "the" &&
        (words_[m.end + 2] == "wall" || words_[m.end + 2] == "floor" || words_[m.end + 2] == "ground"))
      m.end += 3;
    std::size_t at = m.begin;
    while (at > 0 && is_among(joints, words_[at - 1])) --at;
    if (at < m.begin && at > 0 && is_surface(at - 1)) m.begin = at - 1;
    return m;
  }

  std::vector<std::string> words_;
  std::vector<Mention> mentions_;
  const std::vector<Kind>& kinds_;
};

// "without crossing the grass" names no crossing.
bool is_verb(const std::vector<std::string>& tokens, const Mention& mention) {
  constexpr std::array<std::string_view, 9> before{"without", "avoid", "avoiding", "before", "after",
                                                   "by",      "not",   "never",    "from"};
  constexpr std::array<std::string_view, 9> after{"the", "a", "an", "any", "it", "over", "that", "this", "these"};
  return mention.end == mention.begin + 1 && tokens[mention.begin] == "crossing" && mention.begin > 0 &&
         is_among(before, tokens[mention.begin - 1]) && mention.end < tokens.size() &&
         is_among(after, tokens[mention.end]);
}

// "positions 2 and 6": numbers that continue a list of places name places too. After such a noun, words for numbers
// become digits.
std::vector<std::string> with_places(std::vector<std::string> tokens) {
  constexpr std::array<std::string_view, 6> nouns{"position", "place", "spot", "location", "node", "point"};
  std::vector<std::string> out;
  bool listing = false;
  for (std::size_t i = 0; i < tokens.size(); ++i) {
    const std::string word = singular(tokens[i]);
    const std::size_t n = number_named(word);
    const std::string before = i > 0 ? singular(tokens[i - 1]) : "";
    const bool after_noun = word != "one" && (is_among(nouns, before) || before == "number");
    if (n > 0 && after_noun) {
      out.push_back(std::to_string(n));
      listing = true;
    } else if (n > 0 && listing &&
               (before == "and" || before == "," || before == "or" || before == "then" || before == "to")) {
      out.push_back("position");
      out.push_back(std::to_string(n));
    } else {
      listing = listing && (word == "and" || word == "," || word == "or" || word == "then" || word == "to" || n > 0);
      out.push_back(tokens[i]);
    }
  }
  return out;
}

}  // namespace

HallwayThings::HallwayThings(const ltl::Vocabulary& vocabulary, const Synonyms* synonyms) {
  for (const plan::Observable& observable : plan::observables_of(vocabulary)) {
    if (observable.kind == Kind::Event || observable.name == "open" || observable.name == "corridor") continue;
    const bool known =
        std::any_of(things_.begin(), things_.end(), [&](const NamedThing& t) { return t.name == observable.name; });
    if (known) continue;
    things_.push_back(named(observable));
    kinds_.push_back(observable.kind);
  }
  if (synonyms) add(*synonyms);
}

// Names come first: a synonym of one thing that another is called names the other.
void HallwayThings::add(const Synonyms& synonyms) {
  const auto is_name = [&](const std::vector<std::string>& phrase) {
    return std::any_of(things_.begin(), things_.end(), [&](const NamedThing& t) {
      return std::find(t.phrases.begin(), t.phrases.end(), phrase) != t.phrases.end();
    });
  };
  for (std::size_t t = 0; t < things_.size(); ++t) {
    if (kinds_[t] != Kind::Object && kinds_[t] != Kind::Floor) continue;
    const std::string name = joined(things_[t].phrases.front());
    for (const std::string& other : synonyms.of(name)) {
      std::vector<std::string> phrase = words_of(other);
      if (!is_name(phrase) && !(phrase.size() == 1 && is_among(surfaces, phrase.front())))
        things_[t].phrases.push_back(std::move(phrase));
    }
  }
}

LiftedMentions HallwayThings::lift(const std::vector<std::string>& tokens, const WordVectors* known) const {
  return lift(with_places(tokens), {}, known);
}

LiftedMentions HallwayThings::lift(const std::vector<std::string>& words, std::vector<Mention> given,
                                   const WordVectors* known) const {
  std::vector<Mention> mentions = find_mentions(words, things_, known);
  std::erase_if(mentions, [&](const Mention& m) {
    return is_verb(words, m) || std::any_of(given.begin(), given.end(), [&](const Mention& other) {
             return m.begin < other.end && other.begin < m.end;
           });
  });
  mentions.insert(mentions.end(), given.begin(), given.end());
  std::stable_sort(mentions.begin(), mentions.end(),
                   [](const Mention& a, const Mention& b) { return a.begin < b.begin; });
  LiftedMentions out = parser::lift(words, Absorbing(words, std::move(mentions), kinds_).run());
  out.text.scope.spatial = true;
  return out;
}

std::optional<ltl::Formula> HallwayThings::literal(ltl::Arena& arena, LiftedSymbol direction, std::size_t thing) const {
  const std::string& name = things_[thing].name;
  const auto atom = [&](Direction d) -> std::optional<ltl::Formula> {
    const auto p = arena.vocabulary().find(plan::proposition_name({d, kinds_[thing], name}));
    return p ? std::optional(arena.atom(*p)) : std::nullopt;
  };
  const auto along = [&]() -> std::optional<ltl::Formula> {
    const auto behind = atom(Direction::Behind);
    const auto moved = arena.vocabulary().find("moved");
    if (!behind || !moved || (kinds_[thing] != Kind::Floor && kinds_[thing] != Kind::Painting)) return std::nullopt;
    return ltl::conjunction(arena.atom(*moved), *behind);
  };
  switch (direction) {
    case LiftedSymbol::Ahead: return atom(Direction::Ahead);
    case LiftedSymbol::Right: return atom(Direction::Right);
    case LiftedSymbol::Behind: return atom(Direction::Behind);
    case LiftedSymbol::Left: return atom(Direction::Left);
    case LiftedSymbol::Beside: return atom(Direction::Next);
    case LiftedSymbol::Along: return along();
    default: break;
  }
  if (kinds_[thing] == Kind::Painting) return along();
  if (kinds_[thing] == Kind::Passage) return atom(Direction::Ahead);
  return atom(Direction::Here);
}

Bindings HallwayThings::bindings(ltl::Arena& arena, std::vector<std::size_t> slots,
                                 std::optional<std::size_t> start) const {
  return {&arena,
          [this, &arena, slots = std::move(slots), start](LiftedSymbol direction,
                                                          LiftedSymbol thing) -> std::optional<ltl::Formula> {
            if (is_slot(thing)) {
              if (number_of(thing) > slots.size()) return std::nullopt;
              return literal(arena, direction, slots[number_of(thing) - 1]);
            }
            std::string name = thing == LiftedSymbol::TurnedLeft    ? "turned_left"
                               : thing == LiftedSymbol::TurnedRight ? "turned_right"
                               : thing == LiftedSymbol::Moved       ? "moved"
                               : thing == LiftedSymbol::OpenLeft    ? "left_open"
                               : thing == LiftedSymbol::OpenRight   ? "right_open"
                                                                    : "";
            if (thing == LiftedSymbol::Start) name = start ? "place_" + std::to_string(*start) : "start";
            const auto p = name.empty() ? std::nullopt : arena.vocabulary().find(name);
            return p && direction == LiftedSymbol::End ? std::optional(arena.atom(*p)) : std::nullopt;
          }};
}

std::optional<std::size_t> place_number(const plan::Map& map, std::span<const plan::PoseId> poses) {
  std::optional<std::size_t> number;
  for (const plan::PoseId p : poses) {
    const auto place = map.nodes()[map.node_of(p)].place;
    if (!place || (number && *number != static_cast<std::size_t>(*place))) return std::nullopt;
    number = static_cast<std::size_t>(*place);
  }
  return number;
}

}  // namespace waymark::parser

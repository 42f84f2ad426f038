#include "libparser/domain/commands/command_domain.hpp"

#include <algorithm>
#include <array>
#include <cctype>

#include "libltl/diagnostic.hpp"
#include "libltl/text/parse.hpp"
#include "libparser/corpus/token.hpp"
#include "libparser/domain/commands/file_text.hpp"
#include "libparser/domain/commands/landmark_mentions.hpp"
#include "libplan/world/json_reader.hpp"

namespace waymark::parser {
namespace {

std::vector<std::string> split(std::string name) {
  std::replace(name.begin(), name.end(), '_', ' ');
  std::vector<std::string> words = tokenize(name);
  for (std::string& word : words) word = singular(std::move(word));
  return words;
}

struct Numeral {
  std::array<const char*, 5> words;
};
constexpr Numeral numerals[] = {{{"one", "1", "first", "1st", "i"}},
                                {{"two", "2", "second", "2nd", "ii"}},
                                {{"three", "3", "third", "3rd", "iii"}},
                                {{"four", "4", "fourth", "4th", "iv"}},
                                {{"five", "5", "fifth", "5th", "v"}}};

const Numeral* numeral_of(const std::string& word) {
  for (const Numeral& n : numerals)
    if (std::find(n.words.begin(), n.words.end(), word) != n.words.end()) return &n;
  return nullptr;
}

// "first_floor": first floor, 1st floor, floor 1 …; "blue_room": blue room, blue, when nothing else begins so.
NamedThing thing_of(const std::string& proposition, const std::vector<std::string>& all) {
  NamedThing thing{proposition, {}};
  const std::vector<std::string> words = split(proposition);
  thing.phrases.push_back(words);
  if (words.size() != 2) return thing;
  for (const std::size_t at : {std::size_t{0}, std::size_t{1}})
    if (const Numeral* n = numeral_of(words[at]))
      for (const char* other : n->words) {
        thing.phrases.push_back({other, words[1 - at]});
        thing.phrases.push_back({words[1 - at], other});
      }
  const bool first_tells = std::count_if(all.begin(), all.end(), [&](const std::string& other) {
                             return split(other).front() == words[0];
                           }) == 1;
  if (first_tells && numeral_of(words[0]) == nullptr) {
    thing.phrases.push_back({words[0]});
    for (const char* noun : {"area", "square", "region", "zone", "rm", "box", "space", "section"})
      thing.phrases.push_back({words[0], noun});
  }
  return thing;
}

bool is_letter_name(const std::string& word) {
  if (word.size() == 1) return std::isalpha(static_cast<unsigned char>(word[0])) != 0;
  return word.size() == 2 && word[0] == 'x' && std::isdigit(static_cast<unsigned char>(word[1])) != 0;
}

}  // namespace

CommandDomain CommandDomain::with_letters(std::string name, std::vector<std::string> names) {
  CommandDomain domain;
  domain.network_domain_ = name;
  domain.name_ = std::move(name);
  domain.letters_ = true;
  domain.propositions_ = std::move(names);
  return domain;
}

CommandDomain CommandDomain::small(std::string name, const std::vector<std::string>& propositions) {
  CommandDomain domain;
  domain.network_domain_ = name;
  domain.name_ = std::move(name);
  domain.propositions_ = propositions;
  std::sort(domain.propositions_.begin(), domain.propositions_.end());
  for (const std::string& p : domain.propositions_) domain.things_.push_back(thing_of(p, domain.propositions_));
  domain.constants_ = domain.propositions_;
  if (domain.constants_.size() > most_constants) domain.constants_.resize(most_constants);
  return domain;
}

CommandDomain CommandDomain::city(std::string name, const std::vector<Landmark>& landmarks) {
  CommandDomain domain;
  domain.network_domain_ = "lifted";  // the same commands, with landmarks for letters
  domain.name_ = std::move(name);
  for (const Landmark& landmark : landmarks) domain.landmarks_.push_back(landmark.proposition);
  domain.city_ = std::make_shared<const CityWords>(landmarks);
  return domain;
}

CommandDomain CommandDomain::of_things(const Command& command) {
  std::vector<Landmark> landmarks;
  for (const auto& [key, name] : command.things) {
    std::string proposition = key;
    std::transform(proposition.begin(), proposition.end(), proposition.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    landmarks.push_back({std::move(proposition), name, {}, {}});
  }
  CommandDomain domain = city(command.domain, landmarks);
  domain.network_domain_.clear();
  return domain;
}

std::vector<NamedThing> CommandDomain::named_things() const {
  if (!city_) return things_;
  std::vector<NamedThing> out;
  for (std::size_t i = 0; i < landmarks_.size(); ++i) {
    NamedThing thing{landmarks_[i], {}};
    for (const auto& words : city_->names(i).sequences)
      if (!words.empty()) thing.phrases.push_back(words);
    out.push_back(std::move(thing));
  }
  return out;
}

std::optional<std::size_t> CommandDomain::landmark(const std::string& proposition) const {
  const auto it = std::find(landmarks_.begin(), landmarks_.end(), proposition);
  return it == landmarks_.end() ? std::nullopt : std::optional(static_cast<std::size_t>(it - landmarks_.begin()));
}

std::vector<CommandDomain::Lift> CommandDomain::lift(const std::string& text, const MentionModel& model) const {
  if (city_) {
    std::vector<Lift> out;
    for (LandmarkLift& l : lift_landmarks(text, *city_, model)) {
      Lift lifted{std::move(l.text), {}, l.probability};
      for (const std::size_t landmark : l.slots) lifted.slots.push_back(landmarks_[landmark]);
      lifted.text.domain = network_domain_;
      out.push_back(std::move(lifted));
    }
    const std::size_t named = out.size();  // each is also read as a command of no domain, whose kinds lifted ones lack
    for (std::size_t i = 0; i < named; ++i) {
      out[i].probability *= 0.5;
      out.push_back(out[i]);
      out.back().text.domain.clear();
    }
    return out;
  }
  const std::vector<std::string> tokens = tokenize(text);
  Lift out;
  if (letters_) {
    std::vector<NamedThing> things;
    std::vector<Mention> mentions;
    for (std::size_t i = 0; i < tokens.size(); ++i) {
      const bool names = propositions_.empty()
                             ? is_letter_name(tokens[i])
                             : std::find(propositions_.begin(), propositions_.end(), tokens[i]) != propositions_.end();
      if (!names) continue;
      std::size_t t = 0;
      while (t < things.size() && things[t].name != tokens[i]) ++t;
      if (t == things.size()) things.push_back({tokens[i], {}});
      mentions.push_back({i, i + 1, t});
    }
    LiftedMentions lifted = parser::lift(tokens, mentions, Articles::Stay);
    out.text = std::move(lifted.text);
    for (const std::size_t t : lifted.things) out.slots.push_back(things[t].name);
  } else {
    // A constant may be told by a name that is said: "push the chair into the blue room".
    LiftedMentions lifted = parser::lift(tokens, find_mentions(tokens, things_), Articles::Go, Names::Stay);
    out.text = std::move(lifted.text);
    for (const std::size_t t : lifted.things) out.slots.push_back(things_[t].name);
  }
  out.text.scope.constants = constants_.size();
  out.text.domain = network_domain_;
  return {out};
}

Bindings CommandDomain::bindings(ltl::Arena& arena, std::vector<std::string> slots) const {
  return {&arena,
          [this, &arena, slots = std::move(slots)](LiftedSymbol direction,
                                                   LiftedSymbol thing) -> std::optional<ltl::Formula> {
            if (direction != LiftedSymbol::End || !is_thing(thing)) return std::nullopt;
            const auto& names = is_slot(thing) ? slots : constants_;
            const std::size_t n = number_of(thing);
            return n <= names.size() ? std::optional(arena.atom(names[n - 1])) : std::nullopt;
          }};
}

std::optional<Lifted> CommandDomain::label(const Lift& lift, const std::string& formula) const {
  ltl::Arena arena;
  const ltl::Formula f = ltl::parse(formula, arena);
  return spell(f, [&](ltl::Proposition p) -> std::optional<Lifted> {
    const std::string& name = arena.vocabulary().name(p);
    const auto at = std::find(lift.slots.begin(), lift.slots.end(), name);
    if (at != lift.slots.end()) return Lifted{slot(static_cast<std::size_t>(at - lift.slots.begin()) + 1)};
    const auto c = std::find(constants_.begin(), constants_.end(), name);
    if (c == constants_.end()) return std::nullopt;
    return Lifted{constant(static_cast<std::size_t>(c - constants_.begin()) + 1)};
  });
}

CommandDomains::CommandDomains(const std::filesystem::path& domains, std::filesystem::path maps)
    : file_(domains.string()), maps_(std::move(maps)) {
  const std::string text = text_of(domains);
  const plan::JsonReader in(text, file_);
  const plan::JsonReader::Value document = in.parse();
  if (!document.is_object()) in.fail("", "expected an object of domains");
  for (const auto& [name, domain] : document.items()) {
    std::vector<std::string> propositions;
    const auto& named = in.member(domain, name, "propositions");
    if (named.is_array()) {
      propositions = in.strings(named, name + ".propositions");
    } else {
      if (!named.is_object()) in.fail(name + ".propositions", "expected a list of names, or an object of names");
      for (const auto& [proposition, said] : named.items()) propositions.push_back(proposition);
    }
    const bool letters =
        std::all_of(propositions.begin(), propositions.end(), [](const std::string& p) { return p.size() == 1; });
    domains_.emplace(
        name, letters ? CommandDomain::with_letters(name, propositions) : CommandDomain::small(name, propositions));
  }
}

const CommandDomain& CommandDomains::of(const std::string& name) {
  const auto known = domains_.find(name);
  if (known != domains_.end()) return known->second;
  if (file_.empty())
    throw ltl::FormatError("domains.json", 0, 0, "no such file beside the commands: what does '" + name + "' name?");
  const auto colon = name.find(':');
  if (colon == std::string::npos || name.find('/') != std::string::npos)
    throw ltl::FormatError(file_, 0, 0, "no domain is called '" + name + "'");
  const auto landmarks = read_landmarks(maps_ / (name.substr(colon + 1) + ".json"));
  return domains_.emplace(name, CommandDomain::city(name, landmarks)).first->second;
}

CommandDomain CommandDomains::of(const Command& command) {
  return command.marked ? CommandDomain::of_things(command) : of(command.domain);
}

}  // namespace waymark::parser

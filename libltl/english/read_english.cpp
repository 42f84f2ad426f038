#include "libltl/english/read_english.hpp"

#include <algorithm>
#include <charconv>
#include <map>
#include <string>
#include <vector>

#include "libltl/english/match.hpp"
#include "libltl/english/phrase.hpp"
#include "libltl/structure/substitute.hpp"

namespace waymark::ltl {
namespace {

using Formulas = std::vector<Formula>;  // all that a text may mean

// Where `wanted` stands in `text` from position `from` on, outside of quoted names.
std::size_t find_unquoted(std::string_view text, std::string_view wanted, std::size_t from) {
  bool quoted = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (!quoted && i >= from && text.substr(i).starts_with(wanted)) return i;
    if (quoted && text[i] == '\\')
      ++i;
    else if (text[i] == '"')
      quoted = !quoted;
  }
  return std::string_view::npos;
}

std::vector<std::string_view> split(std::string_view text, std::string_view between) {
  std::vector<std::string_view> out;
  for (std::size_t end = 0; end != std::string_view::npos;) {
    end = find_unquoted(text, between, 0);
    out.push_back(text.substr(0, end));
    if (end != std::string_view::npos) text.remove_prefix(end + between.size());
  }
  return out;
}

// The words of propositions, and what each of them means.
class Lexicon {
 public:
  Lexicon(Arena& arena, const std::vector<Described>& words) {
    for (std::uint32_t p = 0; p < words.size(); ++p) {
      const Formula atom = arena.atom(Proposition{p});
      add(clauses_, words[p].holds, atom);
      add(clauses_, words[p].fails, negate(atom));
      add(visits_, words[p].reach, atom);
      add(entries_, words[p].enter, atom);
      add(acts_, words[p].act, atom);
    }
    add(clauses_, "anything happens", arena.constant(true));
    add(clauses_, "the impossible happens", arena.constant(false));
  }

  using Words = std::map<std::string, Formulas, std::less<>>;
  const Words& words(Slot slot) const {
    return slot == Slot::Visit ? visits_ : slot == Slot::Enter ? entries_ : slot == Slot::Act ? acts_ : clauses_;
  }

 private:
  static void add(Words& words, const std::string& text, Formula meaning) {
    if (!text.empty()) words[text].push_back(meaning);
  }
  Words clauses_, visits_, entries_, acts_;
};

class Reader {
 public:
  Reader(Arena& arena, const std::vector<Described>& words) : arena_(arena), lexicon_(arena, words) {}

  std::optional<Formula> read(std::string_view text) {
    if (!text.ends_with('.')) return std::nullopt;
    const auto sentences = split(text.substr(0, text.size() - 1), ". ");
    for (std::size_t i = 1; i < sentences.size(); ++i) {
      const std::size_t end = sentences[i].find(means);
      if (end == std::string_view::npos) return std::nullopt;
      if (!definitions_.emplace(sentences[i].substr(0, end), sentences[i].substr(end + means.size())).second)
        return std::nullopt;
    }
    return clauses(sentences.front());
  }

 private:
  static constexpr std::string_view means = " means: ";

  std::optional<Formula> clauses(std::string_view text) {
    std::vector<Formula> all;
    for (const std::string_view clause : split(text, "; ")) {
      const Formulas meanings = tail(clause);
      if (meanings.size() != 1) return std::nullopt;
      all.push_back(meanings.front());
    }
    return conjunction(arena_, all);
  }

  static void unite(Formulas& all, const Formulas& more) {
    for (Formula f : more)
      if (std::find(all.begin(), all.end(), f) == all.end()) all.push_back(f);
  }

  Formulas tail(std::string_view text) {
    if (const auto known = tails_.find(text); known != tails_.end()) return known->second;
    Formulas out = state(text);
    for (const Phrase& row : phrases())
      for (const Bindings& bound : bindings(row.english, text, {}))
        unite(out, {substitute(row.formula, arena_, [&](Proposition p) { return *bound.parts[p.index]; })});
    for (const CountedPhrase& row : counted_phrases())
      for (const Bindings& bound : bindings(row.english, text, {})) unite(out, {row.formula(arena_, bound)});
    tails_.emplace(text, out);
    return out;
  }

  // All ways to find a phrase in a text.
  std::vector<Bindings> bindings(std::string_view phrase, std::string_view text, const Bindings& bound) {
    const std::size_t slot = phrase.find('{');
    const std::string_view before = phrase.substr(0, slot);
    if (slot == std::string_view::npos) return text == phrase ? std::vector<Bindings>{bound} : std::vector<Bindings>{};
    if (!text.starts_with(before)) return {};
    const std::string_view after = phrase.substr(slot + 3);
    const std::string_view fixed = after.substr(0, after.find('{'));
    text.remove_prefix(before.size());
    std::vector<Bindings> out;
    if (fixed.empty()) return with(phrase[slot + 1], text, after, {}, bound);
    for (std::size_t at = find_unquoted(text, fixed, 1); at != std::string_view::npos;
         at = find_unquoted(text, fixed, at + 1))
      for (Bindings& found : with(phrase[slot + 1], text.substr(0, at), after, text.substr(at), bound))
        out.push_back(found);
    return out;
  }

  // The letter stands for `part`, and the rest of the phrase is found in the rest of the text.
  std::vector<Bindings> with(char letter, std::string_view part, std::string_view phrase, std::string_view text,
                             Bindings bound) {
    std::vector<Bindings> out;
    if (letter == 'n') {
      const auto [end, error] = std::from_chars(part.data(), part.data() + part.size(), bound.n);
      constexpr std::size_t most = 2'000;
      if (error != std::errc() || end != part.data() + part.size() || bound.n < 1 || bound.n > most) return {};
      return bindings(phrase, text, bound);
    }
    const Formulas meanings = meanings_of(part, slot_of(letter));
    for (Formula f : meanings) {
      bound[letter] = f;
      for (const Bindings& found : bindings(phrase, text, bound)) out.push_back(found);
    }
    return out;
  }

  Formulas meanings_of(std::string_view text, Slot slot) {
    switch (slot) {
      case Slot::State:
      case Slot::LooseState: return state(text);
      case Slot::Literal: return literal(text);
      case Slot::Visit:
      case Slot::Enter:
      case Slot::Act: return choice(text, slot);
      case Slot::Closed: return text.find("otherwise") == std::string_view::npos ? tail(text) : Formulas{};
      case Slot::Tail: return tail(text);
    }
    return {};  // unreachable: -Werror=switch
  }

  Formulas choice(std::string_view text, Slot slot) const {
    Formulas parts;
    for (const std::string_view word : split(text, " or ")) {
      const auto found = lexicon_.words(slot).find(word);
      if (found == lexicon_.words(slot).end() || found->second.size() != 1) return {};
      parts.push_back(found->second.front());
    }
    return {disjunction(arena_, parts)};
  }

  Formulas state(std::string_view text) {
    for (const auto& [between, op] : {std::pair{", or ", Op::Or}, std::pair{", and ", Op::And}})
      if (const auto parts = split(text, between); parts.size() > 1) {
        Formulas out;
        for (const std::string_view part : parts) {
          const Formulas meanings = flat(part);
          if (meanings.size() != 1) return {};
          out.push_back(meanings.front());
        }
        return {joined(op, out)};
      }
    return flat(text);
  }

  Formulas flat(std::string_view text) {
    for (const auto& [between, op] : {std::pair{" or ", Op::Or}, std::pair{" and ", Op::And}})
      if (const auto parts = split(text, between); parts.size() > 1) {
        Formulas out;
        for (const std::string_view part : parts) {
          const Formulas meanings = literal(part);
          if (meanings.size() != 1) return {};
          out.push_back(meanings.front());
        }
        return {joined(op, out)};
      }
    return literal(text);
  }

  Formula joined(Op op, const Formulas& parts) const {
    return op == Op::And ? conjunction(arena_, parts) : disjunction(arena_, parts);
  }

  Formulas literal(std::string_view text) {
    const auto& clauses = lexicon_.words(Slot::State);
    if (const auto found = clauses.find(text); found != clauses.end()) return found->second;
    const std::size_t end = text.find(')');
    if (end == std::string_view::npos) return {};
    const std::string_view rest = text.substr(end + 1);
    if (rest != " holds" && rest != " does not hold") return {};
    const auto meaning = lettered(text.substr(0, end + 1));
    if (!meaning) return {};
    return {rest == " holds" ? *meaning : negate(*meaning)};
  }

  // Of "(A)"; nothing when the letter has no definition, or one that speaks of the letter itself.
  std::optional<Formula> lettered(std::string_view letter) {
    const auto definition = definitions_.find(letter);
    if (definition == definitions_.end() || std::find(open_.begin(), open_.end(), letter) != open_.end())
      return std::nullopt;
    open_.push_back(letter);
    const auto meaning = clauses(definition->second);
    open_.pop_back();
    return meaning;
  }

  Arena& arena_;
  Lexicon lexicon_;
  std::map<std::string_view, std::string_view> definitions_;  // by letter
  std::map<std::string_view, Formulas> tails_;                // what was read already
  std::vector<std::string_view> open_;                        // letters whose definitions are being read
};

}  // namespace

std::optional<Formula> read_english(std::string_view text, Arena& arena, const VerbaliseOptions& options) {
  return Reader(arena, described(arena.vocabulary(), options)).read(text);
}

}  // namespace waymark::ltl

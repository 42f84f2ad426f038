#include "libltl/english/verbalise.hpp"

#include <algorithm>
#include <unordered_map>
#include <vector>

#include "libltl/english/match.hpp"
#include "libltl/english/phrase.hpp"

namespace waymark::ltl {
namespace {

std::string joined(const std::vector<std::string>& parts, std::string_view between) {
  std::string out;
  for (const std::string& part : parts) out += (out.empty() ? "" : std::string(between)) + part;
  return out;
}

// In an arena of its own, with the propositions of f. A disjunction has one F; N is X on infinite words.
Formula normal(Formula f, Arena& to, Semantics semantics) {
  std::unordered_map<Formula, Formula> image;
  for (Formula g : subformulas(f)) {
    std::vector<Formula> parts, goals;
    for (Formula operand : g.operands()) parts.push_back(image.at(operand));
    Formula copy = to.constant(false);
    switch (g.op()) {
      case Op::False: break;
      case Op::True: copy = to.constant(true); break;
      case Op::Atom: copy = to.atom(g.proposition()); break;
      case Op::Not: copy = negate(parts[0]); break;
      case Op::And: copy = conjunction(to, parts); break;
      case Op::Or:
        for (Formula part : parts)
          if (is_eventually(part)) goals.push_back(part[1]);
        std::erase_if(parts, is_eventually);
        if (!goals.empty()) parts.push_back(eventually(disjunction(to, goals)));
        copy = disjunction(to, parts);
        break;
      case Op::Iff: copy = iff(parts[0], parts[1]); break;
      case Op::Next: copy = next(parts[0]); break;
      case Op::WeakNext: copy = semantics == Semantics::Infinite ? next(parts[0]) : weak_next(parts[0]); break;
      case Op::Until: copy = until(parts[0], parts[1]); break;
      case Op::Release: copy = release(parts[0], parts[1]); break;
      case Op::Yesterday: copy = yesterday(parts[0]); break;
      case Op::Since: copy = since(parts[0], parts[1]); break;
    }
    image.emplace(g, copy);
  }
  return image.at(f);
}

class Writer {
 public:
  explicit Writer(std::vector<Described> words) : words_(std::move(words)) {}

  std::string write(Formula f) {
    std::string out = clauses(f);
    for (std::size_t i = 0; i < lettered_.size(); ++i) out += ". " + name_of(i) + " means: " + clauses(lettered_[i]);
    return out + ".";
  }

 private:
  static std::string name_of(std::size_t i) {
    return std::string("(") + static_cast<char>('A' + i % 26) + (i < 26 ? "" : std::to_string(i / 26)) + ")";
  }

  std::string clauses(Formula f) {
    if (f.op() != Op::And || is_state_clause(f)) return tail(f);
    if (const auto whole = phrase(f)) return *whole;
    std::vector<std::string> out;
    for (Formula g : f.operands()) out.push_back(tail(g));
    return joined(out, "; ");
  }

  std::string tail(Formula f) {
    if (is_state_clause(f)) return state(f);
    if (const auto found = phrase(f)) return *found;
    return state(f);
  }

  std::optional<std::string> phrase(Formula f) {
    for (const CountedPhrase& row : counted_phrases())
      if (const auto bound = row.recognise(f); bound && fit(*bound)) return fill(row.english, *bound);
    for (const Phrase& row : phrases())
      if (const auto bound = match(row, f, words_)) return fill(row.english, *bound);
    return std::nullopt;
  }

  bool fit(const Bindings& bound) const {
    for (char letter = 'a'; letter <= 'z'; ++letter)
      if (bound[letter] && !fits(*bound[letter], slot_of(letter), words_)) return false;
    return true;
  }

  std::string fill(std::string_view english, const Bindings& bound) {
    std::string out;
    for (std::size_t i = 0; i < english.size(); ++i)
      if (english[i] != '{') {
        out += english[i];
      } else {
        const char letter = english[i + 1];
        out += letter == 'n' ? std::to_string(bound.n) : part(*bound[letter], slot_of(letter));
        i += 2;
      }
    return out;
  }

  std::string part(Formula f, Slot slot) {
    switch (slot) {
      case Slot::State:
      case Slot::LooseState:
      case Slot::Literal: return state(f);
      case Slot::Visit: return choice(f, &Described::reach);
      case Slot::Enter: return choice(f, &Described::enter);
      case Slot::Act: return choice(f, &Described::act);
      case Slot::Closed: return closed(f);
      case Slot::Tail: return tail(f);
    }
    return {};  // unreachable: -Werror=switch
  }

  std::string choice(Formula f, std::string Described::*words) const {
    if (f.op() == Op::Atom) return words_[f.proposition().index].*words;
    std::vector<std::string> out;
    for (Formula g : f.operands()) out.push_back(words_[g.proposition().index].*words);
    return joined(out, " or ");
  }

  // "otherwise" belongs to one "if" only.
  std::string closed(Formula f) {
    const std::size_t letters = lettered_.size();
    std::string out = tail(f);
    if (out.find("otherwise") == std::string::npos) return out;
    lettered_.resize(letters, f);
    return literal(f, false);
  }

  std::string state(Formula f) {
    if (f.op() != Op::And && f.op() != Op::Or) return literal(f);
    const Op other = f.op() == Op::And ? Op::Or : Op::And;
    const auto nested = [&](Formula g) { return g.op() == other && is_state_clause(g); };
    const bool deep = std::any_of(f.operands().begin(), f.operands().end(), nested);
    std::vector<std::string> parts;
    for (Formula g : f.operands()) parts.push_back(nested(g) ? flat(g) : literal(g));
    return joined(parts, std::string(deep ? "," : "") + (f.op() == Op::And ? " and " : " or "));
  }

  std::string flat(Formula f) {
    std::vector<std::string> parts;
    for (Formula g : f.operands()) parts.push_back(literal(g));
    return joined(parts, f.op() == Op::And ? " and " : " or ");
  }

  std::string literal(Formula f, bool simple = true) {
    if (simple && f.op() == Op::Atom) return words_[f.proposition().index].holds;
    if (simple && f.op() == Op::Not && f[0].op() == Op::Atom) return words_[f[0].proposition().index].fails;
    if (f.op() == Op::True) return "anything happens";
    if (f.op() == Op::False) return "the impossible happens";
    const bool negated = f.op() == Op::Not;
    const Formula named = negated ? f[0] : f;
    auto place = std::find(lettered_.begin(), lettered_.end(), named);
    if (place == lettered_.end()) place = lettered_.insert(place, named);
    return name_of(static_cast<std::size_t>(place - lettered_.begin())) + (negated ? " does not hold" : " holds");
  }

  std::vector<Described> words_;
  std::vector<Formula> lettered_;
};

}  // namespace

std::string verbalise(Formula f, const VerbaliseOptions& options) {
  const Vocabulary& vocabulary = f.arena().vocabulary();
  Arena own(vocabulary);
  return Writer(described(vocabulary, options)).write(normal(f, own, options.semantics));
}

}  // namespace waymark::ltl

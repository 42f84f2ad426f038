#include "tools/verify_automaton.hpp"

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "libautomata/finite/dfa.hpp"
#include "libautomata/finite/guard.hpp"
#include "libautomata/omega/edges.hpp"
#include "libautomata/omega/emptiness.hpp"
#include "libltl/meaning/semantics.hpp"
#include "libltl/structure/random.hpp"
#include "libltl/text/parse.hpp"
#include "libltl/text/print.hpp"
#include "libplan/solve/task_automaton.hpp"
#include "libplan/world/json_reader.hpp"
#include "tools/shell/json.hpp"

namespace waymark::tools {
namespace {

class OfAutomaton {
 public:
  OfAutomaton(Claims& claims, const plan::JsonReader& in, const std::string& source, std::size_t words,
              const std::stop_token& stop)
      : claims_(claims),
        in_(in),
        words_(words),
        stop_(stop),
        given_(plan::read_given_automaton(claims.text("hoa"), source)) {}

  void examine() {
    const bool finite = std::holds_alternative<automata::Dfa>(given_);
    const std::string status = claims_.text("status");
    claims_.add(status == "ok" || status == "unreduced", "status \"" + status + "\" goes with an automaton");
    claims_.expect_text("semantics", finite ? "finite" : "infinite");
    std::visit([&](const auto& automaton) { sizes(automaton); }, given_);
    language(finite);
  }

 private:
  static std::size_t sets(const automata::Dfa&) { return 1; }
  static std::size_t sets(const automata::Automaton& a) { return a.acceptance().sets; }
  static bool deterministic(const automata::Dfa&) { return true; }
  static bool deterministic(const automata::Automaton& a) { return automata::is_deterministic(a.transitions()); }
  static std::optional<std::size_t> edges(const automata::Dfa& a) { return automata::count_edges(a, SIZE_MAX); }
  static std::optional<std::size_t> edges(const automata::Automaton& a) {
    return automata::count_edges(a.transitions());
  }

  void number(const Claims::Value& object, const std::string& key, std::size_t counted) {
    const Claims::Value& said = in_.member(object, "", key);
    claims_.add(said.is_number() && in_.number(said, key) == static_cast<double>(counted), key + " is " + said.dump());
  }

  template <class Any>
  void sizes(const Any& automaton) {
    const Claims::Value& size = claims_.member("automaton");
    number(size, "states", automaton.states());
    if (size.contains("edges")) number(size, "edges", *edges(automaton));
    number(size, "propositions", automaton.reads().size());
    claims_.only(size, "automaton", {"states", "edges", "propositions", "symbolic_nodes"});
    const Claims::Value& said = claims_.member("sets");
    claims_.add(said == sets(automaton), "sets is " + said.dump());
    const Claims::Value& one_run = claims_.member("deterministic");
    claims_.add(one_run == deterministic(automaton), "deterministic is " + one_run.dump());
    Claims::Value reads = Claims::Value::array();
    for (const ltl::Proposition p : automaton.reads()) reads.push_back(automaton.vocabulary().name(p));
    const Claims::Value& names = claims_.member("reads");
    claims_.add(names == reads, "reads is " + names.dump());
  }

  void language(bool finite) {
    const ltl::Vocabulary& names =
        std::visit([](const auto& a) -> const ltl::Vocabulary& { return a.vocabulary(); }, given_);
    ltl::Arena arena(names);
    const ltl::Formula f = ltl::parse(claims_.text("formula"), arena, {.unknown = ltl::Unknown::Add});
    const auto wrong = [&](const std::vector<ltl::Letter>& letters, std::size_t loop) -> std::optional<std::string> {
      if (const auto* dfa = std::get_if<automata::Dfa>(&given_)) {
        const ltl::Trace word(letters);
        if (automata::accepts(*dfa, word) == ltl::holds(word, f)) return std::nullopt;
        return ltl::show(word, arena.vocabulary());
      }
      const auto cut = letters.begin() + static_cast<std::ptrdiff_t>(loop);
      const ltl::Lasso word({letters.begin(), cut}, {cut, letters.end()});
      if (automata::accepts(std::get<automata::Automaton>(given_), word) == ltl::holds(word, f)) return std::nullopt;
      return ltl::show(word, arena.vocabulary());
    };
    const auto found = first_wrong_word(arena.vocabulary().size(), finite, wrong);
    claims_.add(found                    ? std::optional(false)
                : stop_.stop_requested() ? std::nullopt
                                         : std::optional(true),
                "the automaton agrees with " + ltl::print(f) +
                    (found ? " (not on " + *found + ")" : " on " + std::to_string(words_) + " words"));
  }

  // The shortest words over all letters as far as half the words go, then random ones.
  template <class Wrong>
  std::optional<std::string> first_wrong_word(std::size_t propositions, bool finite, const Wrong& wrong) const {
    std::size_t tried = 0;
    for (std::size_t length = 1; propositions <= 8; ++length) {
      const std::size_t letters = std::size_t{1} << propositions, loops = finite ? 1 : length;
      double words = static_cast<double>(loops);
      for (std::size_t i = 0; i < length; ++i) words *= static_cast<double>(letters);
      if (static_cast<double>(tried) + words > static_cast<double>(words_) / 2) break;
      std::vector<std::size_t> digits(length, 0);
      for (bool more = true; more; more = next(digits, letters))
        for (std::size_t loop = 0; loop < loops; ++loop, ++tried)
          if (auto found = wrong(word_of(digits, propositions), loop)) return found;
    }
    ltl::Random random(1);
    for (; tried < words_; ++tried) {
      if (stop_.stop_requested()) return std::nullopt;
      const std::size_t loop = random.below(5), length = loop + 1 + random.below(5);
      std::vector<ltl::Letter> letters;
      for (std::size_t i = 0; i < length; ++i)
        letters.push_back(
            ltl::random_letter(random, {.atoms = propositions, .density = random.below(2) == 0 ? 0.5 : 0.2}));
      if (auto found = wrong(letters, loop)) return found;
    }
    return std::nullopt;
  }

  static bool next(std::vector<std::size_t>& digits, std::size_t base) {
    for (std::size_t& digit : digits) {
      if (++digit < base) return true;
      digit = 0;
    }
    return false;
  }

  static std::vector<ltl::Letter> word_of(const std::vector<std::size_t>& digits, std::size_t propositions) {
    std::vector<ltl::Letter> out(digits.size());
    for (std::size_t i = 0; i < digits.size(); ++i)
      for (std::uint32_t p = 0; p < propositions; ++p)
        if ((digits[i] >> p & 1U) != 0) out[i].insert(ltl::Proposition{p});
    return out;
  }

  Claims& claims_;
  const plan::JsonReader& in_;
  std::size_t words_;
  const std::stop_token& stop_;
  plan::GivenAutomaton given_;
};

}  // namespace

void examine_automaton(Claims& claims, const plan::JsonReader& in, const std::string& source, std::size_t words,
                       const std::stop_token& stop) {
  OfAutomaton(claims, in, source, words, stop).examine();
}

}  // namespace waymark::tools

#include "libparser/domain/commands/command_examples.hpp"

#include <algorithm>

#include "libltl/structure/random.hpp"
#include "libparser/corpus/token.hpp"
#include "libparser/domain/hallways/hallway_things.hpp"

namespace waymark::parser {
namespace {

class Speaking {
 public:
  Speaking(const SynchronousGrammar& grammar, const WordVectors& vectors, const OwnCommands& options)
      : grammar_(grammar), vectors_(vectors), options_(options), random_(options.seed) {}

  std::vector<LiftedExample> all() {
    std::vector<LiftedExample> out;
    const auto silent = static_cast<std::size_t>(options_.nothing * static_cast<double>(options_.texts));
    for (std::size_t i = 0; i < options_.texts; ++i) {
      const auto said = grammar_.say("COMMAND", random_);
      out.push_back(example(said.tokens, said.slots, said.lifted));
    }
    for (std::size_t i = 0; i < silent; ++i) {
      out.push_back(nothing(i));
      out.back().weight *= 0.5;
    }
    return out;
  }

 private:
  LiftedExample example(std::vector<std::string> tokens, std::size_t slots, Lifted lifted) const {
    return {{std::move(tokens), {slots, 0, true}, ""}, std::move(lifted), options_.weight};
  }
  std::string word() { return std::string(vectors_.word(random_.below(vectors_.size()))); }

  LiftedExample nothing(std::size_t i) {
    if (i % 2 == 0) return names_what_is_not_there();
    if (i % 6 == 1) return of_random_words();
    const auto said = grammar_.say("CHATTER", random_);
    return example(said.tokens, said.slots, {LiftedSymbol::Nothing});
  }

  // A command in which one or two words stand where a place should.
  LiftedExample names_what_is_not_there() {
    for (;;) {
      const auto said = grammar_.say("COMMAND", random_);
      if (said.slots == 0) continue;
      const std::string missing = name(slot(1 + random_.below(said.slots)));
      std::vector<std::string> words{word()};
      if (random_.chance(0.4)) words.push_back(word());
      if (random_.chance(0.6)) words.insert(words.begin(), random_.chance(0.7) ? "the" : "a");
      std::vector<std::string> tokens;
      std::vector<std::string> renamed;  // slots that are left, in their new order
      for (const std::string& token : said.tokens) {
        if (token == missing) {
          tokens.insert(tokens.end(), words.begin(), words.end());
        } else if (token[0] == '#' && token.size() > 1) {
          auto at = std::find(renamed.begin(), renamed.end(), token);
          if (at == renamed.end()) at = renamed.insert(renamed.end(), token);
          tokens.push_back(name(slot(static_cast<std::size_t>(at - renamed.begin()) + 1)));
        } else {
          tokens.push_back(token);
        }
      }
      return example(std::move(tokens), renamed.size(), {LiftedSymbol::Nothing});
    }
  }

  LiftedExample of_random_words() {
    std::vector<std::string> tokens;
    const std::size_t n = 1 + random_.below(12), slots = random_.below(2);
    for (std::size_t i = 0; i < n; ++i) tokens.push_back(random_.chance(0.1) ? letters() : word());
    if (slots > 0) tokens.insert(tokens.begin() + static_cast<std::ptrdiff_t>(random_.below(n)), name(slot(1)));
    return example(std::move(tokens), slots, {LiftedSymbol::Nothing});
  }
  std::string letters() {
    std::string word;
    for (std::size_t i = 3 + random_.below(6); i > 0; --i) word += static_cast<char>('a' + random_.below(26));
    return word;
  }

  const SynchronousGrammar& grammar_;
  const WordVectors& vectors_;
  const OwnCommands& options_;
  ltl::Random random_;
};

}  // namespace

std::vector<LiftedExample> own_commands(const SynchronousGrammar& grammar, const WordVectors& vectors,
                                        const OwnCommands& options) {
  return Speaking(grammar, vectors, options).all();
}

LabelledCommands labelled_commands(std::span<const Command> commands, CommandDomains& domains,
                                   const MentionModel& mentions, double unnamed, bool doubted) {
  LabelledCommands out;
  for (const Command& command : commands) {
    if (command.suspect && !doubted) continue;
    const CommandDomain& domain = domains.of(command.domain);
    const auto lift = domain.lift(command.text, mentions).front();
    const auto label = domain.label(lift, command.formula);
    if (!label || !is_spelled_in(*label, lift.text.scope)) {
      ++out.left_out;
      continue;
    }
    if (unnamed < 1) out.examples.push_back({lift.text, *label, 1 - unnamed});
    const bool says_all = std::none_of(label->begin(), label->end(), is_constant);
    if (unnamed <= 0 || (!says_all && unnamed < 1)) continue;
    out.examples.push_back({lift.text, *label, unnamed});
    out.examples.back().text.domain.clear();
    if (says_all) out.examples.back().text.scope.constants = 0;
  }
  return out;
}

std::vector<LiftedExample> route_instructions(const Corpus& corpus, std::span<const plan::Map> maps,
                                              const WordVectors& vectors, const Synonyms& synonyms, double weight) {
  std::vector<LiftedExample> out;
  std::vector<HallwayThings> things;
  for (const plan::Map& map : maps) things.emplace_back(map.vocabulary(), &synonyms);
  const auto add = [&](std::size_t map, const std::vector<std::string>& tokens) {
    if (tokens.empty() || tokens.size() > 60) return;
    out.push_back({things[map].lift(tokens, &vectors).text, {LiftedSymbol::Route}, weight});
  };
  for (const Paragraph& paragraph : corpus.paragraphs) {
    const auto map = static_cast<std::size_t>(
        std::find_if(maps.begin(), maps.end(), [&](const plan::Map& m) { return m.name() == paragraph.map; }) -
        maps.begin());
    if (map == maps.size()) continue;
    std::vector<std::string> whole;
    for (const Sentence& sentence : paragraph.sentences) {
      add(map, sentence.tokens);
      whole.insert(whole.end(), sentence.tokens.begin(), sentence.tokens.end());
      whole.emplace_back(".");
    }
    if (paragraph.sentences.size() > 1) add(map, whole);
  }
  return out;
}

}  // namespace waymark::parser

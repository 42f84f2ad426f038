// An encoder-decoder over a vocabulary so small that its programs can be listed.
#pragma once
#include <map>
#include <vector>

#include "libltl/structure/random.hpp"
#include "libparser/corpus/token.hpp"
#include "libparser/model/network_scorer.hpp"

namespace waymark::parser {

struct SmallNetwork {
  explicit SmallNetwork(std::uint64_t seed = 3, PostfixGrammar::Limits limits = {.steps = 1, .goals = 2})
      : language(ltl::Vocabulary({"chair", "ahead_chair", "ahead_wall", "place_1", "turned_left"}), limits),
        random(seed),
        network(TypedPostfix(language), words(), {.word = 5, .width = 4, .query = 6, .symbol = 5, .history = 3},
                [this] { return random.unit(); }),
        sentence(network.sentence({tokenize("walk to the chair and turn left"), false})) {
    for (neural::Index i = 0; i < network.parameters().size(); ++i)  // sharper than what training begins with
      network.parameters().values()[i] *= 2;
  }

  static WordTable words() {
    WordTable table;
    for (const char* word : {"walk", "to", "chair", "left"}) table.add(word);
    return table;
  }

  // Every program that the sentence may have, with log p(program | sentence), symbol by symbol from the definition.
  std::map<Program, double> all() {
    std::map<Program, double> out;
    std::vector<Symbol> symbols;
    extend({}, network.first_history(), symbols, 0, out);
    return out;
  }

  ProgramLanguage language;
  const PostfixGrammar& grammar = language.grammar();
  ltl::Random random;
  EncoderDecoder network;
  NetworkSentence sentence;

 private:
  void extend(const TypedState& state, const History& history, std::vector<Symbol>& symbols, double log_p,
              std::map<Program, double>& out) {
    if (state.prefix.ended) {
      out[network.symbols().program_of(symbols)] = log_p;
      return;
    }
    std::vector<bool> allowed = network.symbols().allowed(state);
    const bool forced = std::count(allowed.begin(), allowed.end(), true) == 1;
    EncoderDecoder::Pass pass;
    const NetworkSentence* const only = &sentence;
    pass.encode(network, network.parameters(), {&only, 1});
    const neural::Index begin[] = {0, 1};
    const neural::Matrix scores = pass.decode(begin, {&history, 1});
    double total = 0;
    const auto symbols_there = static_cast<Symbol>(allowed.size());
    for (Symbol v = 0; v < symbols_there; ++v) {
      if (!forced) allowed[v] = allowed[v] && !sentence.forbidden[v];
      if (allowed[v]) total += std::exp(static_cast<double>(scores(v, 0)));
    }
    for (Symbol v = 0; v < symbols_there; ++v) {
      if (!allowed[v]) continue;
      History longer = history;
      EncoderDecoder::remember(longer, v);
      symbols.push_back(v);
      extend(network.symbols().after(state, v), longer, symbols,
             forced ? log_p : log_p + static_cast<double>(scores(v, 0)) - std::log(total), out);
      symbols.pop_back();
    }
  }
};

}  // namespace waymark::parser

// The encoder-decoder of the paper: what symbol of a formula comes next, given a sentence and the symbols so far.
//
//   words → embeddings → bidirectional LSTM → h, e        [GPLL17, Sec. 3.1]
//   the last K symbols → embeddings φ → x; attention and scores: libneural/attention_decoder.hpp
// A sentence begins with a word of our own that says whether the heading at its start is known. Symbols are those of
// typed_postfix.hpp; what a sentence mentions by the lexicon is marked, when `lexicon` is set. One pass takes a batch
// of sentences with any number of choices each, so a trie of formulas costs one pass.
#pragma once
#include <map>
#include <span>
#include <vector>

#include "libparser/model/features.hpp"
#include "libparser/model/network_options.hpp"
#include "libparser/model/sentence_encoder.hpp"
#include "libparser/model/typed_postfix.hpp"

namespace waymark::parser {

// A sentence as the network sees it.
struct NetworkSentence {
  std::vector<WordId> words;    // the first says whether the heading is known
  std::vector<Symbol> marked;   // mentioned
  std::vector<bool> forbidden;  // by symbol: places it does not name
};

// A history: the last K symbols, the latest first; `symbols` stands for none.
using History = std::vector<Symbol>;

class EncoderDecoder {
 public:
  using Index = neural::Index;

  // Words of the table are known, others are read as unknown. Draws the first weights.
  EncoderDecoder(TypedPostfix symbols, WordTable words, const NetworkOptions& options, const neural::Uniform& uniform);

  const TypedPostfix& symbols() const { return symbols_; }              // that it writes
  const NetworkOptions& options() const { return options_; }            // sizes of the layers
  const WordTable& words() const { return words_; }                     // that it knows
  neural::Parameters& parameters() { return parameters_; }              // values and gradients
  const neural::Parameters& parameters() const { return parameters_; }  // of the network

  NetworkSentence sentence(const SentenceInput& input) const;  // as numbers
  History first_history() const;                               // before any symbol
  static void remember(History& history, Symbol symbol);       // the symbol becomes the latest one

  // One pass over a batch, forwards and back. Memory is kept from pass to pass.
  class Pass {
   public:
    // Of every sentence, once.
    void encode(const EncoderDecoder& network, const neural::Parameters& parameters,
                std::span<const NetworkSentence* const> sentences, const Dropout& dropout = {});
    // Choices of sentence s: [begin[s], begin[s + 1]); one column of scores for each. After encode; may be repeated.
    const neural::Matrix& decode(std::span<const Index> begin, std::span<const History> histories);
    // After decode, with the gradient of the scores: adds to the gradients of `parameters`, which are those of encode.
    void backward(neural::Parameters& parameters, const neural::Matrix& dscores);
    std::span<const neural::Matrix> attention() const { return decoder_.weights; }  // by sentence: [words × choices]

   private:
    const EncoderDecoder* network_ = nullptr;
    const neural::Parameters* parameters_ = nullptr;
    SentenceEncoder::Pass encoder_;
    std::vector<Index> begin_, said_;
    std::vector<const History*> histories_;  // each once
    std::map<History, Index> index_;
    neural::Matrix marks_, x_, dx_;
    neural::AttentionDecoder::Signals decoder_;
    bool is_attended_ = false;  // some step of these sentences was decoded
  };

 private:
  TypedPostfix symbols_;
  WordTable words_;
  NetworkOptions options_;
  neural::Parameters parameters_;
  neural::Block phi_;
  SentenceEncoder encoder_;
  neural::AttentionDecoder decoder_;
};

}  // namespace waymark::parser

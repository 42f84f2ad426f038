// The network that reads lifted texts: which symbol of the lifted formula comes next, given the text and the prefix.
//
//   word → [learned embedding; P · vector of the word]  → bidirectional LSTM → h, e
//   prefix → the last symbols, the operators that are open, the slots that are used → x
//   attention and scores: libneural/attention_decoder.hpp [GPLL17, Sec. 3.1]
// Vectors of words (lexicon/word_vectors.hpp) stay as they are and P is learned, so a word that no training text has is
// read like the words that it resembles. A text begins with a word that names its domain.
#pragma once
#include <array>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "libneural/attention_decoder.hpp"
#include "libneural/lstm.hpp"
#include "libparser/lexicon/word_vectors.hpp"
#include "libparser/lifted/lifted_symbol.hpp"
#include "libparser/model/sentence_encoder.hpp"
#include "libparser/model/word_table.hpp"

namespace waymark::parser {

// A text whose mentions are slots: tokens "#1", "#2" …, numbered by first mention.
struct LiftedText {
  std::vector<std::string> tokens;  // with slots as "#1", "#2" …
  LiftedScope scope;                // what the formula may use
  std::string domain;               // "" is unknown
};

// Left and right exchanged.
LiftedText mirrored(LiftedText text);
// Where one turns and sees, a text that names the right before the left is read in the mirror: the network meets one
// of the two only, and what it learns of one side holds for the other.
bool is_read_in_mirror(const LiftedText& text);

struct LiftedSizes {                                                         // of the layers
  std::int32_t word = 48, vector = 64, width = 96, query = 96, symbol = 32;  // widths
  friend bool operator==(const LiftedSizes&, const LiftedSizes&) = default;
};

class LiftedNetwork {
 public:
  using Index = neural::Index;
  static constexpr std::size_t remembered = 3;  // symbols before

  // Words of the table are known by themselves. `vectors` may be shared and must be the same when weights are loaded.
  LiftedNetwork(WordTable words, std::shared_ptr<const WordVectors> vectors, const LiftedSizes& sizes,
                const neural::Uniform& uniform);

  struct Sentence {                      // a text as numbers
    std::vector<WordId> words;           // of the table
    std::vector<std::uint32_t> vectors;  // rows of the vectors; vectors.size(): none
  };
  Sentence sentence(const LiftedText& text) const;  // unknown words have number 0

  // What the decoder sees of a prefix.
  struct Prefix {
    LiftedPrefix grammar;                         // what may follow
    std::array<LiftedSymbol, remembered> last{};  // the latest first; End where there is none
    Prefix after(LiftedSymbol s) const;           // one symbol longer
  };

  const WordTable& words() const { return words_; }
  const LiftedSizes& sizes() const { return sizes_; }                   // of the layers
  neural::Parameters& parameters() { return parameters_; }              // values and gradients
  const neural::Parameters& parameters() const { return parameters_; }  // of the network

  class Pass {  // of a batch through the network
   public:
    // Of every sentence, once.
    void encode(const LiftedNetwork& network, const neural::Parameters& parameters,
                std::span<const Sentence* const> sentences, const Dropout& dropout = {});
    // Prefixes of sentence s: [begin[s], begin[s + 1]). Scores: [symbols × prefixes].
    const neural::Matrix& decode(std::span<const Index> begin, std::span<const Prefix> prefixes);
    void backward(neural::Parameters& parameters, const neural::Matrix& dscores);

   private:
    void place(std::span<const Sentence* const> sentences, const Dropout& dropout);
    void embed();
    neural::AttentionDecoder::Sequences sequences() const {
      return {&h_, h_begin_, &e_, nullptr, begin_, said_, is_attended_};
    }

    const LiftedNetwork* network_ = nullptr;
    const neural::Parameters* parameters_ = nullptr;
    std::vector<std::size_t> order_;
    std::vector<Index> column_, h_begin_, begin_, said_;
    std::vector<WordId> words_;           // by packed column
    std::vector<std::uint32_t> vectors_;  // the same
    std::vector<Prefix> prefixes_;
    neural::Packing packing_{std::span<const Index>{}};
    neural::Matrix fixed_, input_, input_mask_, dinput_, h_, h_mask_, e_, x_, dx_;
    neural::BidirectionalLstm::Signals lstm_;
    neural::AttentionDecoder::Signals decoder_;
    bool is_attended_ = false;  // some step of these sentences was decoded
  };

 private:
  static constexpr Index flags = 8 + 12;  // operands so far, slots used
  Index inputs() const { return sizes_.symbol * static_cast<Index>(remembered + 2) + flags; }

  WordTable words_;
  std::shared_ptr<const WordVectors> vectors_;
  LiftedSizes sizes_;
  neural::Parameters parameters_;
  neural::Block embeddings_, projection_, phi_;
  neural::BidirectionalLstm lstm_;
  neural::AttentionDecoder decoder_;
};

// log p of the symbols that are allowed, −∞ of the others, from a column of scores. log_p: [lifted_symbols]
void log_softmax(const neural::ConstView& scores, neural::Index column, const LiftedPrefix& prefix,
                 const LiftedScope& scope, std::span<float> log_p);

struct LiftedReading {         // a formula that the text may mean
  Lifted lifted;               // complete
  double log_probability = 0;  // given the text
};
// log p of formulas, −∞ of those that the scope does not allow. One pass through the network.
std::vector<double> score_lifted(const LiftedNetwork& network, const LiftedText& text,
                                 std::span<const Lifted> formulas);
// The likeliest lifted formulas by a beam of that width, best first.
std::vector<LiftedReading> read_lifted(const LiftedNetwork& network, const LiftedText& text, std::size_t beam);

}  // namespace waymark::parser

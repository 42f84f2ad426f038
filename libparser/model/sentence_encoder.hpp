// Sentences → vectors: embeddings of words, and a bidirectional LSTM over them.
#pragma once
#include <span>
#include <vector>

#include "libneural/attention_decoder.hpp"
#include "libneural/lstm.hpp"
#include "libparser/model/word_table.hpp"

namespace waymark::parser {

// What a pass in training leaves out at random; nothing otherwise.
struct Dropout {
  double signals = 0, words = 0;  // of embeddings and h; of words but the first, read as unknown
  neural::Uniform uniform = {};   // draws what is dropped
};

class SentenceEncoder {
 public:
  using Index = neural::Index;
  using Words = std::vector<WordId>;  // at least one

  SentenceEncoder(neural::Parameters& parameters, std::size_t words, Index word, Index width,
                  const neural::Uniform& uniform);
  Index width() const { return lstm_.width(); }  // of h and e

  // One pass over a batch, forwards and back. Memory is kept from pass to pass.
  class Pass {
   public:
    // Of a batch; fills h and e.
    void forward(const SentenceEncoder& encoder, const neural::Parameters& parameters,
                 std::span<const Words* const> sentences, const Dropout& dropout);
    // After `forward`: adds to the gradients.
    void backward(neural::Parameters& parameters, neural::Matrix& dh, const neural::Matrix& de);

    // What a decoder looks at: [width × words], sentence by sentence; [width × sentences].
    neural::AttentionDecoder::Sequences sequences(std::span<const Index> begin, std::span<const Index> said,
                                                  const neural::Matrix* marks) const {
      return {&h_, h_begin_, &e_, marks, begin, said};
    }

   private:
    void place(std::span<const Words* const> sentences, const Dropout& dropout);

    const SentenceEncoder* encoder_ = nullptr;
    std::vector<std::size_t> order_;  // sentences, the longest first
    std::vector<Index> column_;       // of word after word, sentence after sentence: where it is packed
    Words words_;                     // by packed column
    neural::Packing packing_{std::span<const Index>{}};
    std::vector<Index> h_begin_;
    neural::Matrix embedded_, embedded_mask_, h_, h_mask_, e_, dembedded_;
    neural::BidirectionalLstm::Signals lstm_;
  };

 private:
  neural::Block words_;
  neural::BidirectionalLstm lstm_;
};

}  // namespace waymark::parser

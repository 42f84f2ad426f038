// A reader of lifted texts: networks that spell formulas and vote, a matcher that decides over whole formulas, the word
// vectors that the networks share, and what finds mentions of landmarks.
//
// Candidates are what the networks spell, by the mean over them, and the known formulas that match best. What the
// networks give to formulas that the matcher knows is dealt anew among these, in proportion to
//   p(φ | text, networks)^a · p(φ | text, matcher)^b
// In a model file: the bytes of the word vectors once, the networks in 16-bit floats, the matcher, the weights of
// mentions, and the groups of synonyms.
#pragma once
#include <map>
#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include "libparser/lifted/formula_matcher.hpp"
#include "libparser/lifted/lifted_network.hpp"
#include "libparser/lifted/mention_weights.hpp"
#include "libparser/model/weights_bytes.hpp"

namespace waymark::parser {

class LiftedReader {
 public:
  // Throws ltl::FormatError when the file holds no word vectors.
  static std::shared_ptr<const WordVectors> load_vectors(const std::filesystem::path& file);

  LiftedReader(std::shared_ptr<const WordVectors> vectors, std::vector<std::shared_ptr<const LiftedNetwork>> networks,
               MentionModel mentions = {}, std::shared_ptr<const FormulaMatcher> matcher = nullptr);

  // The likeliest lifted formulas, best first; probabilities of those found sum to 1 at most.
  std::vector<LiftedReading> read(const LiftedText& text, std::size_t beam = 12) const;
  // Whether a network has learned the word from texts; a word vector alone does not count.
  bool knows(const std::string& word) const;
  const WordVectors& vectors() const { return *vectors_; }
  const MentionModel& mentions() const { return mentions_; }
  std::span<const std::shared_ptr<const LiftedNetwork>> networks() const { return networks_; }
  const FormulaMatcher* matcher() const { return matcher_.get(); }  // null where none was learned

  void write(WeightsWriter& out) const;  // the part of a model file
  // Throws ltl::FormatError.
  static std::shared_ptr<const LiftedReader> read_from(WeightsReader& in, const std::shared_ptr<const void>& owner);

 private:
  std::map<Lifted, double> spelled(const LiftedText& text, std::size_t beam) const;

  std::shared_ptr<const WordVectors> vectors_;
  std::vector<std::shared_ptr<const LiftedNetwork>> networks_;
  MentionModel mentions_;
  std::shared_ptr<const FormulaMatcher> matcher_;
};

}  // namespace waymark::parser

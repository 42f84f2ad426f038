// How well a lifted formula fits a lifted text, decided over whole formulas: two towers over sparse features.
//
//   h(text) = [relu(Σ E_f / √n), 1]     f: the n features of the text that are known
//   g(φ)    =  Σ P_f / √m               f: the m features of the formula
//   p(φ | text) ∝ exp(h(text) · g(φ))   over the formulas that were learned and those that are asked about
// The sides meet in their features: a formula that few texts mean still shares its kind, the order of its slots and its
// parts with others. Deciding over whole formulas needs fewer texts than spelling them symbol by symbol. Scores of two
// sides that are embedded apart: [WBU11, Sec. 2]. Entries are kept in 8 bits.
#pragma once
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "libneural/parameters.hpp"
#include "libparser/lifted/lifted_network.hpp"
#include "libparser/model/weights_bytes.hpp"

namespace waymark::parser {

// Vectors by key, in 8 bits with a scale for each: columns of features.
class FeatureTable {
 public:
  // Keys ascend; one column each.
  FeatureTable(std::vector<std::uint64_t> keys, const neural::Matrix& columns);

  std::size_t size() const { return keys_.size(); }  // features
  neural::Index width() const { return width_; }     // entries of a vector
  // Adds `weight` times the vectors of the keys that are known; how many these are. O(keys · log size)
  std::size_t add(std::span<const std::uint64_t> keys, float weight, Eigen::Ref<neural::Vector> sum) const;

  void write(WeightsWriter& out) const;                                                   // the part of a model file
  static FeatureTable read(WeightsReader& in, const std::shared_ptr<const void>& owner);  // throws ltl::FormatError

 private:
  FeatureTable() = default;

  neural::Index width_ = 0;
  std::shared_ptr<const void> owner_;  // of what the spans show
  std::span<const std::uint64_t> keys_;
  std::span<const float> scales_;
  std::span<const std::int8_t> entries_;  // [width × size]
};

class FormulaMatcher {  // of texts and formulas
 public:
  // Known formulas ascend.
  FormulaMatcher(FeatureTable texts, FeatureTable formulas, std::vector<Lifted> known);

  struct Match {                 // a formula that is known
    const Lifted* lifted;        // it
    double log_probability = 0;  // given the text
  };
  // h(text). [width + 1]
  neural::Vector encode(const LiftedText& text) const;
  // h · g(φ) of any formula.
  double score(const neural::Vector& encoded, std::span<const LiftedSymbol> formula) const;
  struct Matches {            // of a text
    std::vector<Match> best;  // best first
    double log_total = 0;     // log Σ exp score over the known formulas that the scope allows
  };
  // The k likeliest known formulas that the scope allows. O(known · width)
  Matches best(const neural::Vector& encoded, const LiftedScope& scope, std::size_t k) const;
  bool knows(const Lifted& formula) const;  // was it learned? O(log known)

  void write(WeightsWriter& out) const;                                                     // the part of a model file
  static FormulaMatcher read(WeightsReader& in, const std::shared_ptr<const void>& owner);  // throws ltl::FormatError

 private:
  neural::Vector encode(std::span<const LiftedSymbol> formula) const;

  FeatureTable texts_, formulas_;
  std::vector<Lifted> known_;
  neural::Matrix vectors_;  // g of those
};

// What a formula needs of a text.
LiftedScope needed_scope(std::span<const LiftedSymbol> formula);
bool is_within(const LiftedScope& needed, const LiftedScope& scope);  // may what is needed be said?

}  // namespace waymark::parser

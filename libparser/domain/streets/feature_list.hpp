// Features by name, hashed into so many that those of all cities share them: what the ranker weights.
#pragma once
#include <cstdint>
#include <initializer_list>
#include <string_view>
#include <utility>
#include <vector>

#include "libparser/rerank/ranker.hpp"

namespace waymark::streets {

constexpr std::uint32_t feature_bits = 20;  // of a key

using RouteFeatures = std::vector<parser::WeightedFeature>;  // in no order; one may stand more than once

enum class FeatureKind : std::uint8_t {  // the first part of a name
  Move,
  MoveWord,
  MoveGap,
  MoveMove,
  Beside,
  BesideWord,
  Silent,
  SilentRival,
  SilentCount,
  Unnamed,
  Rank,
  RankAll,
  Detour,
  Legs,
  Goal,
  GoalWord,
  StartWord,
  Angle,
  AngleFirst,
  Fit,
  Rival,
  Coverage,
  FirstMention,
  Confused,
  Exact,
  Cue,
  CoarseWord,
  CoarsePair,
  Reading,
  PassedBy,
  InSight,     // what is named, against the landmarks that the writer can have seen
  RivalNamed,  // a landmark of the rival alone that is named
  TellsApart,  // what tells route and rival apart, and how much of it is named
  RivalExact,  // the text taken at its word is the rival
  Step,        // one mention as a step of the walk
  StepWord,    // … with the words before it
  Walk         // the walk as a whole
};

// Of a word, to be a part of a feature.
std::uint64_t hash_of(std::string_view word);
std::uint64_t mix(std::uint64_t hash, std::uint64_t value);

// 0, 1, …, as many as there are thresholds: how many of the growing thresholds a value reaches.
unsigned bin(double value, std::initializer_list<double> thresholds);

class FeatureList {
 public:
  // `parts`: integers and enumerators that together with the kind name the feature.
  template <typename... Parts>
  void add(FeatureKind kind, double value, Parts... parts) {
    std::uint64_t hash = static_cast<std::uint64_t>(kind) + 1;
    ((hash = mix(hash, static_cast<std::uint64_t>(parts))), ...);
    features_.push_back({hash & ((1U << feature_bits) - 1), static_cast<float>(value)});
  }
  RouteFeatures take() { return std::move(features_); }

 private:
  RouteFeatures features_;
};

}  // namespace waymark::streets

// What a domain of instructions provides; the ranker is learned (training/learn_ranker.hpp) and asked on these terms
// alone.
//
//   vocabulary   the propositions of a map, by their names
//   candidates   what a text may mean on its map, in an order of the domain's
//   features     what the ranker sees of a text and its candidates
//   execute      the route that a candidate stands for
//   right        is that the route which the text describes? All the supervision that there is
// A domain that knows the likeliest mistake for a right candidate also has `rival`. A text is a handle, cheap to copy;
// it knows its map by number, and its right route. Nothing is const, for a domain may remember what it has computed.
#pragma once
#include <concepts>
#include <cstddef>
#include <optional>

#include "libltl/formula.hpp"
#include "libparser/rerank/ranker.hpp"

namespace waymark::parser {

template <class D>
concept Domain = requires(D& domain, const typename D::Map& map, const typename D::Text& text,
                          const typename D::Candidates& candidates, const typename D::Route& route) {
  { D::vocabulary(map) } -> std::convertible_to<ltl::Vocabulary>;
  { D::map_of(text) } -> std::convertible_to<std::size_t>;
  { domain.candidates(text) } -> std::convertible_to<const typename D::Candidates&>;
  { candidates.size() } -> std::convertible_to<std::size_t>;
  { domain.features(text, candidates) } -> std::same_as<CandidateFeatures>;
  { D::execute(candidates[std::size_t{}]) } -> std::convertible_to<const typename D::Route&>;
  { D::right(text, route) } -> std::same_as<bool>;
};

template <class D>
concept DomainWithRivals = Domain<D> && requires(const typename D::Candidates& candidates, std::size_t right) {
  { D::rival(candidates, right) } -> std::same_as<std::optional<std::size_t>>;
};

}  // namespace waymark::parser

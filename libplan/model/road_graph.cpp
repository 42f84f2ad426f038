#include "libplan/model/road_graph.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "libltl/text/xxhash.hpp"

namespace waymark::plan {
namespace {

template <class T>
std::string_view bytes_of(const std::vector<T>& values) {
  return {reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T)};
}

}  // namespace

RoadGraph::RoadGraph(Parts parts)
    : arcs_(std::move(parts.arcs)),
      letter_(std::move(parts.letter)),
      letters_(std::move(parts.letters)),
      nodes_of_(letters_.size()),
      entrances_of_(letters_.size()),
      start_(parts.start) {
  if (letter_.empty() || letter_.size() > most_nodes || start_ >= letter_.size())
    throw std::invalid_argument("expected 1 to 2^30 nodes, and a start among them");
  if (parts.tails.size() != arcs_.size() || arcs_.size() >= UINT32_MAX)
    throw std::invalid_argument("expected a tail for every arc, and fewer than 2^32 arcs");
  if (letters_.size() == 0 || letters_.size() > most_letters || !letters_[LetterId{0}].members().empty())
    throw std::invalid_argument("expected the empty letter first, and at most 2^16 letters");
  std::vector<bool> entered(letter_.size(), false);
  for (std::size_t a = 0; a < arcs_.size(); ++a) {
    const std::uint32_t from = parts.tails[a], to = arcs_[a].to;
    if (from >= letter_.size() || to >= letter_.size() || arcs_[a].cost > most_arc_cost)
      throw std::invalid_argument("expected arcs between nodes, with costs below 2^31");
    if (letter_[from] != letter_[to]) entered[to] = true;
  }
  sort(std::move(parts.tails));
  for (std::uint32_t v = 0; v < letter_.size(); ++v)
    if (letter_[v] != 0) {
      nodes_of_.at(letter_[v]).push_back(v);
      if (entered[v]) entrances_of_[letter_[v]].push_back(v);
    }
}

void RoadGraph::sort(std::vector<std::uint32_t> tails) {
  first_.assign(letter_.size() + 1, 0);
  for (const std::uint32_t tail : tails) ++first_[tail + 1];
  for (std::size_t v = 0; v < letter_.size(); ++v) first_[v + 1] += first_[v];
  if (!std::is_sorted(tails.begin(), tails.end())) {
    std::vector<Arc> sorted(arcs_.size() + 1);
    std::vector<std::uint32_t>& next = first_;  // moved on to the ends of the rows, then back by one row
    for (std::size_t a = 0; a < tails.size(); ++a) sorted[next[tails[a]]++] = arcs_[a];
    std::copy_backward(first_.begin(), first_.end() - 1, first_.end());
    first_[0] = 0;
    arcs_ = std::move(sorted);
  } else {
    arcs_.emplace_back();
  }
}

std::size_t RoadGraph::count(LetterId letter) const {
  if (letter.index != 0) return nodes_of_[letter.index].size();
  std::size_t labelled = 0;
  for (const auto& nodes : nodes_of_) labelled += nodes.size();
  return nodes() - labelled;
}

std::uint64_t RoadGraph::checksum() const {
  std::string sums;
  const auto add = [&](std::uint64_t sum) { sums += std::to_string(sum) + '\n'; };
  add(ltl::xxh64(bytes_of(first_)));
  add(ltl::xxh64(bytes_of(arcs_)));
  add(ltl::xxh64(bytes_of(letter_)));
  for (const std::string& name : letters_.vocabulary().names()) sums += std::to_string(name.size()) + ' ' + name;
  for (const ltl::Letter& letter : letters_.all()) {
    for (const ltl::Proposition p : letter.members()) sums += ' ' + std::to_string(p.index);
    sums += '\n';
  }
  return ltl::xxh64(sums);
}

Mdp model_of(const RoadGraph& graph) {
  MdpBuilder builder(graph.letters().vocabulary());
  std::vector<LetterId> letters;
  for (const ltl::Letter& letter : graph.letters().all()) letters.push_back(builder.letter(letter));
  for (std::uint32_t v = 0; v < graph.nodes(); ++v) {
    builder.add_state(RoadGraph::name(v));
    for (const RoadGraph::Arc& arc : graph.arcs(v)) {
      builder.add_choice(RoadGraph::name(arc.to), arc.cost);
      builder.add_outcome(arc.to, letters[graph.letter(arc.to).index]);
    }
  }
  return std::move(builder).build(graph.start(), letters[graph.letter(graph.start()).index]);
}

}  // namespace waymark::plan

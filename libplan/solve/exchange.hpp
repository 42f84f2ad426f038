// Copies that parts of an array keep of each other's numbers, as of the pass before: what lets parts be swept side by
// side (side_by_side.hpp). Gauss–Seidel within a part, Jacobi between them [BT89].
#pragma once
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <tuple>
#include <vector>

#include "libplan/solve/side_by_side.hpp"

namespace waymark::plan {

struct PlaceOfCopy {            // in the array
  std::uint32_t owner, reader;  // parts
  std::uint32_t chunk;          // of the owner's number
  std::uint32_t from, to;       // places of the number and of its copy
};

template <class Number>
class Exchange {
 public:
  Exchange() = default;
  Exchange(std::size_t parts, std::size_t chunks, std::vector<PlaceOfCopy> copies) : told_by_(parts), read_by_(parts) {
    std::sort(copies.begin(), copies.end(), [](const PlaceOfCopy& a, const PlaceOfCopy& b) {
      return std::tie(a.owner, a.reader, a.chunk, a.from, a.to) < std::tie(b.owner, b.reader, b.chunk, b.from, b.to);
    });
    for (const PlaceOfCopy& copy : copies) {
      if (links_.empty() || links_.back().owner != copy.owner || links_.back().reader != copy.reader) {
        told_by_[copy.owner].push_back(links_.size());
        read_by_[copy.reader].push_back(links_.size());
        links_.push_back({copy.owner, copy.reader});
      }
      Link& link = links_.back();
      link.first.resize(copy.chunk + 1, static_cast<std::uint32_t>(link.from.size()));
      link.from.push_back(copy.from);
      link.to.push_back(copy.to);
    }
    for (Link& link : links_) {
      link.first.resize(chunks + 1, static_cast<std::uint32_t>(link.from.size()));
      link.told.resize(2 * (link.from.size() + apart));
    }
  }

  template <class Visit>  // visit(place of a number, place of a copy)
  void for_each(Visit&& visit) const {
    for (const Link& link : links_)
      for (std::size_t i = 0; i < link.from.size(); ++i) visit(link.from[i], link.to[i]);
  }
  // Before the first pass: all copies.
  template <class Numbers>
  void copy(Numbers& numbers) const {
    for_each([&](std::uint32_t from, std::uint32_t to) { numbers[to] = numbers[from]; });
  }
  // Before a pass over a part: what the others told in the pass before.
  template <class Numbers>
  void take(std::size_t part, const PassInTurn& now, Numbers& numbers) const {
    if (now.pass.anew) return;
    for (const std::size_t l : read_by_[part]) {
      const Link& link = links_[l];
      const Number* told = link.told.data() + link.half(now.number + 1);
      for (std::uint32_t i = link.first[now.before.begin]; i < link.first[now.before.end]; ++i)
        numbers[link.to[i]] = told[i];
    }
  }
  // After it: what the chunks of the pass have come to.
  template <class Numbers>
  void tell(std::size_t part, const PassInTurn& now, const Numbers& numbers) {
    for (const std::size_t l : told_by_[part]) {
      Link& link = links_[l];
      Number* told = link.told.data() + link.half(now.number);
      for (std::uint32_t i = link.first[now.pass.begin]; i < link.first[now.pass.end]; ++i)
        told[i] = numbers[link.from[i]];
    }
  }

 private:
  static constexpr std::size_t apart = 64 / sizeof(Number);  // a line of the cache
  struct Link {                                              // from one part to another
    std::uint32_t owner, reader;
    std::vector<std::uint32_t> from{}, to{}, first{};  // copies by chunk: from first[chunk] on
    std::vector<Number> told{};                        // in passes with an even number, then in those with an odd one

    std::size_t half(std::size_t pass) const { return pass % 2 * (from.size() + apart); }
  };
  std::vector<Link> links_;
  std::vector<std::vector<std::size_t>> told_by_, read_by_;  // links, by part
};

}  // namespace waymark::plan

#include "libplan/roads/road_hierarchy.hpp"

#include <algorithm>
#include <array>
#include <istream>
#include <iterator>
#include <ostream>
#include <stdexcept>
#include <string>
#include <utility>

#include "libltl/diagnostic.hpp"
#include "libltl/text/xxhash.hpp"

namespace waymark::plan {
namespace {

constexpr std::string_view heading = "waymark roads 1\n";
constexpr std::size_t arcs_a_block = std::size_t{1} << 18U;
constexpr std::size_t most_believed = std::size_t{1} << 26U;  // entries, in advance

static_assert(sizeof(RoadHierarchy::Arc) == 16, "arcs are written as they are stored");

template <class T>
void write_list(std::ostream& out, const std::vector<T>& values) {
  const std::string_view bytes(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T));
  const std::array<std::uint64_t, 2> sizes{values.size(), ltl::xxh64(bytes)};
  out.write(reinterpret_cast<const char*>(sizes.data()), sizeof sizes);
  out << bytes;
}

class ListReader {
 public:
  ListReader(std::istream& in, std::string_view source) : in_(in), source_(source) {}
  [[noreturn]] void fail(const std::string& message) const { throw ltl::FormatError(source_, 0, 0, message); }
  void heading_line() {
    std::string read(heading.size(), ' ');
    take(read.data(), read.size());
    if (read != heading) fail("this is no hierarchy of roads");
  }
  template <class T>
  std::vector<T> list(std::size_t most) {
    std::array<std::uint64_t, 2> sizes{};
    take(reinterpret_cast<char*>(sizes.data()), sizeof sizes);
    if (sizes[0] > most) fail("the hierarchy is damaged: a list is too long");
    std::vector<T> out;
    constexpr std::size_t block = std::size_t{1} << 22U;  // a length that lies costs no more memory than the file has
    while (out.size() < sizes[0]) {
      const std::size_t size = out.size(), more = std::min<std::size_t>(block, sizes[0] - size);
      if (size == 0) out.reserve(std::min<std::size_t>(sizes[0], most_believed));
      out.resize(size + more);
      take(reinterpret_cast<char*>(out.data() + size), more * sizeof(T));
    }
    if (ltl::xxh64({reinterpret_cast<const char*>(out.data()), out.size() * sizeof(T)}) != sizes[1])
      fail("the hierarchy is damaged: its checksum does not fit");
    return out;
  }
  void expect_end() {
    if (in_.peek() != std::istream::traits_type::eof()) fail("the hierarchy is damaged: there is more behind it");
  }

 private:
  void take(char* to, std::size_t bytes) {
    in_.read(to, static_cast<std::streamsize>(bytes));
    if (static_cast<std::size_t>(in_.gcount()) != bytes) fail("the hierarchy is cut short");
  }
  std::istream& in_;
  std::string source_;
};

void expect(bool holds, const char* what) {
  if (!holds) throw std::invalid_argument(what);
}

}  // namespace

RoadHierarchy::RoadHierarchy(Parts parts) : parts_(std::move(parts)), node_(parts_.rank.size(), UINT32_MAX) {
  const std::size_t nodes = parts_.rank.size();
  for (std::uint32_t v = 0; v < nodes; ++v) {
    expect(parts_.rank[v] < nodes && node_[parts_.rank[v]] == UINT32_MAX, "ranks that are no permutation");
    node_[parts_.rank[v]] = v;
  }
  expect(parts_.core <= nodes && parts_.bits.size() <= most_bits, "a core or bits out of range");
  expect(!parts_.sets.empty() && parts_.sets[0] == 0, "a first set that is not empty");
  expect(parts_.rows.size() == nodes, "rows of other ranks");
  for (std::uint32_t r = 0; r < nodes; ++r) {
    expect(std::size_t{parts_.rows[r].begin} + parts_.rows[r].size <= parts_.arcs.size(), "rows out of range");
    arcs_ += parts_.rows[r].size;
    for (std::uint32_t a = begin_arcs(r); a < end_arcs(r); ++a) {
      const Arc& arc = parts_.arcs[a];
      expect(arc.head < nodes && (r < parts_.core ? arc.head > r : arc.head >= parts_.core), "an arc that leads down");
      expect(arc.middle == road || arc.middle < std::min({r, arc.head, parts_.core}), "a middle above an end");
      expect(arc.passed < parts_.sets.size() && arc.ways >= forward && arc.ways <= (forward | backward),
             "an arc of no kind");
    }
  }
}

// From the middle of a shortcut to its end, at this cost, past no letters but those of the shortcut.
const RoadHierarchy::Arc* RoadHierarchy::way_out(std::uint32_t middle, std::uint32_t end, std::uint32_t cost,
                                                 const Arc& whole) const {
  for (std::uint32_t a = begin_arcs(middle); a < end_arcs(middle); ++a) {
    const Arc& arc = parts_.arcs[a];
    if (arc.head == end && (arc.ways & forward) != 0 && arc.cost == cost &&
        (parts_.sets[arc.passed] & ~parts_.sets[whole.passed]) == 0)
      return &arc;
  }
  return nullptr;
}

void RoadHierarchy::unpack(std::uint32_t from, std::uint32_t to, const Arc& whole,
                           std::vector<std::uint32_t>& nodes) const {
  struct Piece {
    std::uint32_t from, to;
    Arc arc;
  };
  std::vector<Piece> open{{from, to, whole}};
  while (!open.empty()) {
    const Piece piece = open.back();
    open.pop_back();
    if (piece.arc.middle == road) {
      nodes.push_back(node_[piece.to]);
      continue;
    }
    const std::uint32_t middle = piece.arc.middle;
    const Arc *in = nullptr, *out = nullptr;
    for (std::uint32_t a = begin_arcs(middle); a < end_arcs(middle) && out == nullptr; ++a) {
      in = &parts_.arcs[a];
      if (in->head != piece.from || (in->ways & backward) == 0 || in->cost > piece.arc.cost) continue;
      if ((parts_.sets[in->passed] & ~parts_.sets[piece.arc.passed]) != 0) continue;
      out = way_out(middle, piece.to, piece.arc.cost - in->cost, piece.arc);
    }
    if (out == nullptr) throw std::logic_error("a shortcut without halves");
    open.push_back({middle, piece.to, *out});
    open.push_back({piece.from, middle, *in});
  }
}

void write_hierarchy(std::ostream& out, const RoadHierarchy& hierarchy) {
  const RoadHierarchy::Parts& parts = hierarchy.parts_;
  out << heading;
  write_list(out, std::vector<std::uint64_t>{parts.map, parts.core});
  write_list(out, parts.rank);
  std::vector<std::uint16_t> sizes;
  for (const RoadHierarchy::Row& row : parts.rows) sizes.push_back(row.size);
  write_list(out, sizes);
  std::vector<RoadHierarchy::Arc> block;  // rows in the order of ranks, in blocks of whole rows
  for (const RoadHierarchy::Row& row : parts.rows) {
    block.insert(block.end(), parts.arcs.begin() + row.begin, parts.arcs.begin() + row.begin + row.size);
    if (block.size() < arcs_a_block) continue;
    write_list(out, block);
    block.clear();
  }
  write_list(out, block);
  write_list(out, parts.sets);
  write_list(out, parts.bits);
}

RoadHierarchy read_hierarchy(std::istream& in, std::string_view source, const RoadGraph& map) {
  ListReader reader(in, source);
  reader.heading_line();
  const auto numbers = reader.list<std::uint64_t>(2);
  if (numbers.size() != 2 || numbers[1] > map.nodes()) reader.fail("the hierarchy is damaged: expected two numbers");
  if (numbers[0] != map.checksum()) reader.fail("this hierarchy is one of another map: preprocess this one");
  RoadHierarchy::Parts parts;
  parts.map = numbers[0];
  parts.core = static_cast<std::uint32_t>(numbers[1]);
  parts.rank = reader.list<std::uint32_t>(map.nodes());
  const auto sizes = reader.list<std::uint16_t>(map.nodes());
  if (parts.rank.size() != map.nodes() || sizes.size() != map.nodes())
    reader.fail("the hierarchy is damaged: it has another number of nodes");
  parts.rows.resize(sizes.size());
  std::size_t arcs = 0;
  for (std::size_t r = 0; r < sizes.size(); ++r) {
    parts.rows[r] = {static_cast<std::uint32_t>(arcs), sizes[r], 0};
    arcs += sizes[r];
    if (arcs >= UINT32_MAX) reader.fail("the hierarchy is damaged: it has too many arcs");
  }
  for (std::uint32_t v = 0; v < map.nodes(); ++v)
    if (parts.rank[v] < map.nodes()) parts.rows[parts.rank[v]].letter = static_cast<std::uint16_t>(map.letter(v).index);
  for (bool more = true; more;) {
    const auto block = reader.list<RoadHierarchy::Arc>(arcs_a_block + UINT16_MAX);
    if (parts.arcs.empty()) parts.arcs.reserve(std::min(arcs, most_believed));
    parts.arcs.insert(parts.arcs.end(), block.begin(), block.end());
    more = block.size() >= arcs_a_block;
  }
  if (parts.arcs.size() != arcs) reader.fail("the hierarchy is damaged: it has another number of arcs");
  parts.sets = reader.list<std::uint64_t>(std::size_t{1} << 16U);
  parts.bits = reader.list<std::uint32_t>(RoadHierarchy::most_bits);
  reader.expect_end();
  for (const std::uint32_t letter : parts.bits)
    if (letter == 0 || letter >= map.letters().size()) reader.fail("the hierarchy is damaged: an unknown letter");
  try {
    return RoadHierarchy(std::move(parts));
  } catch (const std::invalid_argument& error) {
    reader.fail(std::string("the hierarchy is damaged: ") + error.what());
  }
}

}  // namespace waymark::plan

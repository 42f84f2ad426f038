#include "libplan/model/formats/generate_grid.hpp"

#include <algorithm>
#include <charconv>
#include <optional>
#include <ostream>
#include <stdexcept>
#include <utility>

#include "libltl/structure/random.hpp"

namespace waymark::plan {
namespace {

constexpr std::string_view one_way_glyphs = "^>v<";  // N E S W
constexpr std::uint32_t pitch = 10;                  // of rooms and bridges
constexpr std::uint32_t block = 4;                   // of streets

class Drawing {
 public:
  Drawing(const GridRecipe& recipe, ltl::Random& random)
      : recipe_(recipe),
        width_(recipe.width),
        height_(recipe.height),
        random_(random),
        rows_(height_, std::string(width_, '.')) {}

  std::vector<std::string> draw() {
    switch (recipe_.kind) {
      case GridKind::Rooms: rooms(); break;
      case GridKind::Maze: maze(); break;
      case GridKind::Scatter: scatter(); break;
      case GridKind::Bridge: bridges(); break;
      case GridKind::OneWay: streets(); break;
    }
    return std::move(rows_);
  }

 private:
  std::uint32_t below(std::uint32_t bound) { return static_cast<std::uint32_t>(random_.below(bound)); }

  // Walls every `pitch` cells, one door between any two rooms that touch.
  void rooms() {
    for (std::uint32_t y = 0; y < height_; ++y)
      for (std::uint32_t x = 0; x < width_; ++x)
        if ((x > 0 && x % pitch == 0) || (y > 0 && y % pitch == 0)) rows_[y][x] = '#';
    const auto inside = [&](std::uint32_t first,
                            std::uint32_t size) {  // a place in the room that starts there
      const std::uint32_t from = first == 0 ? 0 : first + 1, to = std::min(first + pitch, size);
      return to > from ? std::optional(from + below(to - from)) : std::nullopt;
    };
    for (std::uint32_t y = 0; y < height_; y += pitch)
      for (std::uint32_t x = 0; x < width_; x += pitch) {
        if (const auto door = inside(y, height_); door && x > 0) rows_[*door][x] = '.';
        if (const auto door = inside(x, width_); door && y > 0) rows_[y][*door] = '.';
      }
  }

  // A spanning tree of the cells with even coordinates, drawn depth first.
  void maze() {
    for (std::string& row : rows_) row.assign(width_, '#');
    std::vector<std::pair<std::uint32_t, std::uint32_t>> trail{{0, 0}};
    rows_[0][0] = '.';
    while (!trail.empty()) {
      const auto [x, y] = trail.back();
      std::array<std::uint32_t, 4> ways{};
      std::uint32_t count = 0;
      if (y >= 2 && rows_[y - 2][x] == '#') ways[count++] = 0;
      if (x + 2 < width_ && rows_[y][x + 2] == '#') ways[count++] = 1;
      if (y + 2 < height_ && rows_[y + 2][x] == '#') ways[count++] = 2;
      if (x >= 2 && rows_[y][x - 2] == '#') ways[count++] = 3;
      if (count == 0) {
        trail.pop_back();
        continue;
      }
      const std::uint32_t d = ways[below(count)];
      const std::uint32_t dx = d == 1 ? 1 : d == 3 ? UINT32_MAX : 0, dy = d == 2 ? 1 : d == 0 ? UINT32_MAX : 0;
      rows_[y + dy][x + dx] = rows_[y + 2 * dy][x + 2 * dx] = '.';
      trail.emplace_back(x + 2 * dx, y + 2 * dy);
    }
  }

  void scatter() {  // one cell in eight a hazard, one in twenty a wall
    for (std::string& row : rows_)
      for (char& cell : row) {
        const std::uint32_t drawn = below(40);
        if (drawn < 7) cell = drawn < 5 ? 'x' : '#';
      }
  }

  // Strips of hazards, three cells wide, with a way two cells wide over each.
  void bridges() {
    for (std::uint32_t left = pitch / 2; left + 3 < width_; left += pitch) {
      const std::uint32_t way = below(height_ - 1);
      for (std::uint32_t y = 0; y < height_; ++y)
        if (y != way && y != way + 1) rows_[y].replace(left, 3, 3, 'x');
    }
  }

  // Streets around blocks; on half of the streets one goes one way only, but for every fourth stretch.
  void streets() {
    std::vector<std::optional<std::uint32_t>> eastward(height_ / block + 1), southward(width_ / block + 1);
    for (auto& d : eastward) d = below(2) == 0 ? std::optional(below(2) == 0 ? 1U : 3U) : std::nullopt;
    for (auto& d : southward) d = below(2) == 0 ? std::optional(below(2) == 0 ? 0U : 2U) : std::nullopt;
    for (std::uint32_t y = 0; y < height_; ++y)
      for (std::uint32_t x = 0; x < width_; ++x) {
        const bool along = y % block == 0, across = x % block == 0;
        if (along && across) continue;
        if (!along && !across) {
          rows_[y][x] = '#';
          continue;
        }
        const auto& way = along ? eastward[y / block] : southward[x / block];
        const std::uint32_t stretch = (along ? x + y : y + x) / block;
        if (way && stretch % 4 != 0) rows_[y][x] = one_way_glyphs[*way];
      }
  }

  const GridRecipe& recipe_;
  const std::uint32_t width_, height_;
  ltl::Random& random_;
  std::vector<std::string> rows_;
};

// The plain cells that are reached from a cell, walls, hazards and one-way cells heeded; row by row.
std::vector<std::uint32_t> reached(const std::vector<std::string>& rows, std::uint32_t start) {
  const auto width = static_cast<std::uint32_t>(rows[0].size()), height = static_cast<std::uint32_t>(rows.size());
  const auto open = [](char cell, std::size_t d) {
    const std::size_t one_way = one_way_glyphs.find(cell);
    return cell == '.' || one_way == d;
  };
  std::vector<bool> met(std::size_t{width} * height);
  std::vector<std::uint32_t> stack{start};
  met[start] = true;
  while (!stack.empty()) {
    const std::uint32_t cell = stack.back(), x = cell % width, y = cell / width;
    stack.pop_back();
    const std::array<bool, 4> inside{y > 0, x + 1 < width, y + 1 < height, x > 0};
    const std::array<std::uint32_t, 4> next{cell - width, cell + 1, cell + width, cell - 1};
    for (std::size_t d = 0; d < 4; ++d) {
      if (!inside[d] || met[next[d]] || !open(rows[y][x], d) || !open(rows[next[d] / width][next[d] % width], d))
        continue;
      met[next[d]] = true;
      stack.push_back(next[d]);
    }
  }
  std::vector<std::uint32_t> out;
  for (std::uint32_t cell = 0; cell < met.size(); ++cell)
    if (met[cell] && rows[cell / width][cell % width] == '.') out.push_back(cell);
  return out;
}

bool has_hazards(GridKind kind) { return kind == GridKind::Scatter || kind == GridKind::Bridge; }

void check(const GridRecipe& recipe) {
  if (recipe.width < 3 || recipe.height < 3 || std::size_t{recipe.width} * recipe.height > GridWorld::max_cells)
    throw std::invalid_argument("a map is 3 to some thousand cells wide and high");
  if (recipe.landmarks > GridRecipe::most_landmarks)
    throw std::invalid_argument("at most " + std::to_string(GridRecipe::most_landmarks) + " landmarks");
  if (!(recipe.noise >= 0 && recipe.noise * (has_hazards(recipe.kind) ? 3 : 2) <= 1))
    throw std::invalid_argument("the chances to slip are negative or more than 1 together");
}

SlipChances motion(const GridRecipe& recipe) {
  const double p = recipe.noise;
  return has_hazards(recipe.kind) ? SlipChances{1 - 3 * p, p, p, p} : SlipChances{1 - 2 * p, p, p, 0};
}

std::string joined(const std::vector<std::string>& names, const char* before, const char* between) {
  std::string out;
  for (const std::string& name : names) out += (out.empty() ? "" : between) + ('(' + (before + name) + ')');
  return out;
}

std::vector<CaseTask> tasks(const GridRecipe& recipe, const std::vector<std::string>& landmarks) {
  using Query = CaseTask::Query;
  using Logic = CaseTask::Logic;
  std::vector<CaseTask> out;
  if (landmarks.empty()) return out;
  std::string sequence, careful;
  for (std::size_t i = landmarks.size(); i-- > 0;) {
    const std::string& here = landmarks[i];
    sequence = "F (" + here + (sequence.empty() ? ")" : " & (" + sequence + "))");
    careful = "(!x) U (" + here + (careful.empty() ? ")" : " & (" + careful + "))");
  }
  out.push_back({"seq", sequence, Logic::Ltl, Query::MinCost});
  out.push_back({"cover", joined(landmarks, "F ", " & "), Logic::Ltl, Query::MinCost});
  out.push_back({"patrol", joined(landmarks, "G F ", " & "), Logic::Ltl, Query::MaxProbability});
  if (has_hazards(recipe.kind)) out.push_back({"avoidseq", careful, Logic::Ltl, Query::MaxProbability});
  if (recipe.noise == 0) {
    std::string names;
    for (const std::string& landmark : landmarks) names += (names.empty() ? "" : ",") + landmark;
    out.push_back({"tour", "patrol:" + names, Logic::Derived, Query::MinCycle});
  }
  return out;
}

// Start and landmarks on different plain cells that the start reaches; false: the drawing has too few.
bool settle(GridText& grid, const GridRecipe& recipe, ltl::Random& random) {
  std::vector<std::uint32_t> plain;
  for (std::uint32_t cell = 0; cell < recipe.width * recipe.height; ++cell)
    if (grid.rows[cell / recipe.width][cell % recipe.width] == '.') plain.push_back(cell);
  if (plain.empty()) return false;
  const std::uint32_t start = plain[random.below(plain.size())];
  std::vector<std::uint32_t> cells = reached(grid.rows, start);
  if (cells.size() < recipe.landmarks + 1 || 2 * cells.size() < plain.size()) return false;
  grid.x = start % recipe.width;
  grid.y = start / recipe.width;
  cells.erase(std::find(cells.begin(), cells.end(), start));
  for (std::uint32_t i = 0; i < recipe.landmarks; ++i) {
    const std::size_t drawn = random.below(cells.size());
    const std::uint32_t cell = cells[drawn];
    cells[drawn] = cells.back();
    cells.pop_back();
    const char glyph = static_cast<char>('a' + i);
    grid.rows[cell / recipe.width][cell % recipe.width] = glyph;
    grid.landmarks.emplace_back(1, glyph);
  }
  return true;
}

std::string text(double value) {  // the shortest that reads back
  std::array<char, 32> out{};
  return {out.data(), std::to_chars(out.data(), out.data() + out.size(), value).ptr};
}

std::string_view name(CaseTask::Logic logic) { return logic == CaseTask::Logic::Ltl ? "ltl" : "derived"; }

}  // namespace

std::string_view name(GridKind kind) {
  switch (kind) {
    case GridKind::Rooms: return "rooms";
    case GridKind::Maze: return "maze";
    case GridKind::Scatter: return "scatter";
    case GridKind::Bridge: return "bridge";
    case GridKind::OneWay: return "oneway";
  }
  return {};
}

GridText generate_grid(const GridRecipe& recipe) {
  check(recipe);
  ltl::Random random(recipe.seed);
  for (int drawing = 0; drawing < 100; ++drawing) {
    GridText out;
    out.rows = Drawing(recipe, random).draw();
    if (!settle(out, recipe, random)) continue;
    out.name = std::string(name(recipe.kind)) + '-' + std::to_string(recipe.width) + 'x' +
               std::to_string(recipe.height) + "-k" + std::to_string(recipe.landmarks) + "-s" +
               std::to_string(recipe.seed);
    out.motion = motion(recipe);
    if (recipe.tasks) out.tasks = tasks(recipe, out.landmarks);
    return out;
  }
  throw std::invalid_argument("no such map with its landmarks within reach was found in a hundred drawings");
}

void write_case(std::ostream& out, const GridText& grid) {
  const auto has = [&](char glyph) {
    return std::any_of(grid.rows.begin(), grid.rows.end(),
                       [&](const std::string& row) { return row.find(glyph) != std::string::npos; });
  };
  out << "{\"format\": \"ltlgrid/1\", \"name\": \"" << grid.name << "\", \"width\": " << grid.rows[0].size()
      << ", \"height\": " << grid.rows.size() << ",\n \"legend\": {\"#\": {\"wall\": true}";
  for (std::size_t d = 0; d < 4; ++d)
    if (has(one_way_glyphs[d]))
      out << ", \"" << one_way_glyphs[d] << "\": {\"oneway\": \"" << name(all_compass[d]) << "\"}";
  if (has('x')) out << R"(, "x": {"props": ["x"]})";
  for (const std::string& l : grid.landmarks) out << ", \"" << l << "\": {\"props\": [\"" << l << "\"]}";
  out << "},\n \"start\": {\"x\": " << grid.x << ", \"y\": " << grid.y
      << "}, \"moves\": [\"N\", \"E\", \"S\", \"W\"],\n \"motion\": {\"forward\": " << text(grid.motion.forward)
      << ", \"left\": " << text(grid.motion.left) << ", \"right\": " << text(grid.motion.right)
      << ", \"back\": " << text(grid.motion.back)
      << ", \"blocked\": \"stay\"}, \"cost\": {\"step\": 1},\n \"tasks\": [";
  for (std::size_t i = 0; i < grid.tasks.size(); ++i) {
    const CaseTask& task = grid.tasks[i];
    out << (i == 0 ? "\n" : ",\n") << R"(  {"id": ")" << task.id << R"(", "logic": ")" << name(task.logic)
        << R"(", "formula": ")" << task.formula << R"(", "query": ")" << plan::name(task.query) << "\"}";
  }
  out << "],\n \"rows\": [\n";
  for (std::size_t y = 0; y < grid.rows.size(); ++y)
    out << "  \"" << grid.rows[y] << (y + 1 < grid.rows.size() ? "\",\n" : "\"\n");
  out << " ]}\n";
}

}  // namespace waymark::plan

// The maps of the studio: those that come with waymark, read once, and those that its users hand over.
//
// A map that is handed over is kept in memory, under a name made of its contents, and never written. The oldest one
// is dropped when there are too many.
#pragma once
#include <cstddef>
#include <deque>
#include <filesystem>
#include <memory>
#include <mutex>
#include <string>
#include <string_view>
#include <vector>

#include "libparser/programs/execute.hpp"
#include "libplan/world/map.hpp"

namespace waymark::studio {

struct World {  // the executor refers to the map
  World(std::string id_, plan::Map read) : id(std::move(id_)), map(std::move(read)), executor(map) {}
  World(const World&) = delete;
  World& operator=(const World&) = delete;
  const std::string id;
  const plan::Map map;
  const parser::Executor executor;
};

class Worlds {
 public:
  static constexpr std::size_t most_given = 16, most_nodes = 2'000;
  static constexpr int most_extent = 1'000;  // from the westernmost to the easternmost node, and so on

  explicit Worlds(const std::filesystem::path& data);  // of the maps in data/maps

  std::vector<std::string> names() const;
  std::shared_ptr<const World> of(const std::string& id) const;  // throws RequestError 404
  // Throws ltl::FormatError where the text is no map, RequestError where the map is too large.
  std::shared_ptr<const World> add(std::string_view json);

 private:
  mutable std::mutex mutex_;
  std::vector<std::shared_ptr<const World>> shipped_;
  std::deque<std::shared_ptr<const World>> given_;  // newest last
};

}  // namespace waymark::studio

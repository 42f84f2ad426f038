#include "tools/studio/worlds.hpp"

#include <algorithm>
#include <cstdint>

#include "libplan/world/read_map.hpp"
#include "tools/studio/request.hpp"

namespace waymark::studio {
namespace {

// FNV-1a, 64 bits: contents and not secrets.
std::string name_of_contents(std::string_view text) {
  std::uint64_t hash = 0xcbf29ce484222325U;
  for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3U;
  constexpr std::string_view digits = "0123456789abcdef";
  std::string name = "given-";
  for (int shift = 60; shift >= 0; shift -= 4) name += digits[(hash >> static_cast<unsigned>(shift)) & 15U];
  return name;
}

int extent(const std::vector<plan::Node>& nodes, int plan::Node::*coordinate) {
  const auto [least, most] =
      std::minmax_element(nodes.begin(), nodes.end(),
                          [&](const plan::Node& a, const plan::Node& b) { return a.*coordinate < b.*coordinate; });
  return (*most).*coordinate - (*least).*coordinate;
}

}  // namespace

Worlds::Worlds(const std::filesystem::path& data) {
  for (const std::string& name : plan::shipped_maps(data))
    shipped_.push_back(
        std::make_shared<World>(name, plan::read_map((data / "maps" / (name + ".json")).string(), data)));
}

std::vector<std::string> Worlds::names() const {
  std::vector<std::string> out;
  for (const auto& world : shipped_) out.push_back(world->id);
  return out;
}

std::shared_ptr<const World> Worlds::of(const std::string& id) const {
  const auto is_it = [&](const std::shared_ptr<const World>& world) { return world->id == id; };
  if (const auto found = std::find_if(shipped_.begin(), shipped_.end(), is_it); found != shipped_.end()) return *found;
  const std::lock_guard lock(mutex_);
  if (const auto found = std::find_if(given_.begin(), given_.end(), is_it); found != given_.end()) return *found;
  throw RequestError(404, "no such map",
                     id.starts_with("given-") ? "this map is no longer there: hand its file over again"
                                              : "there is no map of that name");
}

std::shared_ptr<const World> Worlds::add(std::string_view json) {
  plan::Map map = plan::parse_map(json, "the file");
  if (map.nodes().size() > most_nodes)
    throw RequestError(413, "too large", "the map has more than " + std::to_string(most_nodes) + " nodes");
  if (std::max(extent(map.nodes(), &plan::Node::x), extent(map.nodes(), &plan::Node::y)) > most_extent)
    throw RequestError(413, "too large", "the map is wider or higher than " + std::to_string(most_extent));
  auto world = std::make_shared<const World>(name_of_contents(json), std::move(map));
  const std::lock_guard lock(mutex_);
  std::erase_if(given_, [&](const auto& old) { return old->id == world->id; });
  given_.push_back(world);
  if (given_.size() > most_given) given_.pop_front();
  return world;
}

}  // namespace waymark::studio

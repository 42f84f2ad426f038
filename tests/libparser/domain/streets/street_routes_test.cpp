#include "libparser/domain/streets/street_routes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "tests/libparser/domain/streets/town.hpp"

namespace waymark::streets {
namespace {

// Every simple route, by the definition, in the order of length and landmarks.
void all_routes(const StreetMap& map, LandmarkIndex goal, StreetRoute& route, double length,
                std::vector<RankedRoute>& out) {
  if (route.back() == goal) {
    out.push_back({route, length});
    return;
  }
  for (const Way& way : map.ways[route.back()]) {
    if (std::find(route.begin(), route.end(), way.to) != route.end()) continue;
    route.push_back(way.to);
    all_routes(map, goal, route, length + way.length, out);
    route.pop_back();
  }
}

StreetMap random_town(std::mt19937_64& random, std::size_t landmarks) {
  StreetMap map;
  map.name = "random";
  for (std::size_t i = 0; i < landmarks; ++i) {
    const auto coordinate = [&] { return static_cast<double>(random() % 1000); };
    const double right = coordinate(), up = coordinate();
    map.landmarks.push_back({static_cast<int>(i), "L" + std::to_string(i), right, up});
  }
  map.ways.resize(landmarks);
  for (LandmarkIndex a = 0; a < landmarks; ++a)
    for (LandmarkIndex b = 0; b < landmarks; ++b) {
      const bool joined = a != b && (std::min(a, b) * 7 + std::max(a, b) * 5 + landmarks) % 3 != 0;
      if (joined) map.ways[a].push_back({b, map.distance(a, b)});
    }
  return map;
}

TEST(StreetRoutes, AreTheShortestSimpleOnesInOrder) {
  std::mt19937_64 random(1);
  for (std::size_t round = 0; round < 40; ++round) {
    const StreetMap map = random_town(random, 3 + round % 5);
    for (LandmarkIndex goal = 1; goal < map.landmarks.size(); ++goal) {
      std::vector<RankedRoute> expected;
      StreetRoute route{0};
      all_routes(map, goal, route, 0, expected);
      std::stable_sort(expected.begin(), expected.end(),
                       [](const RankedRoute& a, const RankedRoute& b) { return a.length < b.length; });
      const auto found = shortest_simple_routes(map, 0, goal, expected.size() + 1);
      ASSERT_EQ(found.size(), expected.size()) << "round " << round << ", goal " << goal;
      for (std::size_t i = 0; i < found.size(); ++i) {
        EXPECT_NEAR(found[i].length, expected[i].length, 1e-9)
            << "round " << round << ", goal " << goal << ", rank " << i;
        EXPECT_EQ(found[i].landmarks, expected[i].landmarks)
            << "round " << round << ", goal " << goal << ", rank " << i;
      }
    }
  }
}

TEST(StreetRoutes, AvoidWhatIsToBeAvoided) {
  const StreetMap map = town();
  std::vector<bool> avoided(map.landmarks.size(), false);
  EXPECT_EQ(shortest_street_route(map, church, museum, avoided), (StreetRoute{church, bakery, old_mill, museum}));
  avoided[bakery] = true;
  EXPECT_EQ(shortest_street_route(map, church, museum, avoided),
            (StreetRoute{church, cafe, well, new_mill, old_mill, museum}));
  avoided[old_mill] = true;
  EXPECT_TRUE(shortest_street_route(map, church, museum, avoided).empty());
}

}  // namespace
}  // namespace waymark::streets

#include "libplan/certify.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

#include "libautomata/finite/ltlf_to_dfa.hpp"
#include "libltl/diagnostic.hpp"
#include "libltl/text/parse.hpp"
#include "tests/libplan/maps.hpp"

namespace waymark::plan {
namespace {

std::string verdict(const Route& route, const Map& map, const std::string& formula) {
  ltl::Arena arena;
  const ltl::Formula f = ltl::parse(formula, arena);
  try {
    EXPECT_EQ(certify(route, map, f).formula(), f);
    return "certified";
  } catch (const std::logic_error& error) {
    return error.what();
  }
}

TEST(Certify, ChecksStepsCostAndWord) {
  const Map map = hallway(2);
  const Route route = priced(parse_trajectory("0,0,90 FORWARD FORWARD", map), map);
  EXPECT_EQ(verdict(route, map, "F chair"), "certified");
  EXPECT_EQ(verdict(route, map, "F (chair & X true)"),
            "certify: the route 0,0,90 FORWARD FORWARD does not satisfy the formula");
  Route jumps = route;
  jumps.poses[1] = pose_at(map, 2, 0, 90);
  EXPECT_EQ(verdict(jumps, map, "F chair"), "certify: step 1, FORWARD from (0,0,90), is no step of the map");
  Route cheap = route;
  cheap.cost = 1;
  EXPECT_EQ(verdict(cheap, map, "F chair"), "certify: the route costs 2.000000, not 1.000000");
  Route torn = route;
  torn.poses.pop_back();
  EXPECT_EQ(verdict(torn, map, "F chair"), "certify: a route has one pose more than it has actions");
  EXPECT_EQ(verdict(Route{}, map, "true"), "certify: a route has one pose more than it has actions");
}

TEST(Certify, MatchesPropositionsByName) {
  const Map map = hallway(2);
  const Route route = priced(parse_trajectory("0,0,90 FORWARD FORWARD", map), map);
  ltl::Arena arena;  // chair and moved stand elsewhere in this vocabulary than in the map's
  const ltl::Formula f = ltl::parse("F (chair & moved) & !moved", arena);
  EXPECT_EQ(certify(route, map, f).route().poses, route.poses);
  EXPECT_THROW(certify(route, map, ltl::parse("F chiar", arena)), ltl::FormatError);
}

TEST(Certify, AnAutomatonCanBeTheTask) {
  const Map map = hallway(2);
  ltl::Arena arena;
  const automata::Dfa dfa = automata::ltlf_to_dfa(ltl::parse("F chair", arena));
  const Route there = priced(parse_trajectory("0,0,90 FORWARD FORWARD", map), map);
  EXPECT_EQ(certify_acceptance(there, map, dfa).route().actions, there.actions);
  const Route half = priced(parse_trajectory("0,0,90 FORWARD", map), map);
  EXPECT_THROW(certify_acceptance(half, map, dfa), std::logic_error);
}

}  // namespace
}  // namespace waymark::plan

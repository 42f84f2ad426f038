#include <iostream>

#include "libautomata/finite/ltlf_to_dfa.hpp"
#include "libltl/diagnostic.hpp"
#include "libltl/text/parse.hpp"
#include "libparser/ground.hpp"
#include "libplan/certify.hpp"
#include "libplan/solve/shortest_route.hpp"
#include "libplan/world/read_map.hpp"

using namespace waymark;

// The directory of the maps, then a formula.
int main(int argc, char** argv) try {
  const plan::Map map = plan::read_map("grid", std::string(argv[1]));
  ltl::Arena arena(map.vocabulary());
  const ltl::Formula phi =
      ltl::parse(argc > 2 ? argv[2] : "F (chair & X moved)", arena, {.unknown = ltl::Unknown::Reject});
  const automata::Dfa dfa = automata::ltlf_to_dfa(phi);
  const plan::MapProduct product = plan::compose(map, dfa, map.find({1, 9, 0}).value());
  const auto solved = std::get<plan::Solved>(plan::solve(product, plan::ShortestRoute{}));
  const auto certified = plan::certify(plan::roll_out(product, solved.policy), map, phi);
  std::cout << "certified:";
  for (plan::Action action : certified.route().actions) std::cout << ' ' << plan::name(action);
  std::cout << '\n';
} catch (
    const ltl::SyntaxError& error) {  // of a formula: "unknown proposition 'chiar' (did you mean 'chair'?)", a caret
  std::cerr << error.what() << '\n';
  return 1;
}

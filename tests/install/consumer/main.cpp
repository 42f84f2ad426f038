#include <iostream>

#include "libautomata/finite/ltlf_to_dfa.hpp"
#include "libltl/text/parse.hpp"
#include "libparser/ground.hpp"
#include "libplan/certify.hpp"
#include "libplan/solve/shortest_route.hpp"
#include "libplan/world/read_map.hpp"

using namespace waymark;

int main(int, char** argv) {
  const plan::Map map = plan::read_map("grid", std::string(argv[1]));
  ltl::Arena arena(map.vocabulary());
  const ltl::Formula phi = ltl::parse("F (chair & X moved)", arena);
  const automata::Dfa dfa = automata::ltlf_to_dfa(phi);
  const plan::MapProduct product = plan::compose(map, dfa, map.find({1, 9, 0}).value());
  const auto solved = std::get<plan::Solved>(plan::solve(product, plan::ShortestRoute{}));
  const auto certified = plan::certify(plan::roll_out(product, solved.policy), map, phi);
  std::cout << "certified:";
  for (plan::Action action : certified.route().actions) std::cout << ' ' << plan::name(action);
  std::cout << '\n';
}

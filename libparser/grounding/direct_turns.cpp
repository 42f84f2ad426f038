#include "libparser/grounding/direct_turns.hpp"

#include <algorithm>
#include <optional>
#include <unordered_map>
#include <vector>

#include "libltl/structure/substitute.hpp"

namespace waymark::parser {

ltl::Formula with_direct_turns(ltl::Formula f) {
  ltl::Arena& arena = f.arena();
  const auto left = arena.vocabulary().find("turned_left"), right = arena.vocabulary().find("turned_right");
  if (!left || !right) return f;
  const ltl::Formula turned_left = arena.atom(*left), turned_right = arena.atom(*right);
  const ltl::Formula turned = ltl::disjunction(turned_left, turned_right);
  std::unordered_map<ltl::Formula, ltl::Formula> image;
  for (const ltl::Formula g : ltl::subformulas(f)) {
    std::vector<ltl::Formula> operands;
    for (const ltl::Formula operand : g.operands()) operands.push_back(image.at(operand));
    std::optional<ltl::Formula> direct;
    if (g.op() == ltl::Op::Until && g[0] == turned && g[1].op() == ltl::Op::And) {
      const auto goals = g[1].operands();
      const bool turns = std::any_of(goals.begin(), goals.end(),
                                     [&](ltl::Formula goal) { return goal == turned_left || goal == turned_right; });
      std::vector<ltl::Formula> rest;
      for (const ltl::Formula goal : goals)
        if (goal != turned) rest.push_back(image.at(goal));
      if (turns) direct = ltl::conjunction(arena, rest);
    }
    image.emplace(g, direct ? *direct : ltl::with_operands(g, arena, operands));
  }
  return image.at(f);
}

}  // namespace waymark::parser

#include "libparser/supervision/constrained_search.hpp"

#include <algorithm>
#include <optional>

#include "libparser/lexicon/lexicon.hpp"
#include "libparser/supervision/lexical_overlap.hpp"

namespace waymark::parser {
namespace {

using plan::Direction;

struct Unit {
  Program program;
  std::size_t end;  // how much of the gold route is done after it
};

struct Said {
  Program program;
  double lexical_overlap_penalty;
};

class SaidSearch {
 public:
  SaidSearch(const Executor& executor, const ProgramLanguage& language, const GoldRoute& gold,
             const std::vector<std::string>& tokens, UnitPlans& plans)
      : executor_(executor),
        grammar_(language.grammar()),
        gold_(gold),
        plans_(plans),
        wording_(language, mentions(tokens)),
        says_if_(says(tokens, "if")),
        says_otherwise_(says(tokens, "otherwise")),
        units_(gold.actions.size() + 1),
        directed_(language.vocabulary().size(), false) {
    poses_.push_back(gold.start);
    for (const plan::Action action : gold.actions) poses_.push_back(*executor.map().successor(poses_.back(), action));
    find_literals(language, mentions(tokens));
    for (const std::uint16_t p : literals_) add_steps_of(p);
    for (int k = 1; k <= 4; ++k) steps_.push_back({StepKind::Forward, static_cast<std::uint8_t>(k), 0, {}});
  }

  std::vector<Consistent> run(std::size_t most) {
    for (std::size_t units = 1; units <= most_units; ++units) {  // short programs first
      prefixes_ = 0;
      extend({}, 0, units);
    }
    std::stable_sort(found_.begin(), found_.end(), [](const Said& a, const Said& b) {
      return a.lexical_overlap_penalty < b.lexical_overlap_penalty;
    });
    std::vector<Consistent> out;
    for (Said& said : found_) {
      if (out.size() == most || said.lexical_overlap_penalty > found_.front().lexical_overlap_penalty + slack) break;
      const auto plan = executor_.run(said.program, gold_.start);
      if (plan && plan->end == gold_.end) out.push_back({std::move(said.program), plan->actions == gold_.actions});
    }
    return out;
  }

 private:
  static constexpr double slack = 1.5;
  static constexpr std::size_t most_units = 5, most_prefixes = 20'000;

  static bool says(const std::vector<std::string>& tokens, const char* word) {
    return std::find(tokens.begin(), tokens.end(), word) != tokens.end();
  }

  void find_literals(const ProgramLanguage& language, const std::vector<Part>& said) {
    const Columns& columns = language.columns();
    const auto number = static_cast<std::uint16_t>(language.observables().size());
    for (std::uint16_t p = 0; p < number; ++p) {
      const auto& [direction, kind, name] = language.observables()[p];
      const bool mentioned =
          std::binary_search(said.begin(), said.end(), columns.part(columns.thing[PostfixGrammar::literal(p)]));
      const bool is_said =
          kind != plan::Kind::PlaceNumber && direction != Direction::Behind && direction != Direction::Next;
      if (!grammar_.usable(p) || !is_said) continue;
      const bool wall_ahead = direction == Direction::Ahead && kind == plan::Kind::Passage && name == "wall";
      if (!mentioned && !wall_ahead) continue;
      literals_.push_back(p);
      directed_[p] = direction != Direction::Here && !grammar_.is_turn(p);
      if (grammar_.is_turn(p)) continue;
      const bool around = direction == Direction::Left || direction == Direction::Right;
      if (mentioned && (around || direction == Direction::Ahead)) conditions_.push_back(p);
      if (mentioned && (around || direction == Direction::Here)) guards_.push_back(p);
    }
  }

  void add_steps_of(std::uint16_t p) {
    const auto add = [&](StepKind kind, std::uint8_t count = 0) { steps_.push_back({kind, count, 1, {p}}); };
    if (grammar_.is_turn(p)) {
      add(StepKind::Next);
      return;
    }
    for (const StepKind kind : {StepKind::Reach, StepKind::Advance, StepKind::Face, StepKind::Past}) add(kind);
    for (std::uint8_t k = 2; k <= PostfixGrammar::max_advance; ++k) add(StepKind::Advance, k);
  }

  const std::optional<Plan>& plan_of(std::size_t at, const Program& unit) {
    const auto [it, is_new] = plans_.try_emplace({poses_[at], unit});
    if (is_new) it->second = executor_.run(unit, poses_[at]);
    return it->second;
  }

  // Where the gold route is after this unit, when it goes that way. One may be where one has to go to, and be done at
  // once.
  std::optional<std::size_t> done_by(std::size_t at, const Program& unit) {
    const auto& plan = plan_of(at, unit);
    const std::size_t left = gold_.actions.size() - at;
    if (!plan || plan->actions.size() > left) return std::nullopt;
    const auto from = gold_.actions.begin() + static_cast<std::ptrdiff_t>(at);
    if (!std::equal(plan->actions.begin(), plan->actions.end(), from)) return std::nullopt;
    return at + plan->actions.size();
  }

  const std::vector<Unit>& units_from(std::size_t at) {
    if (units_[at]) return *units_[at];
    std::vector<Unit> units;
    for (const Step& step : steps_)
      if (const auto end = done_by(at, {step})) units.push_back({{step}, *end});
    const std::size_t plain = units.size();
    if (says_if_) add_conditions(at, plain, units);
    add_guarded(at, units);
    return units_[at].emplace(std::move(units));
  }

  void add_guarded(std::size_t at, std::vector<Unit>& units) {
    for (const Step& step : steps_) {
      if (step.kind != StepKind::Reach) continue;
      for (const std::uint16_t guard : guards_) {
        if (guard == step.goal[0]) continue;
        for (const StepKind kind : {StepKind::Without, StepKind::Keep}) {
          const Program unit{{kind, 0, 1, {guard}}, step};
          const auto end = done_by(at, unit);
          if (end && plan_of(at, {step})->actions != plan_of(at, unit)->actions) units.push_back({unit, *end});
        }
      }
    }
  }

  void add_conditions(std::size_t at, std::size_t plain, std::vector<Unit>& units) {
    for (const std::uint16_t p : conditions_) {
      const bool holds = executor_.holds(p, Arrival::start(poses_[at]));
      const Step condition{says_otherwise_ ? StepKind::Whether : StepKind::When, 0, 1, {p}};
      if (!says_otherwise_ && !holds) {  // nothing happens
        for (const Step& step : steps_) units.push_back({{condition, step}, at});
        continue;
      }
      for (std::size_t u = 0; u < plain; ++u) {
        const Step done = units[u].program.front();
        const std::size_t end = units[u].end;
        if (!says_otherwise_) units.push_back({{condition, done}, end});
        if (!says_otherwise_) continue;
        for (const Step& other : steps_)
          units.push_back({holds ? Program{condition, done, other} : Program{condition, other, done}, end});
      }
    }
  }

  // "The chair" is where one stands sooner than what one sees: enough to decide between programs that say the same.
  double directions_of(const Program& program) const {
    double sum = 0;
    for (const Step& step : program)
      for (const std::uint16_t p : step.literals()) sum += directed_[p] ? 0.05 : 0;
    return sum;
  }

  // By so many units more.
  void extend(const Program& program, std::size_t at, std::size_t units) {
    if (units == 0) {
      if (at == gold_.actions.size() && grammar_.contains(program))
        found_.push_back({program, wording_.lexical_overlap_penalty(program) + directions_of(program)});
      return;
    }
    for (const Unit& unit : units_from(at)) {
      if (++prefixes_ > most_prefixes) return;
      Program longer = program;
      longer.insert(longer.end(), unit.program.begin(), unit.program.end());
      extend(longer, unit.end, units - 1);
    }
  }

  const Executor& executor_;
  const PostfixGrammar& grammar_;
  const GoldRoute& gold_;
  UnitPlans& plans_;
  Wording wording_;
  bool says_if_, says_otherwise_;
  std::vector<plan::PoseId> poses_;
  std::vector<std::uint16_t> literals_, guards_, conditions_;
  std::vector<Step> steps_;
  std::vector<std::optional<std::vector<Unit>>> units_;  // by position on the gold route
  std::vector<bool> directed_;                           // by proposition: seen in a direction
  std::vector<Said> found_;
  std::size_t prefixes_ = 0;
};

}  // namespace

std::vector<Consistent> said_programs(const Executor& executor, const ProgramLanguage& language, const GoldRoute& gold,
                                      const std::vector<std::string>& tokens, UnitPlans& plans, std::size_t most) {
  return SaidSearch(executor, language, gold, tokens, plans).run(most);
}

}  // namespace waymark::parser

#include "libparser/supervision/judged_search.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <optional>

#include "libparser/lexicon/lexicon.hpp"
#include "libparser/supervision/lexical_overlap.hpp"
#include "libparser/supervision/route_positions.hpp"

namespace waymark::parser {
namespace {

using plan::Direction;

struct Ranked {
  Program program;
  double penalty;
};

// The words of a sentence that name things, one after the other.
struct Named {
  std::map<std::string, int> words;
  std::map<std::string, std::vector<std::size_t>> at;  // by thing

  // Does one of the second stand at most so many words after one of the first?
  static bool follows(const std::vector<std::size_t>& first, const std::vector<std::size_t>& second, std::size_t most) {
    return std::any_of(first.begin(), first.end(), [&](std::size_t i) {
      return std::any_of(second.begin(), second.end(), [&](std::size_t j) { return j >= i && j <= i + most; });
    });
  }
};

std::vector<std::size_t> places_of(const std::vector<std::string>& tokens, std::initializer_list<const char*> words) {
  std::vector<std::size_t> out;
  for (std::size_t i = 0; i < tokens.size(); ++i)
    if (std::find(words.begin(), words.end(), tokens[i]) != words.end()) out.push_back(i);
  return out;
}

Named named_in(const std::vector<std::string>& tokens) {
  Named out;
  for (const Part& part : mentions(tokens))
    if (part.kind == PartKind::Thing) out.words[part.name] = 0;
  for (std::size_t i = 0; i < tokens.size(); ++i)
    for (const Part& part : mentions({tokens[i]}))
      if (part.kind == PartKind::Thing) {
        ++out.words[part.name];
        out.at[part.name].push_back(i);
      }
  for (auto& [name, count] : out.words) count = std::max(count, 1);  // of two words
  return out;
}

class JudgedSearch {
 public:
  JudgedSearch(const Executor& executor, const ProgramLanguage& language, const GoldRoute& gold,
               const std::vector<std::string>& tokens, const Judged& judged)
      : executor_(executor),
        language_(language),
        gold_(gold),
        judged_(judged),
        named_(named_in(tokens)),
        wording_(language, mentions(tokens)),
        positions_(executor, gold),
        ifs_(places_of(tokens, {"if"})),
        otherwise_(!places_of(tokens, {"otherwise"}).empty()),
        ends_(!places_of(tokens, {"end", "ends"}).empty()),
        goals_left_(named_.words),
        others_left_(named_.words) {
    ordinal_ = {0, 0, !places_of(tokens, {"second"}).empty(), !places_of(tokens, {"third"}).empty()};
    for (std::uint16_t p = 0; p < language.observables().size(); ++p) add_literal(p);
    for (int k = 1; k <= PostfixGrammar::max_forward; ++k)
      if (k == 1 || named_.words.count(std::to_string(k)) > 0)
        steps_.push_back({StepKind::Forward, static_cast<std::uint8_t>(k), 0, {}});
    conditions_left_ = ifs_.size();
  }

  std::vector<Consistent> run(std::size_t most) {
    for (std::size_t units = 1; units <= most_units; ++units) {  // short programs first
      prefixes_ = 0;
      extend(positions_.first(), units);
    }
    std::stable_sort(found_.begin(), found_.end(),
                     [](const Ranked& a, const Ranked& b) { return a.penalty < b.penalty; });
    std::vector<Consistent> out;
    double least = 0;
    for (Ranked& said : found_) {
      if (out.size() == most || (!out.empty() && said.penalty > least + slack)) break;
      if (!agrees(executor_, said.program, judged_)) continue;
      const auto plan = executor_.run(said.program, gold_.start);
      if (!plan || plan->end != gold_.end) continue;
      if (out.empty()) least = said.penalty;
      out.push_back({std::move(said.program), plan->actions == gold_.actions});
    }
    return out;
  }

 private:
  static constexpr double slack = 0.3, unused = 1.0, per_direction = 0.05, per_step = 0.1, per_inversion = 0.1;
  static constexpr std::size_t nearby = 6;  // words
  static constexpr std::size_t most_units = 6, most_prefixes = 30'000;

  const plan::Observable& observable(std::uint16_t p) const { return language_.observables()[p]; }
  bool is_wall_ahead(std::uint16_t p) const {
    return observable(p).direction == Direction::Ahead && observable(p).name == "wall";
  }

  // Not counted: a turn is a side, and the end of a hall is a wall that few sentences name.
  bool is_free(std::uint16_t p) const { return language_.grammar().is_turn(p) || is_wall_ahead(p); }

  void add_literal(std::uint16_t p) {
    const auto& [where, kind, name] = observable(p);
    const PostfixGrammar& grammar = language_.grammar();
    if (!grammar.usable(p) || kind == plan::Kind::PlaceNumber) return;
    const auto add = [&](StepKind step, std::uint8_t count = 0) { steps_.push_back({step, count, 1, {p}}); };
    if (grammar.is_turn(p)) {
      if (named_.words.count(*side_of(p)) > 0) add(StepKind::Next);
      return;
    }
    const bool mentioned = named_.words.count(name) > 0, wall_ahead = is_wall_ahead(p);
    if (where == Direction::Behind || where == Direction::Next || (!mentioned && !wall_ahead)) return;
    if (side_of(p) && !Named::follows(named_.at[name], named_.at[*side_of(p)], nearby)) return;
    if (where != Direction::Ahead) guards_.push_back(p);
    if (where != Direction::Here && Named::follows(ifs_, named_.at[name], nearby)) conditions_.push_back(p);
    add(StepKind::Reach);
    add(StepKind::Advance);
    if (where != Direction::Here) add(StepKind::Face);
    if (where != Direction::Here) return;
    add(StepKind::Past);
    for (std::uint8_t k = 2; k <= PostfixGrammar::max_advance; ++k)
      if (ordinal_[k]) add(StepKind::Advance, k);
  }

  std::optional<std::string> side_of(std::uint16_t p) const {
    if (observable(p).direction == Direction::Left) return "left";
    if (observable(p).direction == Direction::Right) return "right";
    return std::nullopt;
  }

  // What the budget counts a step for: its thing, or its number.
  std::string word_of(const Step& step) const {
    if (step.kind == StepKind::Forward) return std::to_string(step.count);
    return is_free(step.goal[0]) ? "" : observable(step.goal[0]).name;
  }

  // A step is put at the end and taken away again; false when the sentence has no words for it.
  bool push(const Step& step, bool goal) {
    std::map<std::string, int>& left = goal ? goals_left_ : others_left_;
    const auto word = left.find(word_of(step));
    if (word != left.end() && word->second == 0) return false;
    const auto side = step.goals > 0 ? side_of(step.goal[0]) : std::nullopt;
    if (side && sides_used_[*side] == named_.words[*side]) return false;
    if (side) ++sides_used_[*side];
    if (word != left.end()) --word->second;
    program_.push_back(step);
    return true;
  }

  void pop(bool goal) {
    const Step& step = program_.back();
    std::map<std::string, int>& left = goal ? goals_left_ : others_left_;
    if (const auto side = step.goals > 0 ? side_of(step.goal[0]) : std::nullopt) --sides_used_[*side];
    if (const auto word = left.find(word_of(step)); word != left.end()) ++word->second;
    program_.pop_back();
  }

  // Done at these positions; by so many units more.
  void extend(Positions at, std::size_t units) {
    if (at == 0 || ++prefixes_ > most_prefixes) return;
    if (units == 0) {
      if (positions_.ends(at) && language_.grammar().contains(program_)) found_.push_back({program_, penalty()});
      return;
    }
    for (const Step& step : steps_) extend_by(step, at, units - 1);
    for (const std::uint16_t guard : guards_)
      for (const StepKind kind : {StepKind::Without, StepKind::Keep}) extend_guarded({kind, 0, 1, {guard}}, at, units);
    for (const std::uint16_t p : conditions_)
      if (conditions_left_ > 0) extend_asking(p, at, units);
  }

  void extend_by(const Step& step, Positions at, std::size_t units) {
    const Positions then = positions_.after(at, step);
    if (then == 0 || !push(step, true)) return;
    extend(then, units);
    pop(true);
  }

  void extend_guarded(const Step& guard, Positions at, std::size_t units) {
    if (!push(guard, false)) return;
    for (const Step& step : steps_)
      if (step.kind == StepKind::Reach && step.goal != guard.goal) {
        const Positions then = positions_.after(at, step, &guard);
        if (then == 0 || !push(step, true)) continue;
        extend(then, units - 1);
        pop(true);
      }
    pop(false);
  }

  void extend_asking(std::uint16_t p, Positions at, std::size_t units) {
    const Step condition{otherwise_ ? StepKind::Whether : StepKind::When, 0, 1, {p}};
    if (!push(condition, false)) return;
    --conditions_left_;
    const Positions yes = positions_.where(at, p), no = at & ~yes;
    for (const Step& step : steps_) {
      const Positions done = positions_.after(yes, step);
      if ((done | no) == 0 || !push(step, true)) continue;
      if (!otherwise_) extend(done | no, units - 1);
      if (otherwise_)
        for (const Step& other : steps_) {
          const Positions both = done | positions_.after(no, other);
          if (both == 0 || !push(other, true)) continue;
          extend(both, units - 1);
          pop(true);
        }
      pop(true);
    }
    ++conditions_left_;
    pop(false);
  }

  // Enough to decide between programs that say the same: things in another order than the sentence, directions, steps.
  double penalty() const {
    double sum = wording_.lexical_overlap_penalty(program_) + per_step * static_cast<double>(program_.size());
    for (const auto& [name, count] : named_.words) {
      const int used = 2 * count - goals_left_.at(name) - others_left_.at(name);
      if (used > 0) sum += unused * std::max(0, count - used);
    }
    std::size_t last = 0;
    bool wall_ahead = false;
    for (const Step& one : program_)
      for (const std::uint16_t p : one.literals()) {
        if (observable(p).direction != Direction::Here && !language_.grammar().is_turn(p)) sum += per_direction;
        wall_ahead = wall_ahead || is_wall_ahead(p);
        const auto place = named_.at.find(observable(p).name);
        if (place == named_.at.end() || place->second.empty()) continue;
        if (place->second.back() < last) sum += per_inversion;
        last = place->second.front();
      }
    if (wall_ahead && ends_ && named_.words.count("wall") == 0) sum -= Wording::added;
    return sum;
  }

  const Executor& executor_;
  const ProgramLanguage& language_;
  const GoldRoute& gold_;
  const Judged& judged_;
  Named named_;
  Wording wording_;
  RoutePositions positions_;
  std::vector<std::size_t> ifs_;
  bool otherwise_, ends_;
  std::array<bool, PostfixGrammar::max_advance + 1> ordinal_{};
  std::map<std::string, int> goals_left_, others_left_, sides_used_;
  std::size_t conditions_left_ = 0;
  std::vector<std::uint16_t> guards_, conditions_;
  std::vector<Step> steps_;
  Program program_;
  std::vector<Ranked> found_;
  std::size_t prefixes_ = 0;
};

}  // namespace

std::vector<Consistent> judged_programs(const Executor& executor, const ProgramLanguage& language,
                                        const GoldRoute& gold, const std::vector<std::string>& tokens,
                                        const Judged& judged, std::size_t most) {
  if (gold.actions.size() >= RoutePositions::most) return {};
  return JudgedSearch(executor, language, gold, tokens, judged).run(most);
}

}  // namespace waymark::parser

#include "libparser/language/generate.hpp"

#include <stdexcept>

#include "libltl/meaning/semantics.hpp"
#include "libltl/text/print.hpp"
#include "libparser/corpus/corpus_file.hpp"
#include "libparser/corpus/token.hpp"
#include "libparser/programs/execute.hpp"
#include "libplan/world/trajectory.hpp"

namespace waymark::parser {
namespace {

// Without what has to be avoided or kept.
Program unguarded(const Program& program) {
  Program out;
  for (const Step& step : program)
    if (step.kind != StepKind::Without && step.kind != StepKind::Keep) out.push_back(step);
  return out;
}

class Generator {
 public:
  Generator(std::span<const plan::Map> maps, const GenerateOptions& options)
      : options_(options),
        executors_(maps.begin(), maps.end()),
        grammar_(maps.front().vocabulary(), options.dialect),
        language_(maps.front().vocabulary(), options.dialect),
        speaker_(maps.front(), options.dialect, options.seed) {}

  Paragraph paragraph(std::size_t number) {
    const Executor& executor = executors_[number % executors_.size()];
    const plan::Map& map = executor.map();
    Paragraph out{"generated_" + std::to_string(number + 1), map.name(), "", {}};
    plan::PoseId here{static_cast<std::uint32_t>(speaker_.below(map.poses()))};
    ltl::Arena arena(map.vocabulary());
    for (int tries = 0; out.sentences.size() < options_.sentences && tries < 3000; ++tries) {
      const std::size_t clauses =
          options_.least_clauses + speaker_.below(options_.most_clauses - options_.least_clauses + 1);
      const Saying saying = speaker_.say(clauses);
      if (saying.clauses != clauses || !grammar_.contains(saying.program)) continue;
      const ltl::Formula formula = formula_of(saying.program, arena);
      if (!wanted(ltl::print(formula))) continue;
      const auto plan = executor.run(saying.program, here);
      if (!plan || !is_worth_saying(saying, *plan, executor, here)) continue;
      out.sentences.push_back(sentence(saying, *plan, formula, map, here));
      if (options_.judged.refused + options_.judged.also_good > 0)
        add_judged(out.sentences.back(), saying.program, {here, plan->end, plan->actions}, number, formula);
      out.sentences.back().id = std::to_string(number + 1) + "-" + std::to_string(out.sentences.size());
      out.text += (out.text.empty() ? "" : " ") + saying.text + ".";
      here = plan->end;
    }
    return out;
  }

 private:
  bool wanted(const std::string& formula) const {
    if (options_.formulas == Formulas::All) return true;
    return (fnv1a(formula) % 5 == 0) == (options_.formulas == Formulas::HeldOut);
  }

  // Not too far, and three times in four what is to be avoided or kept makes a difference.
  bool is_worth_saying(const Saying& saying, const Plan& plan, const Executor& executor, plan::PoseId from) {
    const std::size_t longest = 4 + 6 * saying.clauses;
    if (plan.actions.empty() || plan.actions.size() > longest) return false;
    const Program free = unguarded(saying.program);
    if (free == saying.program || speaker_.below(4) == 0) return true;
    const auto other = executor.run(free, from);
    return other && other->actions != plan.actions;
  }

  void add_judged(Sentence& sentence, const Program& meant, const GoldRoute& gold, std::size_t number,
                  ltl::Formula formula) {
    const std::size_t m = number % executors_.size();
    const plan::Map& map = executors_[m].map();
    const Judged judged = judged_trajectories(executors_[m], language_, gold, meant, sentence.tokens, options_.judged);
    const auto add = [&](const std::vector<plan::Trajectory>& walks, std::vector<std::vector<plan::Pose>>& paths,
                         bool good) {
      for (const plan::Trajectory& walk : walks) {
        if (ltl::holds(plan::word_of(walk, map), formula) != good)
          throw std::logic_error("a trajectory that is judged otherwise than by its formula");
        paths.push_back(poses_of(walk, map));
      }
    };
    add(judged.good, sentence.also_good, true);
    add(judged.refused, sentence.refused, false);
  }

  static std::vector<plan::Pose> poses_of(const plan::Trajectory& walk, const plan::Map& map) {
    std::vector<plan::Pose> out;
    for (const plan::PoseId pose : walk.poses) out.push_back(map.pose(pose));
    return out;
  }

  static Sentence sentence(const Saying& saying, const Plan& plan, ltl::Formula formula, const plan::Map& map,
                           plan::PoseId from) {
    const auto walked = plan::follow(map, from, plan.actions);
    if (!walked || !ltl::holds(plan::word_of(*walked, map), formula))
      throw std::logic_error("a plan that does not satisfy its formula");
    Sentence out;
    out.text = saying.text;
    out.tokens = tokenize(saying.text);
    out.absolute = poses_of(*walked, map);
    out.relative = out.absolute;
    out.formula = ltl::print(formula);
    return out;
  }

  const GenerateOptions& options_;
  std::vector<Executor> executors_;
  PostfixGrammar grammar_;
  ProgramLanguage language_;
  Speaker speaker_;
};

}  // namespace

Corpus generate_corpus(std::span<const plan::Map> maps, const GenerateOptions& options) {
  if (maps.empty()) throw std::invalid_argument("generating a corpus needs maps");
  for (const plan::Map& map : maps)
    if (!(map.vocabulary() == maps.front().vocabulary()))
      throw std::invalid_argument("maps " + maps.front().name() + " and " + map.name() +
                                  " have different vocabularies");
  if (options.least_clauses < 1 || options.least_clauses > options.most_clauses)
    throw std::invalid_argument("a sentence of no clause");
  Corpus corpus;
  corpus.maps.assign(maps.begin(), maps.end());
  Generator generator(maps, options);
  for (std::size_t i = 0; i < options.paragraphs; ++i) {
    Paragraph paragraph = generator.paragraph(i);
    if (!paragraph.sentences.empty()) corpus.paragraphs.push_back(std::move(paragraph));
  }
  return corpus;
}

}  // namespace waymark::parser

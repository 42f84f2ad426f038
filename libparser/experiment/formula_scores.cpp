#include "libparser/experiment/formula_scores.hpp"

#include <set>
#include <unordered_map>

#include "libautomata/finite/ltlf_to_dfa.hpp"
#include "libautomata/finite/product.hpp"
#include "libltl/text/parse.hpp"
#include "libparser/programs/recognise.hpp"

namespace waymark::parser {
namespace {

std::size_t units(const Program& program) {
  std::size_t n = 0;
  for (std::size_t i = 0; i < program.size(); i = unit_end(program, i)) ++n;
  return n;
}

std::set<std::string> constructs_of(const Program& program) {
  std::set<std::string> out;
  for (const Step& step : program) {
    if (step.kind == StepKind::Without) out.insert("avoidance");
    if (step.kind == StepKind::Keep || step.kind == StepKind::Advance) out.insert("until");
    if (step.kind == StepKind::When || step.kind == StepKind::Whether) out.insert("conditional");
    if (step.count > 1) out.insert("counting");
  }
  if (units(program) > 1) out.insert("sequencing");
  return out.empty() ? std::set<std::string>{"single"} : out;
}

}  // namespace

struct FormulaJudge::Automata {
  explicit Automata(const ltl::Vocabulary& vocabulary) : arena(vocabulary) {}
  ltl::Arena arena;
  std::unordered_map<ltl::Formula, automata::Dfa> made;

  const automata::Dfa& of(ltl::Formula f) {
    const auto known = made.find(f);
    return known != made.end() ? known->second : made.emplace(f, automata::ltlf_to_dfa(f)).first->second;
  }
};

FormulaJudge::FormulaJudge(const ltl::Vocabulary& vocabulary, Dialect dialect)
    : grammar_(vocabulary, dialect), automata_(std::make_unique<Automata>(vocabulary)) {}
FormulaJudge::~FormulaJudge() = default;

bool FormulaJudge::equivalent(ltl::Formula a, ltl::Formula b) {
  if (a == b) return true;
  const automata::Dfa& first = automata_->of(a);
  return !automata::difference(first, automata_->of(b));
}

void FormulaJudge::judge(std::string_view gold_text, const Program& read) {
  ltl::Arena& arena = automata_->arena;
  const ltl::Formula gold = ltl::parse(gold_text, arena, {.unknown = ltl::Unknown::Reject});
  FormulaShare share{{0, 1}, {0, 1}};
  if (!read.empty()) {
    const ltl::Formula own = formula_of(read, arena);
    share.same.hits = own == gold ? 1 : 0;
    share.equivalent.hits = equivalent(gold, own) ? 1 : 0;
  }
  const auto add = [&](FormulaShare& sum) {
    sum.same += share.same;
    sum.equivalent += share.equivalent;
  };
  add(scores_.all);
  const auto program = program_of(gold, grammar_);
  if (!program) {
    add(scores_.by_construct["no program"]);
    return;
  }
  for (const std::string& construct : constructs_of(*program)) add(scores_.by_construct[construct]);
  add(scores_.by_length[units(*program)]);
}

FormulaScores formula_scores(const std::vector<Prediction>& predictions, const Corpus& corpus,
                             std::span<const plan::Map> maps, bool absolute) {
  std::map<std::pair<std::string, std::string>, const std::string*> gold;
  for (const Paragraph& paragraph : corpus.paragraphs)
    for (const Sentence& sentence : paragraph.sentences)
      if (!sentence.formula.empty()) gold[{paragraph.map, sentence.id}] = &sentence.formula;
  if (gold.empty()) return {};
  FormulaJudge judge(maps.front().vocabulary(), Dialect::Temporal);
  for (const Prediction& prediction : predictions) {
    if (prediction.paragraph) continue;
    if ((prediction.convention == Convention::Absolute) != absolute) continue;
    const auto formula = gold.find({prediction.map, prediction.id});
    if (formula != gold.end()) judge.judge(*formula->second, prediction.answer.program);
  }
  return judge.scores();
}

}  // namespace waymark::parser

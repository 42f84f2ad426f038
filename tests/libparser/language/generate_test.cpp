#include "libparser/language/generate.hpp"

#include <gtest/gtest.h>

#include <set>

#include "libltl/meaning/semantics.hpp"
#include "libltl/text/parse.hpp"
#include "libparser/corpus/corpus_output.hpp"
#include "libparser/corpus/sail_corpus.hpp"
#include "libparser/experiment/formula_scores.hpp"
#include "libparser/programs/recognise.hpp"
#include "libparser/supervision/examples.hpp"
#include "libplan/world/trajectory.hpp"
#include "tests/libparser/maps.hpp"

namespace waymark::parser {
namespace {

Corpus temporal(std::uint64_t seed, Formulas formulas = Formulas::All, std::size_t least = 1, std::size_t most = 3) {
  return generate_corpus(shipped_maps(), {.seed = seed,
                                          .paragraphs = 60,
                                          .sentences = 4,
                                          .dialect = Dialect::Temporal,
                                          .least_clauses = least,
                                          .most_clauses = most,
                                          .formulas = formulas});
}

std::set<std::string> formulas_of(const Corpus& corpus) {
  std::set<std::string> out;
  for (const Paragraph& paragraph : corpus.paragraphs)
    for (const Sentence& sentence : paragraph.sentences) out.insert(sentence.formula);
  return out;
}

// visit(paragraph, sentence)
template <class Visit>
void each_sentence(const Corpus& corpus, const Visit& visit) {
  for (const Paragraph& paragraph : corpus.paragraphs)
    for (const Sentence& sentence : paragraph.sentences) visit(paragraph, sentence);
}

plan::Trajectory trajectory_of(const std::vector<plan::Pose>& path, const plan::Map& map) {
  plan::Trajectory out;
  for (const plan::Pose& pose : path) {
    out.poses.push_back(map.find(pose).value());
    if (out.poses.size() > 1)
      out.actions.push_back(plan::action_between(map, out.poses[out.poses.size() - 2], out.poses.back()).value());
  }
  return out;
}

TEST(Generate, JudgedTrajectoriesAreJudgedByTheFormula) {
  const Corpus corpus = generate_corpus(
      shipped_maps(),
      {.seed = 4, .paragraphs = 9, .dialect = Dialect::Temporal, .judged = {.refused = 3, .also_good = 2}});
  std::size_t good = 0, refused = 0;
  each_sentence(corpus, [&](const Paragraph& paragraph, const Sentence& sentence) {
    const auto map = std::find_if(shipped_maps().begin(), shipped_maps().end(),
                                  [&](const plan::Map& one) { return one.name() == paragraph.map; });
    ltl::Arena arena(map->vocabulary());
    const ltl::Formula formula = ltl::parse(sentence.formula, arena);
    const auto is_allowed = [&](const std::vector<plan::Pose>& path) {
      return ltl::holds(plan::word_of(trajectory_of(path, *map), *map), formula);
    };
    for (const auto& path : sentence.also_good) EXPECT_TRUE(is_allowed(path)) << sentence.text;
    for (const auto& path : sentence.refused) EXPECT_FALSE(is_allowed(path)) << sentence.text;
    good += sentence.also_good.size();
    refused += sentence.refused.size();
  });
  EXPECT_EQ(good, 72U);
  EXPECT_GE(refused, 100U);
  EXPECT_LE(refused, 108U);
}

TEST(Generate, JudgedTrajectoriesAreWrittenAndReadAgain) {
  const Corpus corpus =
      generate_corpus(shipped_maps(), {.seed = 5, .paragraphs = 3, .judged = {.refused = 2, .also_good = 1}});
  const std::string lines = json_lines(corpus);
  const std::vector<Paragraph> again = parse_sail_corpus(lines);
  EXPECT_EQ(json_lines({again, {}}), lines);
  EXPECT_EQ(again[1].sentences[0].refused, corpus.paragraphs[1].sentences[0].refused);
  EXPECT_THROW(parse_sail_corpus(lines.substr(0, lines.find("\"refused\"")) + R"("refused":[[[0,0,7]]]}]})"),
               ltl::FormatError);
}

TEST(Generate, EveryTrajectorySatisfiesItsFormulaByDefinition) {
  for (const Dialect dialect : {Dialect::Plain, Dialect::Temporal}) {
    const Corpus corpus = generate_corpus(shipped_maps(), {.seed = 4, .paragraphs = 12, .dialect = dialect});
    const std::vector<Executor> executors(shipped_maps().begin(), shipped_maps().end());
    const Examples examples = make_examples(corpus, executors, Convention::Absolute);
    std::size_t i = 0;
    each_sentence(corpus, [&](const Paragraph&, const Sentence& sentence) {
      const Example& example = examples.sentences.at(i++);
      const plan::Map& map = executors[example.map].map();
      ltl::Arena arena(map.vocabulary());
      const auto walked = plan::follow(map, example.gold.start, example.gold.actions);
      ASSERT_TRUE(walked.has_value());
      EXPECT_TRUE(ltl::holds(plan::word_of(*walked, map), ltl::parse(sentence.formula, arena)))
          << sentence.text << "  =  " << sentence.formula;
    });
    EXPECT_EQ(i, 48U);
  }
}

TEST(Generate, SaysEverythingThatTheTemporalDialectHas) {
  const PostfixGrammar grammar(shipped_maps().front().vocabulary(), Dialect::Temporal);
  std::set<StepKind> kinds;
  bool counts = false;
  for (const std::string& formula : formulas_of(temporal(1))) {
    ltl::Arena arena(shipped_maps().front().vocabulary());
    const auto program = program_of(ltl::parse(formula, arena), grammar);
    ASSERT_TRUE(program.has_value()) << formula;
    for (const Step& step : *program) {
      kinds.insert(step.kind);
      counts = counts || (step.kind == StepKind::Advance && step.count > 1);
    }
  }
  EXPECT_TRUE(counts);
  EXPECT_EQ(kinds.size(), 10U);  // all but stay and orient
}

TEST(Generate, SplitsShareNoFormulaAndLengthsAreKept) {
  const auto known = formulas_of(temporal(1, Formulas::Known)), held_out = formulas_of(temporal(2, Formulas::HeldOut));
  EXPECT_GT(held_out.size(), 50U);
  for (const std::string& formula : held_out) EXPECT_EQ(known.count(formula), 0U) << formula;
  each_sentence(temporal(3, Formulas::All, 5, 5), [](const Paragraph&, const Sentence& sentence) {
    std::size_t joints = 0;  // five clauses are joined four times
    for (const std::string& word : sentence.tokens) joints += word == "and" || word == "," || word == "then" ? 1 : 0;
    EXPECT_GE(joints, 4U) << sentence.text;
  });
}

TEST(Generate, SeedsDecideAndLinesReadBack) {
  const std::string lines = json_lines(temporal(1));
  EXPECT_EQ(lines, json_lines(temporal(1)));
  EXPECT_NE(lines, json_lines(temporal(2)));
  Corpus read{parse_sail_corpus(lines), {}, 0};
  EXPECT_EQ(json_lines(read), lines);
  EXPECT_EQ(pairs_text(read), pairs_text(temporal(1)));
}

TEST(Generate, OptionsThatDoNotFitAreRefused) {
  EXPECT_THROW(generate_corpus({}, {}), std::invalid_argument);
  EXPECT_THROW(generate_corpus(shipped_maps(), {.least_clauses = 3, .most_clauses = 2}), std::invalid_argument);
}

TEST(FormulaJudge, TellsSameFromEquivalentFromWrong) {
  const ltl::Vocabulary& vocabulary = shipped_maps().front().vocabulary();
  FormulaJudge judge(vocabulary, Dialect::Temporal);
  const auto literal = [&](const char* name) {
    return static_cast<std::uint16_t>(vocabulary.find(name).value().index);
  };
  const Step chair{StepKind::Reach, 0, 1, {literal("chair")}}, sofa{StepKind::Reach, 0, 1, {literal("sofa")}};
  judge.judge("F chair", {chair});
  judge.judge("F (chair & F chair)", {chair});
  judge.judge("F (chair & F sofa)", {sofa, chair});
  judge.judge("F (chair & F sofa)", {});
  EXPECT_EQ(judge.scores().all.same.hits, 1U);
  EXPECT_EQ(judge.scores().all.equivalent.hits, 2U);
  EXPECT_EQ(judge.scores().all.same.total, 4U);
  EXPECT_EQ(judge.scores().by_construct.at("sequencing").equivalent.total, 3U);
  EXPECT_EQ(judge.scores().by_construct.at("single").same.hits, 1U);
  EXPECT_EQ(judge.scores().by_length.at(2).equivalent.hits, 1U);
}

}  // namespace
}  // namespace waymark::parser

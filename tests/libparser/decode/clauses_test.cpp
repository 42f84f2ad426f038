#include "libparser/decode/clauses.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>

#include "libltl/structure/random.hpp"
#include "libparser/corpus/token.hpp"
#include "libparser/rerank/decide.hpp"
#include "tests/libparser/maps.hpp"

namespace waymark::parser {
namespace {

Step forward(int k) { return {StepKind::Forward, static_cast<std::uint8_t>(k), 0, {}}; }

std::string text_of(const SentenceInput& input) {
  std::string out = input.heading_unknown ? "? " : "";
  for (const std::string& word : input.tokens) out += word + ' ';
  return out;
}

// What it answers is said beforehand, or drawn when it is first asked; never more than it is asked for.
struct Told {
  std::vector<Candidate> read(const SentenceInput& input, std::size_t beam) const {
    const std::string text = text_of(input);
    asked.push_back(text);
    std::vector<Candidate> out;
    if (const auto known = answers.find(text); known != answers.end())
      out = known->second;
    else if (draw)
      out = answers[text] = draw();
    if (out.size() > beam) out.resize(beam);
    return out;
  }
  mutable std::map<std::string, std::vector<Candidate>> answers;
  mutable std::vector<std::string> asked;
  std::function<std::vector<Candidate>()> draw;
};

std::vector<Candidate> by_clauses(const Told& reader, const SentenceInput& input, std::size_t beam) {
  return read_by_clauses([&](const SentenceInput& one, std::size_t most) { return reader.read(one, most); }, input,
                         beam);
}

using Mass = std::map<Program, double>;

// By the definition: every way to cut into parts of at most four clauses, every reading of every part.
void cut(const Told& reader, const SentenceInput& input, const std::vector<Clause>& clauses, std::size_t from,
         const Program& program, double p, Mass& best) {
  if (from == clauses.size()) {
    if (!program.empty()) best[program] = std::max(best[program], p);
    return;
  }
  for (std::size_t to = from + 1; to <= std::min(from + 4, clauses.size()); ++to) {
    if (from == 0 && to == clauses.size()) continue;
    if (from > 0 && input.tokens[clauses[from].begin] == "otherwise") return;
    const auto token = [&](std::size_t i) { return input.tokens.begin() + static_cast<std::ptrdiff_t>(i); };
    const SentenceInput part{{token(clauses[from].begin), token(clauses[to - 1].end)},
                             input.heading_unknown && from == 0};
    for (const Candidate& c : reader.read(part, 100)) {
      Program longer = program;
      for (const Step& step : c.program)
        if (step.kind != StepKind::Stay) longer.push_back(step);
      cut(reader, input, clauses, to, longer, p * std::exp(c.log_probability), best);
    }
  }
}

Mass by_definition(const Told& reader, const SentenceInput& input) {
  Mass sum;
  cut(reader, input, clauses_of(input.tokens), 0, {}, 1, sum);
  for (auto& [program, p] : sum) p *= 0.5;
  for (const Candidate& c : reader.read(input, 100)) sum[c.program] += 0.5 * std::exp(c.log_probability);
  return sum;
}

TEST(Clauses, ProbabilitiesAreThoseOfTheDefinition) {
  const char* const sentences[] = {"a and b",
                                   "a , then b",
                                   "a and b , c",
                                   "a then b and c , d",
                                   "a ; b ; c ; d ; e",
                                   "a and b and c and d and e and f",
                                   "if a , b , otherwise c and d",
                                   "a , otherwise b , c",
                                   "otherwise a and b"};
  ltl::Random random(1);
  for (int round = 0; round < 200; ++round)
    for (const std::string text : sentences) {
      const SentenceInput input{tokenize(text), round % 2 == 1};
      const std::size_t clauses = clauses_of(input.tokens).size(), most = clauses <= 3 ? 2 : 1;
      Told reader;
      reader.draw = [&] {
        std::vector<Candidate> out;
        for (std::size_t k = random.below(most + 1); k < most; ++k) {
          Program program;
          for (std::size_t steps = random.below(3); steps > 0; --steps)
            program.push_back(random.below(5) == 0 ? Step{} : forward(static_cast<int>(1 + random.below(2))));
          if (std::none_of(out.begin(), out.end(), [&](const Candidate& c) { return c.program == program; }))
            out.push_back({program, std::log(0.05 + 0.9 * random.unit())});
        }
        std::sort(out.begin(), out.end(),
                  [](const Candidate& a, const Candidate& b) { return a.log_probability > b.log_probability; });
        return out;
      };
      const Mass want = by_definition(reader, input);
      const std::vector<Candidate> got = by_clauses(reader, input, 1000);
      ASSERT_EQ(got.size(), want.size()) << text;
      for (std::size_t i = 0; i < got.size(); ++i) {
        ASSERT_TRUE(want.contains(got[i].program)) << text;
        EXPECT_NEAR(std::exp(got[i].log_probability), want.at(got[i].program), 1e-9) << text;
        EXPECT_GE(got.front().log_probability, got[i].log_probability);
      }
    }
}

TEST(Clauses, OneClauseIsReadAsItIs) {
  Told reader;
  reader.answers["walk on "] = {{{forward(1)}, -0.5}, {{}, -1}};
  const auto read = by_clauses(reader, {{"walk", "on"}, false}, 5);
  EXPECT_EQ(reader.asked, std::vector<std::string>{"walk on "});
  ASSERT_EQ(read.size(), 2U);
  EXPECT_EQ(read[0].log_probability, -0.5);
  EXPECT_EQ(read[1].program, Program{});
}

TEST(Clauses, TheHeadingIsUnknownInTheFirstPartAlone) {
  Told reader;
  reader.draw = [] { return std::vector<Candidate>{{{forward(1)}, 0}}; };
  by_clauses(reader, {{"x", "and", "y", "and", "z"}, true}, 5);
  for (const std::string& text : reader.asked) EXPECT_EQ(text.find('?') == 0, text.find('x') <= 2) << text;
}

TEST(Clauses, AsManyAsAskedForAndNoneTooLong) {
  Told reader;
  reader.draw = [] {
    std::vector<Candidate> out;
    for (int k = 1; k <= 8; ++k) out.push_back({{forward(k)}, -0.5 * k});
    return out;
  };
  EXPECT_EQ(by_clauses(reader, {{"a", "and", "b"}, false}, 5).size(), 5U);
  EXPECT_EQ(by_clauses(reader, {{"a", "and", "b"}, false}, 40).size(), 40U) << "more than are kept of a part";
  reader.answers.clear();
  reader.draw = [] { return std::vector<Candidate>{{Program(50, forward(1)), -1}}; };
  for (const Candidate& c : by_clauses(reader, {tokenize("a and b and c and d"), false}, 5))
    EXPECT_LE(c.program.size(), 120U);
  SentenceInput endless;
  for (int i = 0; i < 500; ++i) endless.tokens.insert(endless.tokens.end(), {"a", "and"});
  reader.answers.clear();
  reader.draw = [] { return std::vector<Candidate>{{{forward(1)}, -0.1}}; };
  EXPECT_EQ(by_clauses(reader, endless, 5).size(), 1U);  // the reader's own
}

TEST(Clauses, TiesAreBrokenByWhatIsListedFirst) {
  const auto programs = [](const std::vector<Candidate>& candidates) {
    std::vector<Program> out;
    for (const Candidate& c : candidates) out.push_back(c.program);
    return out;
  };
  const Candidate one{{forward(1)}, -1}, two{{forward(2)}, -1}, three{{forward(3)}, -1}, four{{forward(4)}, -1};
  Told reader;
  reader.answers = {{"a and b ", {}}, {"a ", {one, two}}, {"b ", {three, four}}};
  const SentenceInput input{{"a", "and", "b"}, false};
  EXPECT_EQ(programs(by_clauses(reader, input, 2)),
            (std::vector<Program>{{forward(1), forward(3)}, {forward(1), forward(4)}}));
  const Candidate less{{forward(2)}, -2};
  reader.answers = {{"a and b ", {}}, {"a ", {one, less}}, {"b ", {three, four}}};
  EXPECT_EQ(programs(by_clauses(reader, input, 3)),
            (std::vector<Program>{{forward(1), forward(3)}, {forward(1), forward(4)}, {forward(2), forward(3)}}));
  reader.answers = {{"a and b ", {three, one, two}}, {"a ", {}}, {"b ", {}}};
  EXPECT_EQ(programs(by_clauses(reader, input, 5)), (std::vector<Program>{one.program, two.program, three.program}));
}

TEST(Clauses, AskedForOnlyWhenDeciding) {
  LinearModel model(shipped_maps().front().vocabulary());  // of every sentence: one step forward
  const auto all = sentence_features({{"walk"}, false}, model.words, model.language.steps()).by_context[0];
  for (std::size_t step = 0; step < all.size(); ++step) {
    const Token said = step == 0 ? PostfixGrammar::first_forward : PostfixGrammar::end;
    model.weights.row(model.weights.add(all[step].front()))[said] = 30;
  }
  const Grounder grounder = grounder_of(std::move(model));
  const SentenceInput input{tokenize("walk on and walk on"), false};
  const auto longest = [&](bool clauses) {
    std::size_t steps = 0;
    for (const Weighed& w : likely_programs(grounder, input, {.trust = 0, .clauses = clauses}))
      steps = std::max(steps, w.program.size());
    return steps;
  };
  EXPECT_EQ(longest(true), 2U);
  EXPECT_EQ(longest(false), 1U);
}

}  // namespace
}  // namespace waymark::parser

#include "libparser/generate.hpp"

#include <random>
#include <stdexcept>

#include "libparser/execute.hpp"
#include "libparser/token.hpp"

namespace waymark::parser {
namespace {

struct Saying {
  std::string text;
  Program program;
};

class Speaker {
 public:
  Speaker(const ltl::Vocabulary& vocabulary, std::uint64_t seed) : vocabulary_(vocabulary), random_(seed) {}

  Saying say() {
    if (below(3) > 0) return say_one();
    Saying first = say_one();
    const Saying second = say_one();
    first.text += one_of({" and ", ", then "}) + second.text;
    first.program.insert(first.program.end(), second.program.begin(), second.program.end());
    return first;
  }

  std::size_t below(std::size_t n) { return static_cast<std::size_t>(random_() % n); }

 private:
  std::string one_of(std::initializer_list<const char*> choices) {
    return *(choices.begin() + below(choices.size()));
  }

  Saying say_one() {
    switch (below(6)) {
      case 0: {
        const std::string side = one_of({"left", "right"});
        return {one_of({"turn ", "go ", "make a "}) + side, {step(StepKind::Next, "turned_" + side)}};
      }
      case 1: {
        const std::size_t k = 1 + below(4);
        const std::string count =
            std::vector<std::string>{"one step", "two steps", "three steps", "four steps"}[k - 1];
        return {one_of({"walk forward ", "move ", "go "}) + count,
                {{StepKind::Forward, static_cast<std::uint8_t>(k), 0, {}}}};
      }
      case 2: {
        const std::string object = one_of({"chair", "sofa", "easel", "lamp", "hatrack", "barstool"});
        return {one_of({"walk to the ", "go to the ", "move on to the "}) + object,
                {step(StepKind::Reach, object)}};
      }
      case 3:
        return {one_of({"go straight to the end of the hall", "follow the hall until it ends",
                        "walk on to the wall"}),
                {step(StepKind::Advance, "ahead_wall")}};
      case 4: {
        const std::string floor = one_of({"blue", "brick", "grass", "wood", "yellow"});
        return {one_of({"face the ", "turn until you look along the "}) + floor + " hall",
                {step(StepKind::Face, "ahead_" + floor)}};
      }
      default: {
        const std::string object = one_of({"chair", "sofa", "easel", "lamp"}),
                          side = one_of({"left", "right"});
        return {one_of({"walk until the ", "go on until you see the "}) + object + " on your " + side,
                {step(StepKind::Advance, side + "_" + object)}};
      }
    }
  }

  Step step(StepKind kind, const std::string& literal) const {
    const auto p = vocabulary_.find(literal);
    if (!p) throw std::invalid_argument("generated instructions need the proposition '" + literal + "'");
    return {kind, 0, 1, {static_cast<std::uint16_t>(p->index)}};
  }

  const ltl::Vocabulary& vocabulary_;
  std::mt19937_64 random_;
};

Sentence sentence_of(const Saying& saying, const Plan& plan, plan::PoseId start, const plan::Map& map) {
  Sentence sentence;
  sentence.text = saying.text;
  sentence.tokens = tokenize(saying.text);
  sentence.absolute.push_back(map.pose(start));
  for (plan::Action action : plan.actions) {
    start = *map.successor(start, action);
    sentence.absolute.push_back(map.pose(start));
  }
  sentence.relative = sentence.absolute;
  return sentence;
}

}  // namespace

Corpus generate_corpus(std::span<const plan::Map> maps, const GenerateOptions& options) {
  if (maps.empty()) throw std::invalid_argument("generating a corpus needs maps");
  constexpr std::size_t longest = 10;  // actions of a sentence
  Corpus corpus;
  corpus.maps.assign(maps.begin(), maps.end());
  Speaker speaker(maps.front().vocabulary(), options.seed);
  const std::vector<Executor> executors(maps.begin(), maps.end());
  for (std::size_t i = 0; i < options.paragraphs; ++i) {
    const Executor& executor = executors[i % maps.size()];
    const plan::Map& map = executor.map();
    Paragraph paragraph{"generated_" + std::to_string(i + 1), map.name(), "", {}};
    plan::PoseId here{static_cast<std::uint32_t>(speaker.below(map.poses()))};
    for (int tries = 0; paragraph.sentences.size() < options.sentences && tries < 1000; ++tries) {
      const Saying saying = speaker.say();
      const auto plan = executor.run(saying.program, here);
      if (!plan || plan->actions.empty() || plan->actions.size() > longest) continue;
      paragraph.sentences.push_back(sentence_of(saying, *plan, here, map));
      paragraph.sentences.back().id =
          std::to_string(i + 1) + "-" + std::to_string(paragraph.sentences.size());
      paragraph.text += (paragraph.text.empty() ? "" : " ") + saying.text + ".";
      here = plan->end;
    }
    corpus.paragraphs.push_back(std::move(paragraph));
  }
  return corpus;
}

}  // namespace waymark::parser

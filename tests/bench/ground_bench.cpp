// How long does grounding take? With the shipped model, on sentences of our own, one core.
//
//   load             mapping and checking the model file
//   read             the 64 most probable programs of a sentence
//   ground           the same, planned on the map from a start pose, and the end chosen
//   execute          the plan of one program, for what a learner does thousands of times
#include <benchmark/benchmark.h>

#include <string>
#include <vector>

#include "libparser/corpus/token.hpp"
#include "libparser/ground.hpp"
#include "libparser/language/generate.hpp"
#include "libparser/model_file.hpp"
#include "libplan/world/read_map.hpp"

namespace waymark::parser {
namespace {

const std::string data = WAYMARK_SOURCE_DIR "/data";

struct Workload {
  Workload() {
    const Corpus corpus = generate_corpus({&map, 1}, {.seed = 1, .paragraphs = 64, .sentences = 4});
    for (const Paragraph& paragraph : corpus.paragraphs)
      for (const Sentence& sentence : paragraph.sentences) {
        texts.push_back(sentence.text);
        starts.push_back(map.find(sentence.absolute.front()).value());
      }
  }
  plan::Map map = plan::read_map("grid", data);
  Grounder model = load_grounder(data + "/models/encoder-decoder.waymark");
  std::vector<std::string> texts;
  std::vector<plan::PoseId> starts;
};

const Workload& workload() {
  static const Workload shared;
  return shared;
}

void load(benchmark::State& state) {
  for (auto _ : state) benchmark::DoNotOptimize(load_grounder(data + "/models/encoder-decoder.waymark"));
}
BENCHMARK(load)->Unit(benchmark::kMillisecond);

void read(benchmark::State& state) {
  const Workload& w = workload();
  std::size_t i = 0;
  for (auto _ : state) {
    benchmark::DoNotOptimize(parser::read(w.model.word_model, {tokenize(w.texts[i++ % w.texts.size()]), false}, 64));
  }
  state.SetItemsProcessed(state.iterations());
}
BENCHMARK(read)->Unit(benchmark::kMicrosecond);

void ground_on_map(benchmark::State& state) {
  const Workload& w = workload();
  ltl::Arena arena(w.map.vocabulary());
  std::size_t i = 0;
  for (auto _ : state) {
    const std::size_t k = i++ % w.texts.size();
    benchmark::DoNotOptimize(ground(w.model, w.texts[k], w.map, {&w.starts[k], 1}, arena));
  }
  state.SetItemsProcessed(state.iterations());
}
BENCHMARK(ground_on_map)->Name("ground")->Unit(benchmark::kMicrosecond);

void execute(benchmark::State& state) {
  const Workload& w = workload();
  const Executor executor(w.map);
  const auto chair = static_cast<std::uint16_t>(w.map.vocabulary().find("chair").value().index);
  const auto wall = static_cast<std::uint16_t>(w.map.vocabulary().find("ahead_wall").value().index);
  const Program program{{StepKind::Reach, 0, 1, {chair}}, {StepKind::Advance, 0, 1, {wall}}};
  std::uint32_t s = 0;
  for (auto _ : state) {
    benchmark::DoNotOptimize(executor.run(program, {s}));
    s = (s + 1) % static_cast<std::uint32_t>(w.map.poses());
  }
  state.SetItemsProcessed(state.iterations());
}
BENCHMARK(execute)->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace waymark::parser

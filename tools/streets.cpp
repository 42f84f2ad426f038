#include "tools/streets.hpp"

#include <iomanip>
#include <iostream>

#include "libltl/diagnostic.hpp"
#include "libltl/text/print.hpp"
#include "libparser/domain/streets/evaluate_streets.hpp"
#include "libparser/domain/streets/street_corpus.hpp"
#include "libparser/domain/streets/street_formula.hpp"
#include "tools/corridor.hpp"
#include "tools/shell/json.hpp"
#include "tools/shell/learning.hpp"
#include "tools/shell/output.hpp"
#include "tools/shell/terminal.hpp"

namespace waymark::tools {
namespace {

using streets::StreetEvaluation;
using streets::StreetScores;

// The scores are defined in evaluate_streets.hpp. `floor` needs no learning, `supply` bounds every ranker from above.
JsonObject scores_json(const StreetScores& scores) {
  return JsonObject()
      .add("exact_path", scores.exact_path.value())
      .add("goal", scores.goal.value())
      .add("floor", scores.floor.value())
      .add("supply", scores.supply.value())
      .add("n", scores.exact_path.total);
}

JsonArray ids(const streets::StreetMap& map, const streets::StreetRoute& route) {
  JsonArray out;
  for (const streets::LandmarkIndex i : route) out.add(map.landmarks[i].id);
  return out;
}

// The formula whose plan the route is; null where a way is longer than a detour.
Json formula_of(const streets::StreetMap& map, const streets::StreetRoute& route) {
  const auto named = streets::waypoints(map, route);
  if (!named) return {};
  ltl::Arena arena;
  return ltl::print(streets::visit_in_order(map, *named, arena));
}

std::string prediction_lines(const streets::StreetCorpus& corpus, const StreetEvaluation& evaluation) {
  std::string out;
  for (const streets::StreetPrediction& prediction : evaluation.predictions) {
    const streets::StreetInstruction& instruction = *prediction.instruction;
    const streets::StreetMap& map = corpus.maps[instruction.map];
    JsonObject line;
    line.add("id", instruction.id).add("map", map.name).add("start", map.landmarks[instruction.start].id);
    line.add("gold", ids(map, instruction.path));
    JsonArray readings;
    for (const streets::StreetReading& reading : prediction.readings)
      readings.add(JsonObject()
                       .add("formula", formula_of(map, reading.route.landmarks))
                       .add("path", ids(map, reading.route.landmarks))
                       .add("rank", reading.route.rank + 1)
                       .add("probability", reading.probability));
    JsonArray mentions;
    for (const streets::Mention& mention : prediction.mentions) {
      JsonArray fits;
      for (const streets::NameFit& fit : mention.fits) fits.add(map.landmarks[fit.landmark].id);
      mentions.add(JsonObject().add("begin", mention.begin).add("end", mention.end).add("landmarks", fits));
    }
    out += line.add("readings", readings).add("mentions", mentions).text() + "\n";
  }
  return out;
}

void print_row(const std::string& name, std::initializer_list<double> values, std::size_t n) {
  std::cout << std::left << std::setw(16) << name << std::right;
  for (const double value : values) std::cout << std::setw(12) << fixed(value, 2);
  std::cout << std::setw(14) << n << '\n';
}

void print_table(const StreetEvaluation& evaluation, double seconds) {
  std::cout << "per cent, all instructions\n\n"
            << "left out          exact path        goal       floor      supply  instructions\n";
  const auto row = [](const std::string& name, const StreetScores& s) {
    print_row(name, {s.exact_path.value(), s.goal.value(), s.floor.value(), s.supply.value()}, s.exact_path.total);
  };
  for (const auto& [map, scores] : evaluation.folds) row(map, scores);
  row("all", evaluation.all);
  std::cout << "\nmean over cities: exact path " << fixed(evaluation.mean_exact_path, 2) << ", goal "
            << fixed(evaluation.mean_goal, 2) << "; " << fixed(seconds, 1) << " s of training and testing\n";
}

}  // namespace

ExitCode evaluate_streets(const StreetExperiment& experiment, const Session& session) {
  StopWatch watch;
  const bool elsewhere = !experiment.test_corpus.empty();
  if (elsewhere && !streets::is_street_corpus(experiment.test_corpus))
    throw ltl::FormatError(experiment.test_corpus, 0, 0, "is no corpus of streets, and --corpus is one");
  const streets::StreetCorpus corpus = streets::read_street_corpus(experiment.corpus);
  std::optional<streets::StreetCorpus> other;
  if (elsewhere) other = streets::read_street_corpus(experiment.test_corpus);
  const streets::StreetCorpus& test = other ? *other : corpus;
  if (!experiment.train_all && corpus.maps.size() < 2 && !other)
    throw UsageError("there is one city only: nothing is left to train on when it is left out");
  streets::StreetOptions options = experiment.options;
  options.ranker.stop = session.stop;
  const StreetEvaluation evaluation = learn_from(experiment.corpus, [&] {
    return streets::evaluate_streets(corpus, test, experiment.train_all, experiment.threads, options);
  });
  if (!experiment.predictions.empty()) write_file(experiment.predictions, prediction_lines(test, evaluation));
  const double seconds = watch.lap();
  if (!experiment.json) {
    print_table(evaluation, seconds);
    return ExitCode::Done;
  }
  JsonObject cities;
  for (const auto& [map, scores] : evaluation.folds) cities.add(map, scores_json(scores));
  std::cout << JsonObject()
                   .add("exact_path", evaluation.mean_exact_path)
                   .add("goal", evaluation.mean_goal)
                   .add("by_map", cities)
                   .add("all", scores_json(evaluation.all))
                   .add("seconds", seconds)
                   .text()
            << '\n';
  return ExitCode::Done;
}

}  // namespace waymark::tools

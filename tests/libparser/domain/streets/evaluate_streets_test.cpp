#include "libparser/domain/streets/evaluate_streets.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "libltl/diagnostic.hpp"
#include "libltl/text/print.hpp"
#include "libparser/corpus/token.hpp"
#include "libparser/domain/streets/street_formula.hpp"
#include "libparser/supervision/examples.hpp"
#include "tests/libparser/domain/streets/town.hpp"

namespace waymark::streets {
namespace {

// Towns of invented names, and texts of a small grammar about routes drawn from the shortest ones.
StreetCorpus invented(std::uint64_t seed, std::size_t texts) {
  const std::vector<std::vector<std::string>> names{{"Anvil", "Brook", "Castle", "Dairy", "Elm", "Forge", "Gate"},
                                                    {"Harbour", "Inn", "Jetty", "Kiln", "Lodge", "Mint", "Nook"},
                                                    {"Oven", "Pier", "Quarry", "Ruin", "Stable", "Tavern", "Utopia"}};
  std::mt19937_64 random(seed);
  StreetCorpus corpus;
  for (const auto& town : names) {
    StreetMap map;
    map.name = parser::tokenize(town[0])[0];
    for (std::size_t i = 0; i < town.size(); ++i) {
      const double right = static_cast<double>(i % 3) + 0.1 * static_cast<double>(random() % 5);
      const std::size_t row = i / 3;
      const double up = static_cast<double>(row) + 0.1 * static_cast<double>(random() % 5);
      map.landmarks.push_back({static_cast<int>(i), town[i], right, up});
    }
    map.ways.resize(town.size());
    for (LandmarkIndex a = 0; a < town.size(); ++a)
      for (LandmarkIndex b = 0; b < town.size(); ++b)
        if (a != b && map.distance(a, b) < 1.6) map.ways[a].push_back({b, map.distance(a, b)});
    corpus.maps.push_back(std::move(map));
  }
  for (std::size_t i = 0; i < texts; ++i) {
    StreetInstruction text;
    text.map = i % corpus.maps.size();
    const StreetMap& map = corpus.maps[text.map];
    text.start = static_cast<LandmarkIndex>(random() % 7);
    const auto goal = static_cast<LandmarkIndex>((text.start + 1 + random() % 6) % 7);
    const auto routes = shortest_simple_routes(map, text.start, goal, 6);
    text.path = routes[random() % routes.size()].landmarks;
    const auto name = [&](std::size_t p) { return map.landmarks[text.path[p]].name; };
    text.text = (i % 2 == 0 ? "start at the " : "from the ") + name(0);
    if (i % 4 == 3 && text.path.size() > 2) {
      text.text += " go to the " + name(text.path.size() - 1) + " via the " + name(1);
      for (std::size_t p = 2; p + 1 < text.path.size(); ++p) text.text += " and the " + name(p);
    } else {
      for (std::size_t p = 1; p < text.path.size(); ++p)
        text.text += (p > 1 ? " then go to the " : " go to the ") + name(p);
    }
    text.tokens = parser::tokenize(text.text);
    corpus.instructions.push_back(std::move(text));
  }
  return corpus;
}

TEST(Streets, AreReadInTownsNeverSeen) {
  const StreetCorpus corpus = invented(1, 300);
  const auto evaluation = evaluate_streets(corpus, corpus, false, 2, {});
  EXPECT_EQ(evaluation.folds.size(), 3U);
  EXPECT_EQ(evaluation.all.exact_path.total, 300U);
  EXPECT_EQ(evaluation.all.supply.hits, 300U);
  EXPECT_GE(evaluation.all.exact_path.hits, 294U);
  EXPECT_GT(evaluation.all.exact_path.hits, evaluation.all.floor.hits);  // a fourth says its goal first
  for (const StreetPrediction& p : evaluation.predictions) {
    double sum = 0;
    for (const StreetReading& reading : p.readings) sum += reading.probability;
    EXPECT_LE(sum, 1 + 1e-9) << p.instruction->text;
  }
}

TEST(Streets, AreReadTheSameByAnyNumberOfThreads) {
  const StreetCorpus corpus = invented(2, 60);
  const auto one = evaluate_streets(corpus, corpus, false, 1, {}),
             three = evaluate_streets(corpus, corpus, false, 3, {});
  ASSERT_EQ(one.predictions.size(), three.predictions.size());
  for (std::size_t i = 0; i < one.predictions.size(); ++i) {
    EXPECT_EQ(one.predictions[i].readings[0].route.landmarks, three.predictions[i].readings[0].route.landmarks);
    EXPECT_EQ(one.predictions[i].readings[0].probability, three.predictions[i].readings[0].probability);
  }
}

TEST(Streets, TheRivalIsPushedAway) {
  const StreetCorpus corpus = invented(6, 60);
  std::vector<Streets::Text> texts;
  for (const StreetInstruction& text : corpus.instructions) texts.push_back(&text);
  // Of what the route described does not get, the part that the next longer one to its goal gets.
  const auto share = [&](double against_rival) {
    StreetOptions options;
    options.ranker.epochs = 1;
    options.ranker.against_rival = against_rival;
    const auto model = learn_streets(texts, corpus.maps, options);
    Streets streets(corpus.maps, model.common, model.limits);
    double rival = 0, wrong = 0;
    for (const StreetInstruction& text : corpus.instructions) {
      const auto readings = rank_routes(streets, model.weights, &text, streets.candidates(&text));
      for (const StreetReading& gold : readings) {
        if (gold.route.landmarks != text.path) continue;
        wrong += 1 - gold.probability;
        for (const StreetReading& r : readings)
          if (r.route.landmarks == gold.route.rival) rival += r.probability;
      }
    }
    return rival / wrong;
  };
  EXPECT_GT(share(0), 0);
  EXPECT_LT(share(4), 0.9 * share(0));
}

TEST(Streets, AskForSomethingToLearnFrom) {
  StreetCorpus corpus = invented(3, 10);
  StreetCorpus one_town = corpus;
  std::erase_if(one_town.instructions, [](const StreetInstruction& i) { return i.map != 0; });
  EXPECT_THROW(evaluate_streets(one_town, one_town, false, 1, {}), std::invalid_argument);
  EXPECT_EQ(evaluate_streets(one_town, corpus, true, 1, {}).folds.size(), 3U);  // trained on all of it
  StreetOptions stopped;
  std::stop_source stop;
  stop.request_stop();
  stopped.ranker.stop = stop.get_token();
  EXPECT_THROW(evaluate_streets(corpus, corpus, false, 1, stopped), parser::Stopped);
}

TEST(StreetFormula, ItsPlanIsTheRoute) {
  const StreetMap map = town();
  const std::vector<bool> nothing(map.landmarks.size(), false);
  for (LandmarkIndex start = 0; start < map.landmarks.size(); ++start)
    for (LandmarkIndex goal = 0; goal < map.landmarks.size(); ++goal)
      for (const RankedRoute& route : shortest_simple_routes(map, start, goal, 10)) {
        const auto named = waypoints(map, route.landmarks);
        ASSERT_TRUE(named);
        StreetRoute walked{start};
        for (const LandmarkIndex next : *named) {
          const StreetRoute leg = shortest_street_route(map, walked.back(), next, nothing);
          walked.insert(walked.end(), leg.begin() + 1, leg.end());
        }
        EXPECT_EQ(walked, route.landmarks) << "from " << start << " to " << goal;
        EXPECT_LT(named->size(), route.landmarks.size());
      }
  ltl::Arena arena;
  EXPECT_EQ(ltl::print(visit_in_order(map, {old_mill, wall}, arena)), "F(old_mill & F wall)");
  EXPECT_EQ(Streets::vocabulary(map).find("old_mill"), ltl::Proposition{old_mill});
}

TEST(StreetCorpus, LinesSayWhatIsWrongWithThem) {
  const std::vector<StreetMap> maps{town()};
  const auto complaint = [&](std::string_view line) {
    try {
      parse_street_instructions(line, maps, "town.jsonl");
    } catch (const ltl::FormatError& error) {
      return std::string(error.what());
    }
    return std::string("nothing");
  };
  EXPECT_EQ(complaint(R"({"id": "1", "map": "town", "start": 0, "text": "to the bakery", "path": [0, 1]})"), "nothing");
  EXPECT_NE(complaint(R"({"id": "1", "map": "city", "start": 0, "text": "", "path": [0]})").find("called 'city'"),
            std::string::npos);
  EXPECT_NE(complaint(R"({"id": "1", "map": "town", "start": 4, "text": "", "path": [4]})").find("start"),
            std::string::npos);
  EXPECT_NE(complaint(R"({"id": "1", "map": "town", "start": 0, "text": "", "path": [0, 2]})").find("path[1]"),
            std::string::npos);
  EXPECT_NE(complaint(R"({"id": "1", "map": "town", "start": 1, "text": "", "path": [0, 1]})").find("the start"),
            std::string::npos);
  EXPECT_NE(complaint("[").find("town.jsonl:1"), std::string::npos);
}

}  // namespace
}  // namespace waymark::streets

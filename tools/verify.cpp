// waymark verify: is what an answer claims true? From the printed answer alone, by code that did not find it: formulas
// by the definition of ⊨, least costs and infeasibility by progression, automata word by word.
#include <iostream>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <utility>
#include <vector>

#include "libplan/world/json_reader.hpp"
#include "tools/claims.hpp"
#include "tools/plan_case.hpp"
#include "tools/shell/batch.hpp"
#include "tools/shell/json.hpp"
#include "tools/shell/options.hpp"
#include "tools/shell/output.hpp"
#include "tools/shell/subcommand.hpp"
#include "tools/shell/work_limits.hpp"
#include "tools/verify_automaton.hpp"
#include "tools/verify_check.hpp"
#include "tools/verify_map.hpp"
#include "tools/verify_model.hpp"
#include "tools/verify_property.hpp"

namespace waymark::tools {
namespace {

struct VerifyOptions {
  TextOptions text;
  MapOptions map{.map = "", .data = {}};  // no map: the answer's
  ModelOptions reader;                    // of the texts of run
  CaseChoice of;                          // --model, --const, --properties
  std::string start;                      // of its street graph
  std::size_t words = 2000, pairs = 1'000'000;
  WorkLimits limits;
  bool json = false;
};

// The kind of an answer, by the keys that only this kind has; then its examiner.
std::vector<Claim> claims_of(const Text& text, const VerifyOptions& options, const plan::PlanningCase* model,
                             TextReferee& read, const std::stop_token& stop) {
  const plan::JsonReader in(text.text, text.source, text.line);
  const Claims::Value answer = in.parse();
  if (!answer.is_object()) in.fail("", "expected the JSON object that a subcommand printed");
  Claims claims(in, answer);
  const ltl::Limits limits{.states = options.pairs, .stop = stop};
  const bool on_model = answer.contains("query") || answer.contains("property") || answer.contains("holds");
  if (on_model && model == nullptr) throw UsageError("an answer on a model: give the file to --model");
  if (answer.contains("property")) {
    examine_property(claims, in, options.of, limits);
  } else if (answer.contains("holds")) {
    examine_check(claims, in, answer, *model, limits);
  } else if (answer.contains("query")) {
    examine_on_model(claims, in, answer, *model, limits);
  } else if (answer.contains("hoa")) {
    examine_automaton(claims, in, text.source, options.words, stop);
  } else if (answer.contains("map") && answer.contains("formula")) {
    MapOptions of_map = options.map;
    if (of_map.map.empty()) of_map.map = claims.text("map");
    const plan::Map map = read_map(of_map);
    claims.expect_text("map", map.name());
    examine_on_map(claims, in, answer, text, map, read, limits);
  } else {
    in.fail("",
            "expected an answer of plan or run with its map, of plan --model with its query or property, of check "
            "--model, or "
            "of translate --format json with its automaton");
  }
  return std::move(claims).all();
}

const char* word_for(const Claim& claim) {
  if (!claim.holds) return "not examined  ";
  return *claim.holds ? "verified      " : "refuted       ";
}

ExitCode verify_one(const Text& text, const VerifyOptions& options, const plan::PlanningCase* model, TextReferee& read,
                    const Session& session) {
  const ltl::Watch watch(granted(options.limits), session.stop);
  const std::vector<Claim> claims = claims_of(text, options, model, read, watch.token());
  if (session.stop.stop_requested()) throw Interrupted();
  const ExitCode verdict = verdict_of(claims);
  if (options.json) {
    JsonArray list;
    for (const Claim& claim : claims)
      list.add(JsonObject().add("claim", claim.text).add("holds", claim.holds ? Json(*claim.holds) : Json()));
    std::cout << JsonObject().add("verdict", verdict_in_words(verdict)).add("claims", list).text() << '\n';
    return verdict;
  }
  std::cout << session.out.paint(verdict == ExitCode::Done ? Paint::Green : Paint::Red, verdict_in_words(verdict))
            << '\n';
  for (const Claim& claim : claims) std::cout << "  " << word_for(claim) << claim.text << '\n';
  return verdict;
}

}  // namespace

Runner setup_verify(Command command) {
  const auto options = std::make_shared<VerifyOptions>();
  command.add_option("answers", options->text.file, "JSON lines of plan, run or translate; - is standard input")
      .type_name("FILE");
  command.add_option("--map", options->map.map, "the map of the answer (else by the name that the answer gives)")
      .type_name("MAP");
  command
      .add_option("--model", options->of.model, "the model of answers of plan --model, plan --case and check --model")
      .type_name("FILE");
  command.add_option("--start", options->start, "the landmark of a street graph where they start")
      .type_name("LANDMARK");
  command.add_option("--model-file", options->reader.file, "the model by which run read its texts").type_name("FILE");
  add_data_option(command, options->map.data);
  command.add_option("--const", options->of.constants, "of a model in the language of PRISM: N=3,p=0.5")
      .type_name("LIST");
  command.add_option("--rewards", options->of.rewards, "of such a model: the rewards that are costs").type_name("NAME");
  command.add_option("--properties", options->of.properties, "the file of properties that answers are about")
      .type_name("FILE");
  command.add_option("--words", options->words, "on which an automaton is compared with its formula")
      .between(1, 100'000'000)
      .show_default();
  command.add_option("--pairs", options->pairs, "of pose and formula, before a claim is left unexamined")
      .between(1, 100'000'000)
      .show_default();
  add_work_limits(command, options->limits, "an answer");
  command.add_flag("--json", options->json, "one JSON object a line");
  return [options](const Session& session) {
    TextOptions from = options->text;
    if (from.file.empty()) from.file = "-";
    TextReader texts(from, "answer");
    std::optional<plan::PlanningCase> model;
    TextReferee read(options->reader, options->map.data);
    if (!options->of.model.empty()) model = read_model(options->of, options->start, session.stop);
    return answer_each(
        texts, session.stop,
        [&](const Text& text) { return verify_one(text, *options, model ? &*model : nullptr, read, session); },
        options->json);
  };
}

}  // namespace waymark::tools

#include "tools/verify_reading.hpp"

#include <algorithm>
#include <utility>

#include "libltl/diagnostic.hpp"
#include "libltl/meaning/semantics.hpp"
#include "libltl/text/parse.hpp"
#include "libltl/text/print.hpp"
#include "libltl/text/read_word.hpp"
#include "libparser/grounding/understand.hpp"
#include "libplan/world/json_reader.hpp"
#include "tools/alternatives.hpp"
#include "tools/understood.hpp"

namespace waymark::tools {
namespace {

using Value = Claims::Value;

class OfText {
 public:
  OfText(Claims& claims, const plan::JsonReader& in, const ToldReading& told, TextReferee& referee,
         const std::stop_token& stop)
      : claims_(claims), in_(in), told_(told), referee_(referee), stop_(stop), arena_(told.map.vocabulary()) {}

  void examine() {
    const std::string text = claims_.text("instruction"), english = claims_.text("understood");
    claims_.add(english == in_english(told_.formula, told_.semantics, told_.map),
                "understood says " + ltl::print(told_.formula) + " in English");
    const Value& readings = claims_.member("readings");
    const Value none = Value::array();
    const Value& others = claims_.has("alternatives") ? claims_.member("alternatives") : none;
    if (!readings.is_array() || readings.empty()) in_.fail("readings", "expected a reading");
    claims_.add(in_.member(readings[0], "readings[0]", "formula") == ltl::print(told_.formula),
                "the formula is the first reading");
    if (!others.is_array()) in_.fail("alternatives", "expected a list");
    for (std::size_t i = 0; i < others.size(); ++i) other(others[i], "alternatives[" + std::to_string(i) + ']');
    again(text, readings, others);
  }

 private:
  // A word that one of both satisfies.
  void other(const Value& one, const std::string& path) {
    const ltl::Formula f = ltl::parse(in_.string(in_.member(one, path, "formula"), path + ".formula"), arena_,
                                      {.unknown = ltl::Unknown::Reject});
    claims_.add(in_.member(one, path, "english") == in_english(f, ltl::Semantics::Finite, told_.map),
                path + ".english says " + ltl::print(f) + " in English");
    const Value& difference = in_.member(one, path, "distinguishing");
    const std::string at = path + ".distinguishing",
                      word = in_.string(in_.member(difference, at, "word"), at + ".word");
    ltl::Vocabulary names = told_.map.vocabulary();
    const ltl::AnyWord read = ltl::read_word(word, names);
    const auto* finite = std::get_if<ltl::Trace>(&read);
    if (finite == nullptr) in_.fail(at + ".word", "expected a finite word");
    const bool is_first = in_.member(difference, at, "word_of") == "first";
    claims_.add(ltl::holds(*finite, told_.formula) == is_first && ltl::holds(*finite, f) != is_first,
                "the word of " + path + " tells it from the first reading");
  }

  // By the model, from where the route begins, or from all headings of that place.
  void again(const std::string& text, const Value& readings, const Value& others) {
    const plan::Pose pose = told_.map.pose(told_.start);
    std::vector<plan::PoseId> all;
    for (const int heading : {0, 90, 180, 270})
      if (const auto found = told_.map.find({pose.x, pose.y, heading})) all.push_back(*found);
    const bool same = reads_as(text, {told_.start}, readings, others) || reads_as(text, all, readings, others);
    const std::optional<bool> holds = same ? std::optional(true) : std::nullopt;
    claims_.add(holds, "the text has these readings");
    if (claims_.has("alternatives")) claims_.add(holds, "these are the alternatives");
  }

  bool reads_as(const std::string& text, const std::vector<plan::PoseId>& starts, const Value& readings,
                const Value& others) {
    const parser::Executor executor(told_.map);
    ltl::Arena arena(told_.map.vocabulary());
    const auto found = [&]() -> std::vector<parser::Reading> {
      try {
        return parser::understand(referee_.model(), text, executor, starts, arena, {.least = 0}).readings;
      } catch (const ltl::FormatError&) {
        return {};  // a text that says nothing
      }
    }();
    if (found.size() < readings.size()) return false;
    for (std::size_t i = 0; i < readings.size(); ++i)
      if (readings[i] != Value{{"formula", ltl::print(found[i].formula)}, {"probability", found[i].probability}})
        return false;
    return !claims_.has("alternatives") ||
           Value::parse(json_of(alternatives(found, told_.map, starts, stop_), told_.map).text()) == others;
  }

  Claims& claims_;
  const plan::JsonReader& in_;
  const ToldReading& told_;
  TextReferee& referee_;
  const std::stop_token& stop_;
  ltl::Arena arena_;
};

}  // namespace

const parser::Grounder& TextReferee::model() {
  if (!model_) model_ = read_model(options_, data_);
  return *model_;
}

void examine_reading(Claims& claims, const plan::JsonReader& in, const ToldReading& told, TextReferee& referee,
                     const std::stop_token& stop) {
  OfText(claims, in, told, referee, stop).examine();
}

}  // namespace waymark::tools

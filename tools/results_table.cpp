#include "tools/results_table.hpp"

#include <array>
#include <cmath>
#include <iomanip>
#include <iostream>
#include <limits>

#include "tools/shell/terminal.hpp"

namespace waymark::tools {
namespace {

using parser::Percent, parser::Scores;

constexpr int name_width = 34;

// Table 4 of the paper that waymark follows: the whole corpus, the convention for the first heading not stated.
struct Published {
  const char* name;
  double sentence, paragraph;  // per cent; NaN: none
};
constexpr double none = std::numeric_limits<double>::quiet_NaN();
constexpr std::array published{
    Published{"Chen & Mooney 2011", 54.4, 16.18},
    Published{"Chen 2012", 57.28, 19.18},
    Published{"Chen 2012, additional data", 57.62, 20.64},
    Published{"Kim & Mooney 2012", 57.22, 20.17},
    Published{"Artzi & Zettlemoyer 2013", 65.28, 31.93},
    Published{"Andreas & Klein 2015", 59.60, none},
    Published{"Mei et al. 2016", 71.05, 30.34},
    Published{"the paper", 66.92, 20.17},
};

std::array<Percent, columns_of_results> cells_of(const Scores& s) {
  return {s.sentence.absolute, s.sentence.relative, s.paragraph.absolute, s.paragraph.relative,
          s.path.precision,    s.path.recall,       s.path.accuracy,      s.satisfiable};
}

struct Moments {
  double mean = 0, deviation = 0;  // of a sample
};

template <class Value>
Moments moments(const std::vector<Scores>& runs, const Value& value) {
  Moments out;
  const auto n = static_cast<double>(runs.size());
  for (const Scores& run : runs) out.mean += value(run) / n;
  for (const Scores& run : runs) out.deviation += std::pow(value(run) - out.mean, 2);
  out.deviation = runs.size() < 2 ? 0 : std::sqrt(out.deviation / (n - 1));
  return out;
}

// Null where nothing was counted, as under a convention that was not asked for.
Json json_of(const Percent& percent) { return percent.total == 0 ? Json() : Json(percent.value()); }

Json json_of(const parser::ConventionScores& scores) {
  return JsonObject().add("absolute", json_of(scores.absolute)).add("relative", json_of(scores.relative));
}

Json json_of(const parser::PathScores& path) {
  return JsonObject()
      .add("precision", json_of(path.precision))
      .add("recall", json_of(path.recall))
      .add("accuracy", json_of(path.accuracy));
}

// Of every cell one of the two moments.
JsonObject& add_moments(JsonObject& json, const std::vector<Scores>& runs, double Moments::*which) {
  const auto cell = [&](std::size_t c) {
    return moments(runs, [c](const Scores& s) { return cells_of(s)[c].value(); }).*which;
  };
  return json.add("sentence", JsonObject().add("absolute", cell(0)).add("relative", cell(1)))
      .add("paragraph", JsonObject().add("absolute", cell(2)).add("relative", cell(3)))
      .add("path", JsonObject().add("precision", cell(4)).add("recall", cell(5)).add("accuracy", cell(6)))
      .add("satisfiable", cell(7));
}

}  // namespace

JsonObject& add_scores(JsonObject& json, const Scores& scores) {
  return json.add("sentence", json_of(scores.sentence))
      .add("paragraph", json_of(scores.paragraph))
      .add("path", json_of(scores.path))
      .add("paragraph_path", json_of(scores.paragraph_path))
      .add("satisfiable", json_of(scores.satisfiable))
      .add("n",
           JsonObject()
               .add("sentences", std::max(scores.sentence.absolute.total, scores.sentence.relative.total))
               .add("paragraphs", std::max(scores.paragraph.absolute.total, scores.paragraph.relative.total))
               .add("unsegmented_paragraphs_skipped", scores.skipped_paragraphs));
}

JsonObject json_of(const ResultRow& row) {
  JsonObject json;
  json.add("name", row.name);
  if (row.runs.size() == 1) {
    add_scores(json, row.runs.front());
    return json;
  }
  JsonObject deviation;
  JsonArray runs;
  add_moments(json, row.runs, &Moments::mean);
  json.add("deviation", add_moments(deviation, row.runs, &Moments::deviation));
  for (const Scores& scores : row.runs) {
    JsonObject run;
    runs.add(add_scores(run, scores));
  }
  json.add("runs", runs);
  return json;
}

JsonArray published_results() {
  const auto number = [](double value) { return std::isnan(value) ? Json() : Json(value); };
  JsonArray rows;
  for (const Published& row : published)
    rows.add(JsonObject()
                 .add("name", std::string(row.name))
                 .add("sentence", number(row.sentence))
                 .add("paragraph", number(row.paragraph)));
  return rows;
}

Scores scores_of_staying(const parser::Corpus& corpus, std::span<const plan::Map> maps, bool absolute,
                         bool relative) {
  Scores all;
  for (const plan::Map& map : maps)
    for (const parser::Convention convention : {parser::Convention::Absolute, parser::Convention::Relative})
      if (convention == parser::Convention::Absolute ? absolute : relative)
        all += parser::evaluate(parser::StayingFollower(), corpus, map, convention);
  return all;
}

void print_results_head(const std::string& first) {
  std::cout << "per cent; the unknown start heading is north (absolute) or 90 degrees left of the first "
               "known one (relative);\n"
               "path scores are under the absolute convention; satisfied: sentences whose formula has a plan "
               "on the map\n\n"
            << std::string(name_width + 5, ' ')
            << "sentence            paragraph                  path             formulas\n"
            << std::left << std::setw(name_width) << first << std::right
            << "  absolute  relative  absolute  relative precision    recall  accuracy satisfied  sentences  "
               "paragraphs\n";
}

void print_result(const ResultRow& row) {
  const auto line = [&](const std::string& name, double Moments::*which) {
    std::cout << std::left << std::setw(name_width) << name << std::right;
    for (std::size_t c = 0; c < columns_of_results; ++c) {
      const double value = moments(row.runs, [c](const Scores& s) { return cells_of(s)[c].value(); }).*which;
      const bool measured = cells_of(row.runs.front())[c].total > 0;
      std::cout << std::setw(10) << (measured ? fixed(value, 2) : "-");
    }
  };
  const Scores& first = row.runs.front();
  line(row.name, &Moments::mean);
  std::cout << std::setw(11) << std::max(first.sentence.absolute.total, first.sentence.relative.total)
            << std::setw(12) << std::max(first.paragraph.absolute.total, first.paragraph.relative.total)
            << '\n';
  if (row.runs.size() == 1) return;
  line("  standard deviation of " + std::to_string(row.runs.size()), &Moments::deviation);
  std::cout << '\n';
}

void print_published_results() {
  std::cout
      << "\npublished, for the whole corpus; single sentences and paragraphs, the convention not stated\n";
  for (const Published& row : published) {
    std::cout << std::left << std::setw(name_width) << row.name << std::right << std::setw(10)
              << fixed(row.sentence, 2) << std::setw(20)
              << (std::isnan(row.paragraph) ? "-" : fixed(row.paragraph, 2)) << '\n';
  }
}

}  // namespace waymark::tools

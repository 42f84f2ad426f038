#include "tools/shell/results_table.hpp"

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

// What others published for the whole corpus: Table 4 of the paper that waymark follows, and two rows from elsewhere;
// path scores are on masks that are not defined.
struct Published {
  const char* name;
  double sentence, paragraph;  // per cent; NaN: none
  std::array<double, 3> path;  // precision, recall, accuracy
  const char* convention;      // for the first heading; empty: not stated
};
constexpr double none = std::numeric_limits<double>::quiet_NaN();
constexpr std::array<double, 3> no_path{none, none, none};
constexpr std::array published{
    Published{"Chen & Mooney 2011", 54.4, 16.18, no_path, ""},
    Published{"Chen 2012", 57.28, 19.18, no_path, ""},
    Published{"Chen 2012, additional data", 57.62, 20.64, no_path, ""},
    Published{"Kim & Mooney 2012", 57.22, 20.17, no_path, ""},
    Published{"Artzi & Zettlemoyer 2013", 65.28, 31.93, no_path, "absolute"},
    Published{"Artzi et al. 2014", none, 35.44, no_path, "absolute"},
    Published{"Andreas & Klein 2015", 59.60, none, no_path, ""},
    Published{"Mei et al. 2016", 71.05, 30.34, {31.2, 30.19, 91.2}, "relative"},
    Published{"Can & Yuret 2018, ten models", 72.69, none, no_path, "relative"},
    Published{"the paper", 66.92, 20.17, {33.5, 35.2, 94.3}, ""},
};

using Cells = std::array<Percent, 8>;  // the columns of the table
using PathCells = std::array<Percent, 3>;
using UnheardCells = std::array<Percent, 2>;

Cells cells_of(const Scores& s) {
  return {s.sentence.absolute, s.sentence.relative, s.paragraph.absolute, s.paragraph.relative,
          s.path.precision,    s.path.recall,       s.path.accuracy,      s.satisfiable};
}
PathCells paragraph_path_of(const Scores& s) {
  return {s.paragraph_path.precision, s.paragraph_path.recall, s.paragraph_path.accuracy};
}

UnheardCells unheard_of(const Scores& s) { return {s.unheard.absolute, s.unheard.relative}; }

std::size_t count_of(const parser::ConventionScores& scores) {
  return std::max(scores.absolute.total, scores.relative.total);
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

JsonObject json_of(const parser::ConventionScores& scores) {
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
  const auto cell = [&](const auto& cells, std::size_t c) {
    if (cells(runs.front())[c].total == 0) return Json();
    return Json(moments(runs, [&](const Scores& s) { return cells(s)[c].value(); }).*which);
  };
  const auto path = [&](const auto& cells, std::size_t c) {
    return JsonObject()
        .add("precision", cell(cells, c))
        .add("recall", cell(cells, c + 1))
        .add("accuracy", cell(cells, c + 2));
  };
  const auto both = [&](const auto& cells, std::size_t c) {
    return JsonObject().add("absolute", cell(cells, c)).add("relative", cell(cells, c + 1));
  };
  return json.add("sentence", both(cells_of, 0))
      .add("paragraph", both(cells_of, 2))
      .add("unheard", both(unheard_of, 0))
      .add("path", path(cells_of, 4))
      .add("paragraph_path", path(paragraph_path_of, 0))
      .add("satisfiable", cell(cells_of, 7));
}

}  // namespace

JsonObject& add_scores(JsonObject& json, const Scores& scores) {
  return json.add("sentence", json_of(scores.sentence))
      .add("paragraph", json_of(scores.paragraph))
      .add("unheard", json_of(scores.unheard).add("n", count_of(scores.unheard)))
      .add("path", json_of(scores.path))
      .add("paragraph_path", json_of(scores.paragraph_path))
      .add("satisfiable", json_of(scores.satisfiable))
      .add("n", JsonObject()
                    .add("sentences", count_of(scores.sentence))
                    .add("paragraphs", count_of(scores.paragraph))
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
                 .add("convention", *row.convention == 0 ? Json() : Json(std::string(row.convention)))
                 .add("sentence", number(row.sentence))
                 .add("paragraph", number(row.paragraph))
                 .add("path", JsonObject()
                                  .add("precision", number(row.path[0]))
                                  .add("recall", number(row.path[1]))
                                  .add("accuracy", number(row.path[2]))));
  return rows;
}

Scores scores_of_staying(const parser::Corpus& corpus, std::span<const plan::Map> maps, bool absolute, bool relative) {
  Scores all;
  for (const plan::Map& map : maps)
    for (const parser::Convention convention : {parser::Convention::Absolute, parser::Convention::Relative})
      if (convention == parser::Convention::Absolute ? absolute : relative)
        all += parser::evaluate(parser::StayingFollower(), corpus, map, convention);
  return all;
}

namespace {

// A line of cells for each row and, of several runs, one with their deviations. end(row) ends the first.
template <class CellsOf, class End>
void print_lines(std::span<const ResultRow> rows, const CellsOf& cells_of_run, const End& end) {
  for (const ResultRow& row : rows) {
    const auto line = [&](const std::string& name, double Moments::*which) {
      std::cout << std::left << std::setw(name_width) << name << std::right;
      for (std::size_t c = 0; c < cells_of_run(row.runs.front()).size(); ++c) {
        const auto value = [&](const Scores& s) { return cells_of_run(s)[c].value(); };
        const bool measured = cells_of_run(row.runs.front())[c].total > 0;
        std::cout << std::setw(10) << (measured ? fixed(moments(row.runs, value).*which, 2) : "-");
      }
    };
    line(row.name, &Moments::mean);
    end(row);
    std::cout << '\n';
    if (row.runs.size() == 1) continue;
    line("  standard deviation of " + std::to_string(row.runs.size()), &Moments::deviation);
    std::cout << '\n';
  }
}

}  // namespace

void print_results(const std::string& first, std::span<const ResultRow> rows) {
  std::cout << "per cent; the unknown start heading is north (absolute) or 90 degrees left of the first "
               "known one (relative);\n"
               "path scores are under the absolute convention; satisfied: sentences whose formula has a plan "
               "on the map\n\n"
            << std::string(name_width + 5, ' ')
            << "sentence            paragraph                  path             formulas\n"
            << std::left << std::setw(name_width) << first << std::right
            << "  absolute  relative  absolute  relative precision    recall  accuracy satisfied  sentences  "
               "paragraphs\n";
  print_lines(rows, cells_of, [](const ResultRow& row) {
    const Scores& s = row.runs.front();
    std::cout << std::setw(11) << count_of(s.sentence) << std::setw(12) << count_of(s.paragraph);
  });
  std::cout << '\n'
            << std::left << std::setw(name_width) << "path along whole paragraphs" << std::right
            << " precision    recall  accuracy\n";
  print_lines(rows, paragraph_path_of, [](const ResultRow&) {});
  std::cout << '\n'
            << std::left << std::setw(name_width) << "sentences never heard in training" << std::right
            << "  absolute  relative  sentences\n";
  print_lines(rows, unheard_of,
              [](const ResultRow& row) { std::cout << std::setw(11) << count_of(row.runs.front().unheard); });
}

void print_published_results() {
  std::cout << "\npublished, for the whole corpus; path on masks that are not defined\n"
            << std::string(name_width, ' ') << "  sentence paragraph precision    recall  accuracy  start heading\n";
  const auto cell = [](double value) { std::cout << std::setw(10) << (std::isnan(value) ? "-" : fixed(value, 2)); };
  for (const Published& row : published) {
    std::cout << std::left << std::setw(name_width) << row.name << std::right;
    cell(row.sentence), cell(row.paragraph);
    for (const double value : row.path) cell(value);
    std::cout << "  " << (*row.convention == 0 ? "not stated" : row.convention) << '\n';
  }
}

}  // namespace waymark::tools

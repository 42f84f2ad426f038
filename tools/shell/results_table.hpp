// The table of results: ours, an agent that stays put, and what others published, in the columns of docs/results.md.
#pragma once
#include <span>
#include <string>
#include <vector>

#include "libparser/experiment/evaluate.hpp"
#include "tools/shell/json.hpp"

namespace waymark::tools {

struct ResultRow {
  std::string name;
  std::vector<parser::Scores> runs;  // of one system; several: mean and standard deviation are printed
};

// Sentence, paragraph, unheard, path, paragraph_path, satisfiable (null where no formula is read), n.
JsonObject& add_scores(JsonObject& json, const parser::Scores& scores);
// The mean of the runs under the same keys; of several, "deviation" beside it and "runs".
JsonObject json_of(const ResultRow& row);
// {"name","convention","sentence","paragraph","path"}: the paper's Table 4 and what else was published; null where
// nothing was.
JsonArray published_results();

// Of an agent that does not listen, on the maps of this corpus, under the conventions asked for.
parser::Scores scores_of_staying(const parser::Corpus& corpus, std::span<const plan::Map> maps, bool absolute,
                                 bool relative);

// What the columns mean, their heads, and all rows; `first` is the head of the names. Then the path along paragraphs, and
// sentences never heard in training.
void print_results(const std::string& first, std::span<const ResultRow> rows);
void print_published_results();

}  // namespace waymark::tools

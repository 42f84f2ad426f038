// The table of results: ours, an agent that stays put, and what others published, in the columns of docs/results.md.
#pragma once
#include <string>
#include <vector>

#include "libparser/experiment/evaluate.hpp"
#include "tools/shell/json.hpp"

namespace waymark::tools {

// One cell a column: sentences absolute and relative, paragraphs likewise, path precision, recall and accuracy, formulas that
// can be satisfied.
inline constexpr std::size_t columns_of_results = 8;
struct ResultRow {
  std::string name;
  std::vector<parser::Scores> runs;  // of one system; several: mean and standard deviation are printed
};

// Sentence, paragraph, path, paragraph_path, satisfiable (null where no formula is read), n.
JsonObject& add_scores(JsonObject& json, const parser::Scores& scores);
// The mean of the runs under the same keys; of several, "deviation" beside it and "runs".
JsonObject json_of(const ResultRow& row);
// {"name","sentence","paragraph"}, as printed in the paper's Table 4; null where nothing was published.
JsonArray published_results();

// Of an agent that does not listen, on the maps of this corpus, under the conventions asked for.
parser::Scores scores_of_staying(const parser::Corpus& corpus, std::span<const plan::Map> maps, bool absolute,
                                 bool relative);

// What the columns mean, and their heads; `first` is the head of the names.
void print_results_head(const std::string& first);
void print_result(const ResultRow& row);
void print_published_results();

}  // namespace waymark::tools

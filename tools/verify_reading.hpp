// What an answer of `run` says of its text: how it was understood, and what else it may mean.
#pragma once
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "libltl/formula.hpp"
#include "libltl/meaning/semantics.hpp"
#include "libparser/ground.hpp"
#include "libplan/world/map.hpp"
#include "tools/claims.hpp"
#include "tools/shell/models.hpp"

namespace waymark::tools {

// The grounding model, read when the first text is read.
class TextReferee {
 public:
  TextReferee(ModelOptions options, std::string data) : options_(std::move(options)), data_(std::move(data)) {}
  const parser::Grounder& model();

 private:
  ModelOptions options_;
  std::string data_;
  std::optional<parser::Grounder> model_;
};

struct ToldReading {
  const plan::Map& map;
  ltl::Formula formula;      // the first reading
  ltl::Semantics semantics;  // of the answer
  plan::PoseId start;        // of its route, or the first of its starts
};

// The sentence and the words that tell alternatives apart are examined by definitions. The text is read again by the
// model: where it reads otherwise (it may have been another model), the readings were not examined.
void examine_reading(Claims& claims, const plan::JsonReader& in, const ToldReading& told, TextReferee& referee,
                     const std::stop_token& stop);

}  // namespace waymark::tools

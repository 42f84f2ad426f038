#include "libparser/training/annotations.hpp"

#include <climits>
#include <stdexcept>

#include "libltl/diagnostic.hpp"
#include "libltl/text/parse.hpp"
#include "libparser/corpus/corpus_file.hpp"
#include "libparser/corpus/token.hpp"
#include "libparser/programs/recognise.hpp"

namespace waymark::parser {

Annotations parse_annotations(std::string_view text, const ltl::Vocabulary& vocabulary, Dialect dialect,
                              std::string_view source) {
  const PostfixGrammar grammar(vocabulary, dialect);
  ltl::Arena arena(vocabulary);
  Annotations out;
  each_line(text, [&](std::string_view line, std::size_t number) {
    if (line.front() == '#') return;
    const std::size_t tab = line.find('\t');
    if (tab == std::string_view::npos || tab == 0)
      throw ltl::FormatError(source, number, 1, "expected a sentence, a tab and a formula");
    std::string formula(line.substr(tab + 1));
    if (!formula.empty() && formula.back() == '\r') formula.pop_back();
    try {
      const auto program = program_of(ltl::parse(formula, arena, {.unknown = ltl::Unknown::Reject}), grammar);
      if (program)
        out.pairs.push_back({std::string(line.substr(0, tab)), *program, std::move(formula), number});
      else
        out.refused.push_back({number, "'" + formula + "' is no program of this dialect"});
    } catch (const ltl::SyntaxError& error) {
      out.refused.push_back({number, error.what()});
    }
  });
  return out;
}

Grounder train_supervised(const std::vector<Annotation>& pairs, const plan::Map& map, TrainOptions options) {
  if (pairs.empty()) throw std::invalid_argument("there is no pair to learn from");
  const Executor executor(map);
  std::vector<Example> examples;
  for (const Annotation& pair : pairs) {
    const std::vector<Consistent> only{{pair.program, true}};
    examples.push_back({{tokenize(pair.text), false}, 0, {}, std::make_shared<const std::vector<Consistent>>(only)});
  }
  std::vector<const Example*> instances;
  for (const Example& example : examples) instances.push_back(&example);
  options.wording = 0;             // the program is given, not preferred
  options.explore_from = INT_MAX;  // and no other is looked for
  options.network.search = ProgramSearch::Consistent;
  options.network.feedback = FeedbackKind::Plan;
  return learn_reader(instances, {&executor, 1}, options, [&](double fraction) {
    if (options.progress) options.progress(fraction, "learning from formulas");
  });
}

}  // namespace waymark::parser

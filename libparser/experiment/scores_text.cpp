#include "libparser/experiment/scores_text.hpp"

#include <array>
#include <sstream>

#include "libltl/diagnostic.hpp"

namespace waymark::parser {
namespace {

constexpr std::size_t counts = 27;

// Every count there is, in the order of their declarations.
std::array<std::size_t*, counts> counts_of(Scores& s) {
  std::array<std::size_t*, counts> out{};
  std::size_t i = 0;
  for (Percent* p :
       {&s.sentence.absolute, &s.sentence.relative, &s.paragraph.absolute, &s.paragraph.relative, &s.path.precision,
        &s.path.recall, &s.path.accuracy, &s.paragraph_path.precision, &s.paragraph_path.recall,
        &s.paragraph_path.accuracy, &s.satisfiable, &s.unheard.absolute, &s.unheard.relative}) {
    out[i++] = &p->hits;
    out[i++] = &p->total;
  }
  out[i] = &s.skipped_paragraphs;
  return out;
}

}  // namespace

std::string text_of(const Scores& scores) {
  Scores copy = scores;
  std::string line;
  for (const std::size_t* count : counts_of(copy)) line += std::to_string(*count) + ' ';
  line.back() = '\n';
  return line;
}

Scores scores_of(const std::string& line, const std::string& source) {
  Scores scores;
  std::istringstream in(line);
  for (std::size_t* count : counts_of(scores)) in >> *count;
  std::string rest;
  if (!in || in >> rest) throw ltl::FormatError(source, 1, 0, "is no line of scores");
  return scores;
}

}  // namespace waymark::parser

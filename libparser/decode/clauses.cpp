#include "libparser/decode/clauses.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "libparser/corpus/token.hpp"

namespace waymark::parser {
namespace {

constexpr std::size_t most_clauses = 4, most_kept = 16, most_steps = 120;

// A beginning of the sentence with one more part.
struct Joint {
  const Candidate *first, *second;
  double log_probability;
};

Program joined(const Program& first, const Program& second) {
  Program out = first;
  for (const Step& step : second)
    if (step.kind != StepKind::Stay) out.push_back(step);
  return out;
}

// The likeliest, different programs only. Ties: what was listed first.
std::vector<Candidate> likeliest(std::vector<Joint> joints, std::size_t most) {
  std::stable_sort(joints.begin(), joints.end(),
                   [](const Joint& a, const Joint& b) { return a.log_probability > b.log_probability; });
  std::vector<Candidate> out;
  for (const Joint& joint : joints) {
    if (out.size() == most) break;
    Program program = joined(joint.first->program, joint.second->program);
    if (program.size() > most_steps) continue;
    if (std::none_of(out.begin(), out.end(), [&](const Candidate& c) { return c.program == program; }))
      out.push_back({std::move(program), joint.log_probability});
  }
  return out;
}

// Programs of two parts or more.
std::vector<Candidate> in_parts(const ReadSentence& read, const SentenceInput& input,
                                const std::vector<Clause>& clauses, std::size_t beam) {
  const auto token = [&](std::size_t i) { return input.tokens.begin() + static_cast<std::ptrdiff_t>(i); };
  const std::size_t n = clauses.size(), kept = std::min(beam, most_kept);
  std::vector<std::vector<Candidate>> beginnings(n + 1);  // by number of clauses
  beginnings[0] = {Candidate{}};
  for (std::size_t end = 1; end <= n; ++end) {
    std::vector<std::vector<Candidate>> parts;  // that end here
    std::vector<Joint> joints;
    for (std::size_t begin = end - std::min(end, most_clauses); begin < end; ++begin) {
      if (begin == 0 && end == n) continue;                                    // that is no part
      if (begin > 0 && *token(clauses[begin].begin) == "otherwise") continue;  // goes on with what "if" began
      parts.push_back(read(
          {{token(clauses[begin].begin), token(clauses[end - 1].end)}, input.heading_unknown && begin == 0}, kept));
      for (const Candidate& first : beginnings[begin])
        for (const Candidate& second : parts.back())
          joints.push_back({&first, &second, first.log_probability + second.log_probability});
    }
    beginnings[end] = likeliest(std::move(joints), end == n ? beam : kept);
  }
  return std::move(beginnings[n]);
}

double log_of_sum(double a, double b) {
  const double most = std::max(a, b);
  return most + std::log1p(std::exp(std::min(a, b) - most));
}

}  // namespace

std::vector<Candidate> read_by_clauses(const ReadSentence& read, const SentenceInput& input, std::size_t beam) {
  std::vector<Candidate> whole = read(input, beam);
  const std::vector<Clause> clauses = clauses_of(input.tokens);
  if (clauses.size() == 1) return whole;
  std::map<Program, double> together;
  for (const Candidate& candidate : whole)
    together.emplace(candidate.program, candidate.log_probability + std::log(0.5));
  for (const Candidate& candidate : in_parts(read, input, clauses, beam)) {
    if (candidate.program.empty()) continue;  // nothing but staying: the whole sentence says so if it means it
    const double half = candidate.log_probability + std::log(0.5);
    const auto [it, is_new] = together.try_emplace(candidate.program, half);
    if (!is_new) it->second = log_of_sum(it->second, half);
  }
  std::vector<Candidate> out;
  for (const auto& [program, log_probability] : together) out.push_back({program, log_probability});
  std::stable_sort(out.begin(), out.end(),
                   [](const Candidate& a, const Candidate& b) { return a.log_probability > b.log_probability; });
  if (out.size() > beam) out.resize(beam);
  return out;
}

}  // namespace waymark::parser

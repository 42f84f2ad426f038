// A small language of routes: sentences, each said of a program. A grammar of our own, for corpora whose meaning is
// known.
//
//   plain      turns, counts, landmarks, floors, ends of halls, one or two of them in a sentence
//   temporal   also: past, the second and third, until (keep), without, before and after, if and otherwise; any number
// Things are those of a map; what a map does not have is not spoken of.
#pragma once
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "libltl/structure/random.hpp"
#include "libparser/programs/postfix_grammar.hpp"
#include "libplan/world/map.hpp"

namespace waymark::parser {

struct Saying {
  std::string text;         // the sentence
  Program program;          // that it says
  std::size_t clauses = 0;  // joined in the sentence
};

class Speaker {  // draws sentences
 public:
  Speaker(const plan::Map& map, Dialect dialect, std::uint64_t seed);
  Saying say(std::size_t clauses);                               // a sentence of so many clauses
  std::size_t below(std::size_t n) { return random_.below(n); }  // uniform in 0 … n − 1

 private:
  Saying clause();
  Saying plain_clause();
  Saying temporal_clause();
  Saying turn();
  Saying count();
  Saying to_landmark();
  Saying to_the_end();
  Saying face_floor();
  Saying until_beside();
  Saying past();
  Saying nth();
  Saying keeping();
  Saying avoiding();
  Saying before();
  Saying after();
  Saying conditional();

  std::string one_of(std::initializer_list<const char*> choices);
  std::string thing(const std::vector<std::string>& names);
  std::string other_thing(const std::string& but);
  Saying short_clause();            // of one step, for conditions and joints
  Saying condition(StepKind kind);  // its text is the condition
  Step step(StepKind kind, const std::string& literal, std::uint8_t count = 0) const;

  ltl::Vocabulary vocabulary_;
  std::vector<std::string> objects_, floors_;
  Dialect dialect_;
  ltl::Random random_;
};

}  // namespace waymark::parser

// The fifteen templates of commands [LYIL23, Appendix], in sizes 1 to 5, which the macros of lifted formulas denote.
#pragma once
#include <string>
#include <vector>

#include "libparser/lifted/lifted_symbol.hpp"

namespace waymark::parser {

struct Template {
  Lifted lifted;        // over slots 1, 2 …
  std::string formula;  // over a, b, c, d, h
};

inline const std::vector<Template>& templates() {
  static const std::vector<Template> all = [] {
    const char* const rows[][2] = {
        {"follow #1 #2", "G (a <-> X b)"},
        {"react #1 #2", "G (a -> F b)"},
        {"exactly 1 #1", "a M (!a | G (a | G !a))"},
        {"exactly 2 #1", "(a & F (!a & F a)) M (!a | G (a | G (!a | G (a | G !a))))"},
        {"exactly 3 #1", "(a & F (!a & F (a & F (!a & F a)))) M (!a | G (a | G (!a | G (a | G (!a | G (a | G !a))))))"},
        {"exactly 4 #1",
         "(a & F (!a & F (a & F (!a & F (a & F (!a & F a)))))) M "
         "(!a | G (a | G (!a | G (a | G (!a | G (a | G (!a | G (a | G !a))))))))"},
        {"exactly 5 #1",
         "(a & F (!a & F (a & F (!a & F (a & F (!a & F (a & F (!a & F a)))))))) M "
         "(!a | G (a | G (!a | G (a | G (!a | G (a | G (!a | G (a | G (!a | G (a | G !a))))))))))"},
        {"after #1 #2", "G (a -> X G !b)"},
        {"never #1 end", "G !a"},
        {"never #1 #2 end", "G !a & G !b"},
        {"never #1 #2 #3 end", "G !a & G !b & G !c"},
        {"never #1 #2 #3 #4 end", "G !a & G !b & G !c & G !d"},
        {"never #1 #2 #3 #4 #5 end", "G !a & G !b & G !c & G !d & G !h"},
        {"atleast 1 #1", "F a"},
        {"atleast 2 #1", "F (a & (a U (!a & (!a U F a))))"},
        {"atleast 3 #1", "F (a & (a U (!a & (!a U F (a & (a U (!a & (!a U F a))))))))"},
        {"atleast 4 #1", "F (a & (a U (!a & (!a U F (a & (a U (!a & (!a U F (a & (a U (!a & (!a U F a))))))))))))"},
        {"atleast 5 #1",
         "F (a & (a U (!a & (!a U F (a & (a U (!a & (!a U F (a & (a U (!a & (!a U F (a & (a U (!a & "
         "(!a U F a))))))))))))))))"},
        {"atmost 1 #1", "!F (a & (a U (!a & (!a U F a))))"},
        {"atmost 2 #1", "!F (a & (a U (!a & (!a U F (a & (a U (!a & (!a U F a))))))))"},
        {"atmost 3 #1", "!F (a & (a U (!a & (!a U F (a & (a U (!a & (!a U F (a & (a U (!a & (!a U F a))))))))))))"},
        {"atmost 4 #1",
         "!F (a & (a U (!a & (!a U F (a & (a U (!a & (!a U F (a & (a U (!a & (!a U F (a & (a U (!a & "
         "(!a U F a))))))))))))))))"},
        {"atmost 5 #1",
         "!F (a & (a U (!a & (!a U F (a & (a U (!a & (!a U F (a & (a U (!a & (!a U F (a & (a U (!a & "
         "(!a U F (a & (a U (!a & (!a U F a))))))))))))))))))))"},
        {"ordered #1 #2 end", "(!b U a) & F b"},
        {"ordered #1 #2 #3 end", "(!b U a) & (!c U b) & F c"},
        {"ordered #1 #2 #3 #4 end", "(!b U a) & (!c U b) & (!d U c) & F d"},
        {"ordered #1 #2 #3 #4 #5 end", "(!b U a) & (!c U b) & (!d U c) & (!h U d) & F h"},
        {"until not #1 #2", "!a U b"},
        {"patrol #1 end", "G F a"},
        {"patrol #1 #2 end", "G F a & G F b"},
        {"patrol #1 #2 #3 end", "G F a & G F b & G F c"},
        {"patrol #1 #2 #3 #4 end", "G F a & G F b & G F c & G F d"},
        {"patrol #1 #2 #3 #4 #5 end", "G F a & G F b & G F c & G F d & G F h"},
        {"sequence #1 #2 end", "F (a & F b)"},
        {"sequence #1 #2 #3 end", "F (a & F (b & F c))"},
        {"sequence #1 #2 #3 #4 end", "F (a & F (b & F (c & F d)))"},
        {"sequence #1 #2 #3 #4 #5 end", "F (a & F (b & F (c & F (d & F h))))"},
        {"strict #1 #2 end", "(!b U a) & F b & (!a U (a U (!a U b)))"},
        {"strict #1 #2 #3 end", "(!b U a) & (!c U b) & F c & (!a U (a U (!a U b))) & (!b U (b U (!b U c)))"},
        {"strict #1 #2 #3 #4 end",
         "(!b U a) & (!c U b) & (!d U c) & F d & (!a U (a U (!a U b))) & (!b U (b U (!b U c))) & "
         "(!c U (c U (!c U d)))"},
        {"strict #1 #2 #3 #4 #5 end",
         "(!b U a) & (!c U b) & (!d U c) & (!h U d) & F h & (!a U (a U (!a U b))) & "
         "(!b U (b U (!b U c))) & (!c U (c U (!c U d))) & (!d U (d U (!d U h)))"},
        {"visit #1 end", "F a"},
        {"visit #1 #2 end", "F a & F b"},
        {"visit #1 #2 #3 end", "F a & F b & F c"},
        {"visit #1 #2 #3 #4 end", "F a & F b & F c & F d"},
        {"visit #1 #2 #3 #4 #5 end", "F a & F b & F c & F d & F h"},
        {"until #1 #2", "a U b"},
    };
    std::vector<Template> out;
    for (const auto& row : rows) out.push_back({parse_lifted(row[0]), row[1]});
    return out;
  }();
  return all;
}

}  // namespace waymark::parser

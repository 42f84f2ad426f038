#include <iostream>

#include "libltl/meaning/progress.hpp"
#include "libltl/text/parse.hpp"
#include "libltl/text/print.hpp"

int main() {
  waymark::ltl::Arena arena;
  const auto phi = waymark::ltl::parse("X a", arena);
  std::cout << waymark::ltl::print(waymark::ltl::progress(phi, {})) << '\n';
}

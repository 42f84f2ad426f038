// A source for the test of the mutation tests: the tests beside it notice what is done to `between`, the tests of
// `doubled` do not look at odd numbers, and nothing calls `forgotten`.
#include <cstddef>

namespace waymark::toy {

bool between(std::size_t low, std::size_t x, std::size_t high) { return low <= x && x < high; }

std::size_t doubled(std::size_t x) {
  if (x > 100) return 2 * x;
  return x + x;
}

bool forgotten(bool given) { return !given; }

}  // namespace waymark::toy

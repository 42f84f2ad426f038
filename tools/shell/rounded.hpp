// Numbers in words that claim no more than is proved.
#pragma once
#include <string>

namespace waymark::tools {

// "in [0.25, 0.5]", of so many significant digits: what is below is rounded down, what is above is rounded up.
std::string between(double lower, double upper, int digits = 12);

}  // namespace waymark::tools

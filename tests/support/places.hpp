// Where files are that tests look at: the source tree, and what is shared beside it.
#pragma once
#include <filesystem>

namespace waymark::testing {

std::filesystem::path source_root();

// ../shared beside the repository, or where WAYMARK_SHARED says. Tests that need it are skipped, loudly, without it.
std::filesystem::path shared();

}  // namespace waymark::testing

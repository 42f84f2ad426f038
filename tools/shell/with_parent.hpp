// Helper executables end with the process that started them, however that ends: by Ctrl-C, SIGTERM or SIGKILL.
#pragma once
#ifdef __linux__
#include <sys/prctl.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#endif

namespace waymark::tools {

// To be called first. A parent that ended before this was called has left us to another process, number 1 or one that
// takes in orphans, and then nobody reads what we would write: SIGPIPE ends us at the latest.
inline void end_with_parent() {
#ifdef __linux__
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (::getppid() == 1) std::_Exit(0);
#endif
}

}  // namespace waymark::tools

// A loop over jobs that several processes share, in one directory of checkpoints: each takes the jobs that nobody has
// begun. A job whose process was killed is taken by another.
#pragma once
#include <functional>
#include <stop_token>
#include <string_view>

#include "libparser/experiment/checkpoints.hpp"
#include "libparser/training/parallel.hpp"

namespace waymark::parser {

struct SharedJobs {       // what is to be done
  std::size_t count = 0;  // of jobs, from 0 on
  // The part that a job leaves in the directory; of no use without one.
  std::function<std::string(std::size_t job)> part = {};
  // Makes the part, or takes it from the directory.
  std::function<void(std::size_t job, const JobProgress& progress)> run = {};
  bool waits = true;  // for what others have begun: then every job is run, last those that others made
};

struct HowToShare {                          // and by whom
  const Checkpoints* checkpoints = nullptr;  // nullptr: every job is run here
  int threads = 1;                           // of this process
  std::stop_token stop = {};                 // ends the waiting
};

// As run_jobs. Throws Stopped when a stop was requested while it waited.
void run_shared_jobs(const SharedJobs& jobs, const HowToShare& how, const Report& report, std::string_view what);

}  // namespace waymark::parser

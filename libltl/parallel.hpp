// One loop over independent jobs on several threads; every loop of the project that uses threads is this one.
//
// The results do not depend on the number of threads as long as a job writes only what belongs to the job itself or to
// its thread: jobs start in their order, and of several errors the one of the first job is thrown.
#pragma once
#include <cstddef>
#include <functional>
#include <stop_token>

namespace waymark::ltl {

// Calls run(job, thread) for every job in [0, jobs) on at most `threads` threads; the caller's is thread 0. Starts no
// job after an error or after a requested stop; jobs that have started are finished. Returns when all threads are done.
// Throws the exception of the first job that threw.
void parallel_for(std::size_t jobs, std::size_t threads,
                  const std::function<void(std::size_t job, std::size_t thread)>& run,
                  const std::stop_token& stop = {});

std::size_t hardware_threads();  // one for each core, at least one

}  // namespace waymark::ltl

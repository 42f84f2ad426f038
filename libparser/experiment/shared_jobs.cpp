#include "libparser/experiment/shared_jobs.hpp"

#include <chrono>
#include <optional>
#include <thread>
#include <vector>

#include "libparser/supervision/examples.hpp"

namespace waymark::parser {
namespace {

constexpr std::chrono::milliseconds pause_between_claims{50};

// Of a part that somebody else makes, when it is there or its maker is gone.
Claim wait_for(const Checkpoints& checkpoints, const std::string& part, const std::stop_token& stop) {
  while (true) {
    if (std::optional<Claim> claim = checkpoints.claim(part)) return std::move(*claim);
    if (stop.stop_requested()) throw Stopped();
    std::this_thread::sleep_for(pause_between_claims);
  }
}

}  // namespace

void run_shared_jobs(const SharedJobs& jobs, const HowToShare& how, const Report& report, std::string_view what) {
  std::vector<char> done(jobs.count, 0);  // of a job by its own thread
  run_jobs(jobs.count, how.threads, report, what, [&](std::size_t job, const JobProgress& progress) {
    const auto claim = how.checkpoints ? how.checkpoints->claim(jobs.part(job)) : std::nullopt;
    if (how.checkpoints != nullptr && !claim) return;
    jobs.run(job, progress);
    done[job] = 1;
  });
  std::vector<std::size_t> left;
  for (std::size_t job = 0; job < jobs.count; ++job)
    if (done[job] == 0 && jobs.waits) left.push_back(job);
  run_jobs(left.size(), how.threads, report, what, [&](std::size_t i, const JobProgress& progress) {
    const Claim claim = wait_for(*how.checkpoints, jobs.part(left[i]), how.stop);
    jobs.run(left[i], progress);
  });
}

}  // namespace waymark::parser

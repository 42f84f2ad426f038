// Bounds that were reached, kept in a folder: the same command goes on from them, on any number of ranks.
//
// A part has the values of some rows for one automaton state of one task: what sweeps had reached (`.values`), or both
// bounds once they are proved (`.proved`). Parts are written whole or not at all, with a checksum
// (libparser/experiment/checkpoints.hpp). Parts of one folder belong to the same values, so those of different moments
// and of different bands go together: the greatest lower bound counts, and the least upper one. What sweeps of costs
// had reached is no bound, but where they go on; whatever it is, bounds are proved afterwards.
#pragma once
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "libparser/experiment/checkpoints.hpp"
#include "tools/distributed/grid_band.hpp"

namespace waymark::tools {

class KeptBands {
 public:
  // `settings`: what values depend on. Throws ltl::FormatError as Checkpoints does. The band must outlive the object.
  KeptBands(const std::string& folder, const std::string& settings, const GridBand& band);
  void begin_task(std::size_t task);  // its place in the case: parts are its own from here on

  // Spans are the values of all own places, row by row. They throw ltl::FormatError where a part cannot be written.
  void keep_values(std::uint32_t state, std::span<const double> values) const;
  void keep_proved(std::uint32_t state, std::span<const double> lower, std::span<const double> upper) const;
  // Raises what is less than a kept value.
  void find_values(std::uint32_t state, std::span<double> values) const;
  // False when some row has no proved part; the spans may have changed for the better then.
  bool find_proved(std::uint32_t state, std::span<double> lower, std::span<double> upper) const;

 private:
  struct Part {
    std::size_t task;
    std::uint32_t state;
    RowRange rows;
    bool proved;
  };
  std::string name(std::uint32_t state, RowRange rows, bool proved) const;
  template <class Take>
  void for_each_row(const Part& part, const Take& take) const;

  std::string folder_;
  parser::Checkpoints checkpoints_;
  const GridBand* band_;
  std::size_t task_ = 0;
  std::vector<Part> parts_;  // of the task, as the folder was when it began
};

}  // namespace waymark::tools

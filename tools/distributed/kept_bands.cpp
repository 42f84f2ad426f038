#include "tools/distributed/kept_bands.hpp"

#include <algorithm>
#include <cstdio>
#include <cstring>
#include <filesystem>

#include "libltl/diagnostic.hpp"

namespace waymark::tools {
namespace {

template <class Number>
void append(std::string& bytes, std::span<const Number> numbers) {
  bytes.append(reinterpret_cast<const char*>(numbers.data()), numbers.size_bytes());
}

}  // namespace

KeptBands::KeptBands(const std::string& folder, const std::string& settings, const GridBand& band)
    : folder_(folder), checkpoints_(folder, settings), band_(&band) {}

void KeptBands::begin_task(std::size_t task) {
  task_ = task;
  parts_.clear();
  std::error_code error;
  for (const auto& entry : std::filesystem::directory_iterator(folder_, error)) {
    const std::string file = entry.path().filename().string();
    std::size_t of = 0;
    unsigned state = 0, first = 0, last = 0;
    if (std::sscanf(file.c_str(), "task%zu-state%u-rows%u-%u.", &of, &state, &first, &last) != 4) continue;
    const Part part{of, state, {first, last}, file.ends_with(".proved")};
    if (of == task && first < last && file == name(state, part.rows, part.proved)) parts_.push_back(part);
  }
  if (error) throw ltl::FormatError(folder_, 0, 0, "cannot be read: " + error.message());
}

std::string KeptBands::name(std::uint32_t state, RowRange rows, bool proved) const {
  return "task" + std::to_string(task_) + "-state" + std::to_string(state) + "-rows" + std::to_string(rows.first) +
         '-' + std::to_string(rows.last) + (proved ? ".proved" : ".values");
}

void KeptBands::keep_values(std::uint32_t state, std::span<const double> lower) const {
  std::string bytes;
  append(bytes, lower);
  checkpoints_.keep_text(name(state, band_->rows(), false), bytes);
}

void KeptBands::keep_proved(std::uint32_t state, std::span<const double> lower, std::span<const double> upper) const {
  std::string bytes;
  append(bytes, lower);
  append(bytes, upper);
  checkpoints_.keep_text(name(state, band_->rows(), true), bytes);
}

// take(row of the band, its lower bounds, its upper bounds): the own rows that the part has. Of a damaged part none.
template <class Take>
void KeptBands::for_each_row(const Part& part, const Take& take) const {
  const RowRange own = band_->rows();
  const std::uint32_t first = std::max(own.first, part.rows.first), last = std::min(own.last, part.rows.last);
  if (first >= last) return;
  const auto bytes = checkpoints_.find_text(name(part.state, part.rows, part.proved));
  const std::size_t width = band_->width(), size = part.rows.count() * width;
  if (!bytes || bytes->size() != (part.proved ? 2 : 1) * size * sizeof(double)) return;
  std::vector<double> values(bytes->size() / sizeof(double));
  std::memcpy(values.data(), bytes->data(), bytes->size());
  for (std::uint32_t y = first; y < last; ++y) {
    const double* lower = values.data() + (y - part.rows.first) * width;
    take(y - own.first, lower, lower + size);
  }
}

void KeptBands::find_values(std::uint32_t state, std::span<double> lower) const {
  const std::size_t width = band_->width();
  for (const Part& part : parts_)
    if (part.state == state)
      for_each_row(part, [&](std::uint32_t row, const double* found, const double*) {
        for (std::size_t x = 0; x < width; ++x) lower[row * width + x] = std::max(lower[row * width + x], found[x]);
      });
}

bool KeptBands::find_proved(std::uint32_t state, std::span<double> lower, std::span<double> upper) const {
  const std::size_t width = band_->width();
  std::vector<bool> covered(band_->rows().count(), false);
  for (const Part& part : parts_)
    if (part.state == state && part.proved)
      for_each_row(part, [&](std::uint32_t row, const double* below, const double* above) {
        for (std::size_t i = row * width, x = 0; x < width; ++i, ++x) {
          lower[i] = covered[row] ? std::max(lower[i], below[x]) : below[x];
          upper[i] = covered[row] ? std::min(upper[i], above[x]) : above[x];
        }
        covered[row] = true;
      });
  return std::all_of(covered.begin(), covered.end(), [](bool row) { return row; });
}

}  // namespace waymark::tools

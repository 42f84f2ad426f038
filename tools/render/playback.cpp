#include "tools/render/playback.hpp"

#include <algorithm>
#include <cmath>

#include "tools/render/svg.hpp"

namespace waymark::render {
namespace {

constexpr double seconds_per_unit = 1, seconds_per_turn = 1, rest = 1;
constexpr double step = 6;  // degrees between two frames

std::string key_time(double share) { return std::to_string(std::clamp(share, 0.0, 1.0)); }

}  // namespace

Playback::Playback(const plan::Motion& motion) {
  const std::vector<plan::Piece> pieces = plan::pieces_of(motion);
  frames_.push_back({.at = motion.configurations.front()});
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const plan::Piece& piece = pieces[i];
    const Frame from = frames_.back();
    const double turn = std::abs(piece.turn()), length = piece.length();
    const double seconds = std::max(length * seconds_per_unit, turn / 360 * seconds_per_turn);
    const int steps = std::max(1, static_cast<int>(std::ceil(turn / step)));
    for (int k = 1; k <= steps; ++k) {
      const double t = 1.0 * k / steps;
      frames_.push_back({static_cast<double>(i) + t, from.clock + t * seconds, from.travelled + t * length,
                         from.turned + t * piece.turn(), piece.at(t)});
    }
  }
}

double Playback::seconds() const { return frames_.back().clock + rest; }

double Playback::share(double time) const {
  const auto after = std::find_if(frames_.begin(), frames_.end(), [&](const Frame& f) { return f.time >= time; });
  if (after == frames_.end()) return frames_.back().clock / seconds();
  if (after == frames_.begin()) return 0;
  const Frame& before = *(after - 1);
  const double t = (time - before.time) / (after->time - before.time);
  return (before.clock + t * (after->clock - before.clock)) / seconds();
}

std::string Playback::timing() const { return "dur=\"" + number(seconds()) + "s\" repeatCount=\"indefinite\""; }

std::string Playback::moving(const std::string& name, const std::function<std::string(const Frame&)>& value) const {
  std::string values, times;
  for (const Frame& frame : frames_) {
    values += value(frame) + ';';
    times += key_time(frame.clock / seconds()) + ';';
  }
  return "attributeName=\"" + name + "\" values=\"" + values + value(frames_.back()) + "\" keyTimes=\"" + times +
         "1\" " + timing();
}

std::string Playback::switched(const std::string& name, const std::vector<Span>& spans, const std::string& on,
                               const std::string& off) const {
  std::string values = off, times = "0";
  for (const Span& span : spans) {
    values += ';' + on;
    times += ';' + key_time(share(span.from));
    if (span.to >= frames_.back().time) break;
    values += ';' + off;
    times += ';' + key_time(share(span.to));
  }
  return "attributeName=\"" + name + "\" calcMode=\"discrete\" values=\"" + values + "\" keyTimes=\"" + times + "\" " +
         timing();
}

}  // namespace waymark::render

// The clock of an animated motion: when the robot is where, as the key times and values of SMIL animations.
//
// Driving takes a second a unit, turning in place a second a turn; every animation of a page runs by this clock, so the
// robot, its trail and the states of the automaton keep in step. Arcs are followed in small steps.
#pragma once
#include <functional>
#include <string>
#include <vector>

#include "libplan/motion/motion.hpp"

namespace waymark::render {

struct Frame {
  double time = 0;       // of the motion: between the configurations i and i + 1 it runs from i to i + 1
  double clock = 0;      // seconds since the start
  double travelled = 0;  // by the centre, in units of the map
  double turned = 0;     // degrees since the start, not wrapped: an animation turns the way the robot did
  plan::Configuration at;
};

class Playback {
 public:
  explicit Playback(const plan::Motion& motion);
  const std::vector<Frame>& frames() const { return frames_; }  // the first is the start
  double seconds() const;
  double share(double time) const;  // of the whole, at that time of the motion

  // `attributeName="name" values="…" keyTimes="…" dur="…" repeatCount="indefinite"`, one value a frame.
  std::string moving(const std::string& name, const std::function<std::string(const Frame&)>& value) const;
  // The same for a value that is there from `from` to `to`, times of the motion, and another one before and after.
  std::string switched(const std::string& name, double from, double to, const std::string& on,
                       const std::string& off) const;

 private:
  std::string timing() const;
  std::vector<Frame> frames_;
};

}  // namespace waymark::render

/// @file
/// A world in which all bodies are on their way.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "contract/random.h"
#include "engines/stream/worlds.h"

namespace cellsweep::stream {

/// Bodies that keep their course until they meet a wall; body 0, 1, 2 ...
class Courses {
 public:
  Courses(std::size_t bodies, std::uint64_t seed) : random_(seed), boxes_(uniform_boxes(bodies, seed)) {
    for (std::size_t i = 0; i < 3 * bodies; ++i) steps_.push_back(random_.between(-0.04F, 0.04F));
    edge_ = 2 * std::cbrt(static_cast<float>(bodies));
  }

  const std::vector<Aabb>& boxes() const { return boxes_; }
  contract::Random& random() { return random_; }

  void go_on() {
    for (std::size_t i = 0; i < steps_.size(); ++i) {
      float& low = boxes_[i / 3].min[i % 3];
      float& high = boxes_[i / 3].max[i % 3];
      if (low < 0) steps_[i] = std::abs(steps_[i]);
      if (high > edge_) steps_[i] = -std::abs(steps_[i]);
      low += steps_[i];
      high += steps_[i];
    }
  }
  void turn(std::size_t body) {
    for (std::size_t axis = 0; axis < 3; ++axis) steps_[3 * body + axis] = random_.between(-0.04F, 0.04F);
  }
  void leap(std::size_t body) { boxes_[body] = cube_in(random_, random_.between(0.2F, 3), edge_); }

 private:
  contract::Random random_;
  std::vector<Aabb> boxes_;
  std::vector<float> steps_;
  float edge_ = 0;
};

}  // namespace cellsweep::stream

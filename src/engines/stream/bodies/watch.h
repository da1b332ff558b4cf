/// @file
/// Whether bodies are on their way or tremble, as a few of them tell that are watched for some updates.
#pragma once

#include <array>
#include <cstddef>

#include "base/tuning.h"
#include "cellsweep/engine/engine.h"

namespace cellsweep::stream {

/// Whether at least half of the bodies move in this update.
inline bool do_most_move(const BodyChanges& changes) {
  return 2 * changes.moved.size() >= changes.bodies;
}

class Watch {
 public:
  /// Chooses bodies among those that move in this update, and sees them for the first time.
  [[gnu::cold]] void begin(const BodyChanges& changes);

  /// Sees them again, in each update that follows. False when one of them is not there any more: then
  /// begin() is to follow.
  bool see(const BodyChanges& changes);

  /// Whether at least half of them are not on their way: they stopped, or go to and fro.
  [[gnu::cold]] bool most_stay() const;

 private:
  struct Body {
    Slot slot = 0;
    Aabb box{};    // where it was last
    Aabb reach{};  // encloses where it has been
    float way = 0;
  };

  static void follow(Body& body, const Aabb& now);
  static bool stays(const Body& body);

  std::size_t count_ = 0;
  std::array<Body, tuning::kWatched> bodies_;
};

}  // namespace cellsweep::stream

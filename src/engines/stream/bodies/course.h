/// @file
/// The course of a body, as its fat boxes tell.
#pragma once

#include <cstdint>

#include "cellsweep/aabb.h"
#include "engines/stream/bodies/growth.h"

namespace cellsweep::stream {

/// What the next fat box of a body is made for.
struct NextFatBox {
  std::uint32_t update;  ///< that makes it
  float updates;         ///< in which a body that is on its way keeps its course
  float margin;          ///< on all sides
  const Growth& growth;
};

/// Whether a body is on its way or trembles, and how far its fat boxes reach to either side then.
class Course {
 public:
  Course() = default;
  /// Of a body whose fat box lasts since long before this update.
  static Course of_long_ago(std::uint32_t update);

  bool trembles() const { return trembles_; }

  /// The fat box in place of `fat`, which the body left by moving from `before` to `now`, or did not leave.
  [[gnu::noinline]] Aabb next_fat_box(const Aabb& fat, const Aabb& before, const Aabb& now, bool left,
                                      const NextFatBox& next);

 private:
  static constexpr unsigned kUpdates = 128;

  [[gnu::cold]] void judge(unsigned age, float step, const Growth& growth);

  std::uint8_t made_ : 7 = 0;  // the update that made the fat box, modulo kUpdates
  bool trembles_ : 1 = false;
  std::uint8_t halvings_ = 0;  // of how far the fat box of one that trembles reaches to either side
};

}  // namespace cellsweep::stream

/// @file
/// Small worlds in which most bodies move: they are swept in every update.
#pragma once

#include <cstdint>

#include "cellsweep/engine/engine.h"
#include "engines/stream/bodies/watch.h"

namespace cellsweep::stream {

/// To find all pairs of a small world anew, by a sweep of its boxes, takes less than fat boxes save where
/// most bodies are on their way; and each update takes as long as the one before. Where they tremble or
/// stop, fat boxes last, and then an update takes less with them. Some bodies, watched for some updates,
/// tell.
class SmallWorld {
 public:
  /// A world that cannot be swept, or is to have fat boxes whatever its bodies do, is not a small one.
  explicit SmallWorld(bool may_be_swept) : may_be_swept_(may_be_swept) {}

  /// An update begins, of which some change is known. True when it is to find everything anew, without fat
  /// boxes.
  bool begin_update(const BodyChanges& changes);

  /// An update with fat boxes has found everything anew: they did not last.
  void note_full();
  /// A sweep would have taken more than cells: fat boxes are to be tried.
  void give_up();

 private:
  bool has_much_motion(const BodyChanges& changes) const;
  void watch(const BodyChanges& changes);

  bool may_be_swept_;
  bool is_swept_ = true;      // as long as nobody moved, nothing speaks for fat boxes
  bool much_motion_ = false;  // in this update
  std::uint32_t rests_ = 0;   // updates that fat boxes are given to prove themselves
  std::uint32_t seen_ = 0;    // updates in which bodies are watched; 0: none is
  Watch watch_;
};

}  // namespace cellsweep::stream

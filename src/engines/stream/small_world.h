/// @file
/// Small worlds in which most bodies move: they are swept in every update.
#pragma once

#include <cstddef>
#include <cstdint>

#include "cellsweep/engine/engine.h"
#include "engines/stream/bodies/watch.h"

namespace cellsweep::stream {

/// What an update with fat boxes had to do.
struct FatBoxWork {
  std::size_t bodies = 0;
  bool is_full = false;    ///< all fat boxes were put into cells
  std::size_t placed = 0;  ///< else so many
  std::size_t candidates = 0;
  std::size_t pairs = 0;
};

/// To find all pairs of a small world anew, by a sweep of its boxes, takes less than fat boxes save where
/// most bodies are on their way; and each update takes as long as the one before. Where they tremble or
/// stop, fat boxes last, and then an update takes less with them. Some bodies, watched for some updates,
/// tell whether to try fat boxes; what these have to do then tells whether they last.
class SmallWorld {
 public:
  /// A world that cannot be swept, or is to have fat boxes whatever its bodies do, is not a small one.
  explicit SmallWorld(bool may_be_swept) : may_be_swept_(may_be_swept) {}

  /// An update begins, of which some change is known. True when it is to find everything anew, without fat
  /// boxes.
  bool begin_update(const BodyChanges& changes);

  /// An update with fat boxes has ended.
  void note(const FatBoxWork& work);
  /// A sweep would have taken more than cells: there are fat boxes for some time.
  void give_up();

 private:
  bool has_much_motion(const BodyChanges& changes) const;
  void watch(const BodyChanges& changes);
  [[gnu::cold]] void try_fat_boxes();
  [[gnu::cold]] void judge();

  bool may_be_swept_;
  bool is_swept_ = true;        // as long as nobody moved, nothing speaks for fat boxes
  bool much_motion_ = false;    // in this update
  std::uint32_t seen_ = 0;      // updates in which bodies are watched; 0: none is
  std::uint32_t pause_ = 0;     // updates that are not swept, whatever they take
  std::uint32_t settling_ = 0;  // updates at most before what fat boxes have to do counts
  std::uint32_t judged_ = 0;    // updates that count so far,
  std::int64_t excess_ = 0;     // and what they took more than sweeps would have
  std::uint32_t lasted_ = 0;    // so many times in a row that was less than nothing
  std::uint32_t stays_ = 0;     // so many times in a row most of those watched stayed,
  std::uint32_t patience_ = 1;  // of so many, after which fat boxes are tried
  Watch watch_;
};

}  // namespace cellsweep::stream

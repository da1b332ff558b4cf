/// @file
/// Worlds in which most bodies move: with fat boxes, or without.
#pragma once

#include <cstddef>
#include <cstdint>

#include "base/threads/crew.h"
#include "cellsweep/engine/engine.h"
#include "engines/stream/bodies/fat_box_trial.h"
#include "engines/stream/bodies/watch.h"
#include "engines/stream/choices/fat_box_work.h"

namespace cellsweep::stream {

/// Fat boxes save work in the next updates and make more of it in the one that makes them. Where they do not
/// last, as in a heap into which bodies still fall, it takes less to find all pairs of the boxes themselves
/// anew in each update. What fat boxes have to do, eight updates at a time, tells whether they last;
/// nobody waits for that while pairs begin and end, and so many candidates are there that to look at these
/// alone takes nearly as long as to find all anew.
///
/// Small worlds begin without: to sweep them takes not much longer than fat boxes while most bodies are on
/// their way, each update as long as the one before, and no more memory than there is. Where bodies tremble
/// or stop, fat boxes last. Some bodies, watched for some updates, tell whether to try them. Large worlds,
/// which fat boxes suit better, begin with them; while such a world does without, some bodies have them on
/// trial. Some thousand bodies are swept then, which takes less than to make cells.
class FatBoxChoice {
 public:
  /// Whether there may be none; and whether small worlds can be swept.
  FatBoxChoice(bool may_go_without, bool can_sweep)
      : may_go_without_(may_go_without), can_sweep_(can_sweep) {}

  /// An update begins, of which some change is known. True when it is to find everything anew, without fat
  /// boxes.
  bool begin_update(Crew& crew, const BodyChanges& changes);

  /// An update with fat boxes has ended.
  [[gnu::noinline]] void note(const FatBoxWork& work);
  /// Everything was found anew, with cells or by a sweep. A small world has fat boxes for some time where
  /// that took cells.
  void note_anew(bool has_cells);

 private:
  void note_size(std::size_t slots);
  [[gnu::cold]] void watch(const BodyChanges& changes);
  [[gnu::cold]] void go_on_with_trial(Crew& crew, const BodyChanges& changes);
  std::int64_t cost_of_fat_boxes(const FatBoxWork& work) const;
  std::uint64_t cost_of_placing(const FatBoxWork& work) const;
  std::int64_t cost_anew(const FatBoxWork& work) const;
  [[gnu::cold]] void try_fat_boxes();
  [[gnu::cold]] void judge();
  [[gnu::cold]] void go_without();

  bool may_go_without_;
  bool can_sweep_;
  bool is_swept_ = true;  // where it does without
  bool is_small_ = true;
  bool is_without_ = true;      // a small world, as long as nobody moved
  bool is_tried_ = false;       // by some bodies of a large world
  bool much_motion_ = false;    // in this update
  std::uint32_t seen_ = 0;      // updates in which bodies are watched; 0: none is
  std::uint32_t pause_ = 0;     // updates that are not swept, whatever they take
  std::uint32_t settled_ = 0;   // updates so far in which what fat boxes have to do does not count
  std::uint32_t judged_ = 0;    // updates that count so far,
  std::int64_t excess_ = 0;     // and what they took more than without fat boxes
  std::uint32_t lasted_ = 0;    // so many times in a row that was less than nothing
  std::uint32_t stays_ = 0;     // so many times in a row most of those watched stayed,
  std::uint32_t patience_ = 1;  // of so many, after which fat boxes are tried
  Watch watch_;
  FatBoxTrial trial_;
};

}  // namespace cellsweep::stream

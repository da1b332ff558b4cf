/// @file
/// The arrays of one axis in the local store, allocated as long as a frame lasts (C14).
#pragma once

#include <cstdint>

#include "engines/cell/spu/paper/change_detection.h"
#include "engines/cell/spu/paper/overlap_walk.h"
#include "engines/cell/wire.h"

namespace cellsweep::cell::paper {

/// Which arrays there are depends on the job; null pointers stand for the others.
class AxisStore {
 public:
  explicit AxisStore(const PaperJob& job);
  ~AxisStore();
  AxisStore(const AxisStore&) = delete;
  AxisStore& operator=(const AxisStore&) = delete;

  std::uint32_t count() const { return count_; }
  std::uint32_t vectors() const { return count_ / kLanes; }

  /// C2, C4: fetches the arrays from main memory and waits for them.
  void get(const PaperJob& job, unsigned int tag);

  /// C9: the arrays as they come are kept beside those that will be sorted.
  void keep_copies();

  BeforeAndAfter before_and_after() const { return {values_before, values, ids, count_}; }

  float* values;
  std::uint32_t* ids;
  float* values_before;
  std::uint32_t* ids_before;  ///< after C9 the changed IDs
  float* body_values;         ///< method 2
  Place* places;              ///< method 1, exact

 private:
  std::uint32_t count_;
};

}  // namespace cellsweep::cell::paper

/// @file
/// One axis of cell-paper in main memory: what goes to its SPU and what comes back (C2, C3).
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "cellsweep/aabb.h"
#include "engines/cell/ppu/dma_memory.h"
#include "engines/cell/ppu/key_memory.h"
#include "engines/cell/wire.h"

namespace cellsweep::cell {

/// Endpoint arrays of one axis. IDs are place + 1, so boxes are looked up at ID − 1.
class PaperAxis {
 public:
  PaperAxis(std::size_t axis, std::uint32_t flags) : axis_(axis), flags_(flags) {}

  /// C2: new arrays for the bodies in `places`, in that order, as the SPU's first frame wants them.
  void rebuild(std::span<const std::uint32_t> places, std::span<const Aabb> boxes);

  /// C3, Listing 4.6: the values of this frame in the order of the last one's sorted IDs; a `met` flag tells
  /// a body's minimum from its maximum.
  void refill(std::span<const Aabb> boxes);

  /// C12: the values in body order, for method 2; bodies not in `places` get a minimum above all values.
  void fill_body_values(std::span<const std::uint32_t> places, std::span<const Aabb> boxes);

  /// The SPU's orders for the next frame. The addresses hold until the next rebuild().
  PaperJob* make_job(bool initial);

  /// What the SPU sent in the frame before: IDs that changed, keys of pairs that overlap and that do not.
  std::span<const std::uint32_t> changed() const { return {changed_.data(), result_[0].changed}; }
  std::span<const std::uint32_t> keys() const { return {keys_.data(), result_[0].keys}; }
  std::span<const std::uint32_t> apart_keys() const { return {apart_keys_.data(), result_[0].apart_keys}; }

  /// The ID words in the order of the sorted values, with padding.
  std::span<const std::uint32_t> ids() const { return ids_; }

 private:
  bool has(PaperFlags flag) const { return (flags_ & flag) != 0; }
  void make_room_for_keys(std::uint64_t bodies);

  std::size_t axis_;
  std::uint32_t flags_;
  DmaVector<float> values_;
  DmaVector<std::uint32_t> ids_;  // in, and sorted out
  DmaVector<float> body_values_;
  DmaVector<std::uint32_t> changed_;
  KeyMemory keys_;
  KeyMemory apart_keys_;
  DmaVector<PaperResult> result_ = DmaVector<PaperResult>(1);
  DmaVector<PaperJob> job_ = DmaVector<PaperJob>(1);
  std::vector<bool> met_;  // by ID
};

}  // namespace cellsweep::cell

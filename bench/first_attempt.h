/// @file
/// The document's first attempt (F5): the x86 insertion sort on three SPUs.
#pragma once

#include <array>
#include <memory>
#include <span>
#include <vector>

#include "cellsweep/aabb.h"
#include "engines/cell/ppu/dma_memory.h"
#include "engines/cell/ppu/key_memory.h"
#include "engines/cell/ppu/spe_group.h"

namespace cellsweep::bench {

/// A fixed set of bodies, all entered at once. No engine: it has no pair manager, only what tells its results
/// right.
class FirstAttempt {
 public:
  /// Errors: spe_failed.
  static Result<std::unique_ptr<FirstAttempt>> make(std::size_t bodies);

  /// A frame: copies what the endpoints' pointers lead to, sorts on the SPUs, takes back endpoints and
  /// events. `boxes` as many as bodies. Errors: spe_failed.
  Status run(std::span<const Aabb> boxes);

  /// Applies the events of the last frame and counts the pairs that overlap on all axes.
  std::size_t count_pairs();

  /// Of the last frame.
  std::size_t events() const;

 private:
  struct Axis {
    cell::DmaVector<cell::FirstAttemptEndpoint> endpoints;
    cell::KeyMemory events;
    cell::DmaVector<std::uint32_t> result = cell::DmaVector<std::uint32_t>(32);
    cell::DmaVector<cell::FirstAttemptJob> job = cell::DmaVector<cell::FirstAttemptJob>(1);
    std::vector<bool> overlaps;  // by key of two IDs
  };

  FirstAttempt(std::size_t bodies, std::unique_ptr<cell::SpeGroup> spes);
  void copy_values(std::size_t axis, std::span<const Aabb> boxes);

  std::size_t bodies_;
  std::unique_ptr<cell::SpeGroup> spes_;
  std::array<Axis, 3> axes_;
};

}  // namespace cellsweep::bench

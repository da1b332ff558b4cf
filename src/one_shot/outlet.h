/// @file
/// Where the pairs of a one-shot search go: into a list, a number, or a visitor of the caller's.
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <span>

#include "base/tuning.h"
#include "cellsweep/engine/cell_boxes.h"
#include "cellsweep/pair.h"
#include "engines/stream/cells/keys.h"
#include "one_shot/box_set.h"

namespace cellsweep::one_shot {

/// Thrown where far more pairs of rounded boxes are found than overlap.
struct TooManyCandidates {};

/// Thrown where a visitor has seen enough.
struct SeenEnough {};

/// What all outlets of a search know and count together.
struct Found {
  const SearchedBoxes* boxes = nullptr;
  const ExactBox* exact = nullptr;  ///< by place; what is found is tested by them, unless they are null
  std::uint64_t most_pairs = ~std::uint64_t{0};       ///< more are TooManyPairs
  std::uint64_t most_candidates = ~std::uint64_t{0};  ///< that overlap nothing; more than these, and than
                                                      ///< there are pairs, are TooManyCandidates
  std::atomic<std::uint64_t> pairs = 0;
  std::atomic<std::uint64_t> candidates = 0;  ///< that overlap nothing
};

/// One worker's. Kernels write keys of slots into it; those of places leave it, the second set's counted from
/// its own first box on.
class Outlet : public stream::KeyBuffer {
 public:
  explicit Outlet(Found& found);
  Outlet(const Outlet&) = delete;
  Outlet& operator=(const Outlet&) = delete;
  virtual ~Outlet() = default;

  /// Hands on what was written.
  void flush();

  /// As if the kernels had written them.
  void write(std::span<const std::uint64_t> slot_keys);

 protected:
  /// Takes pairs and says how many of them: all, or it throws.
  virtual void take(std::span<const std::uint64_t> place_keys) = 0;

  Found& found_;

 private:
  static constexpr std::size_t kRoom = 4096;  // what a kernel asks for at once fits

  std::size_t translate();

  std::uint64_t room_[kRoom];  // NOLINT(*-c-arrays)
};

/// Keeps them.
class ListOutlet final : public Outlet {
 public:
  using Outlet::Outlet;
  std::span<const std::uint64_t> view() const { return keys_.view(); }

 protected:
  void take(std::span<const std::uint64_t> place_keys) override;

 private:
  stream::Keys keys_;
};

/// Keeps nothing: Found counts.
class CountOutlet final : public Outlet {
 public:
  using Outlet::Outlet;

 protected:
  void take(std::span<const std::uint64_t>) override {}
};

}  // namespace cellsweep::one_shot

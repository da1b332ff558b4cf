/// @file
/// The overlapping pairs of a set of boxes by Embree's tree against itself.
#pragma once

#include <embree3/rtcore.h>

#include <atomic>
#include <cstdint>
#include <memory>
#include <span>
#include <type_traits>
#include <vector>

#include "base/process.h"
#include "cellsweep/aabb.h"

namespace cellsweep::embree {

/// A tree over boxes, built anew by each find_pairs(). One thread at a time; inside, Embree uses its own.
class Collider {
 public:
  /// As many threads as asked for at most; 0: one for each core. Throws std::bad_alloc when Embree has no
  /// memory for itself.
  explicit Collider(unsigned threads);
  ~Collider();
  Collider(const Collider&) = delete;
  Collider& operator=(const Collider&) = delete;

  /// Builds the tree over boxes by slot that are canonical and valid, or kNobody: these Embree leaves out.
  /// Throws std::bad_alloc.
  void build(std::span<const Aabb> boxes);

  /// The pair_key() of every overlapping pair of the boxes that build() was given, which must still be there:
  /// exactly those, each once, in any order. Valid until the next call. Throws std::bad_alloc.
  std::span<const std::span<const std::uint64_t>> find_pairs();

  /// Pairs that Embree has named, over the life of the object: twice each one that overlaps, and the near
  /// misses.
  std::uint64_t candidates() const { return candidates_; }

  /// Memory held, without Embree's.
  std::size_t bytes() const;

 private:
  struct Bin;
  template <class Handle, void (*Release)(Handle)>
  struct Releaser {
    void operator()(Handle handle) const { Release(handle); }
  };
  using Device = std::unique_ptr<std::remove_pointer_t<RTCDevice>, Releaser<RTCDevice, rtcReleaseDevice>>;
  using Scene = std::unique_ptr<std::remove_pointer_t<RTCScene>, Releaser<RTCScene, rtcReleaseScene>>;
  using Geometry =
      std::unique_ptr<std::remove_pointer_t<RTCGeometry>, Releaser<RTCGeometry, rtcReleaseGeometry>>;

  static void tell_bounds(const RTCBoundsFunctionArguments* arguments);
  static void take_candidates(void* collider, RTCCollision* candidates, unsigned count);
  void keep_overlapping(std::span<const RTCCollision> candidates, Bin& bin) const;
  void throw_if_out_of_memory();

  ProcessMark process_;
  Device device_;
  Scene scene_;
  Geometry geometry_;
  std::span<const Aabb> boxes_;
  std::vector<Bin> bins_;
  std::vector<std::span<const std::uint64_t>> found_;  // by bin
  std::uint64_t candidates_ = 0;
  bool has_failed_ = false;                   // Embree said so
  std::atomic<bool> has_lost_pairs_ = false;  // some thread had no memory for them
};

}  // namespace cellsweep::embree

/// @file
/// A box to be looked for, as walks through cells want it.
#pragma once

#include <cstddef>
#include <cstring>

#include "cellsweep/aabb.h"
#include "geometry/box_lanes.h"

namespace cellsweep::queries {

/// A box, canonical: its six numbers, and the first four and the last four of them in vectors.
///
/// What has just been stored a processor hands to a load that lies in one store whole, and compilers copy a
/// box by sixteen and by eight bytes. So it is read and written here; to wait for the memory instead took a
/// fifth of a point's time (EPYC).
class RegionBox {
 public:
  explicit RegionBox(const Aabb& box) {
    Float4 first_four;
    double last_two = 0;
    std::memcpy(&first_four, &box, kFirst);
    std::memcpy(&last_two, reinterpret_cast<const char*>(&box) + kFirst, kLast);
    const auto behind = reinterpret_cast<Float4>(Double2{last_two, 0});
    first_four_ = canonical(first_four);
    last_four_ = canonical(__builtin_shufflevector(first_four, behind, 2, 3, 4, 5));
    const double last = reinterpret_cast<Double2>(last_four_)[1];
    auto* const to = reinterpret_cast<char*>(&box_);
    std::memcpy(to, &first_four_, kFirst);
    std::memcpy(to + kFirst, &last, kLast);
  }

  const Aabb& box() const { return box_; }
  Float4 first_four() const { return first_four_; }
  Float4 last_four() const { return last_four_; }

 private:
  using Double2 [[gnu::vector_size(16)]] = double;
  static constexpr std::size_t kFirst = sizeof(Float4);
  static constexpr std::size_t kLast = sizeof(Aabb) - kFirst;
  static_assert(kLast == sizeof(double));

  Float4 first_four_;
  Float4 last_four_;
  Aabb box_;  // NOLINT(*-member-init): the constructor writes it
};

}  // namespace cellsweep::queries

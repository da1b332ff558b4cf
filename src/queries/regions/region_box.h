/// @file
/// A box to be looked for, as walks through cells want it.
#pragma once

#include <cstddef>
#include <cstring>

#include "cellsweep/aabb.h"
#include "geometry/box_lanes.h"

namespace cellsweep::queries {

/// A box, canonical: its six numbers, and the first four and the last four of them in vectors. Written by
/// sixteen and by eight bytes, as compilers copy a box: BoxNumbers says what else that would take.
class RegionBox {
 public:
  explicit RegionBox(const Aabb& box) {
    const BoxNumbers numbers = BoxNumbers::just_written(box);
    first_four_ = canonical(numbers.first_four);
    last_four_ = canonical(numbers.last_four);
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

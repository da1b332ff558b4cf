/// @file
/// Which boxes of a cell one box overlaps.
#pragma once

#include <cstddef>
#include <cstdint>

#include "cellsweep/engine/cell_boxes.h"
#include "queries/kernels/lanes.h"

namespace cellsweep::queries {
namespace {

/// As many boxes of a cell as there are lanes, side by side.
template <class Lanes>
class TestInCell {
 public:
  static constexpr std::uint32_t kBoxes = Lanes::kCount;

  explicit TestInCell(const Aabb& box) : lanes_(box) {}

  /// A bit for each that overlaps.
  std::uint64_t test(const stream::TaggedBox* boxes) const {
    VectorOf<Lanes> faces[6];
    Lanes::gather(reinterpret_cast<const std::byte*>(boxes), sizeof(*boxes), kBoxes, faces);
    return lanes_.test(faces);
  }

 private:
  OverlapLanes<Lanes> lanes_;
};

/// How many of 64 boxes overlap nobody could foretell, but once: their bits are gathered before any is looked
/// at.
template <class InCell>
std::uint32_t find_overlaps_in_cell(const stream::TaggedBox* boxes, std::uint32_t count, const Aabb& box,
                                    std::uint32_t flags, std::uint32_t* slots) {
  constexpr std::uint32_t kBits = 64;
  const InCell tester(box);
  std::uint32_t found = 0;
  for (std::uint32_t first = 0; first < count; first += kBits) {
    const stream::TaggedBox* const here = boxes + first;
    const std::uint32_t there = count - first < kBits ? count - first : kBits;
    std::uint64_t bits = 0;
    for (std::uint32_t i = 0; i < there; i += InCell::kBoxes) bits |= tester.test(here + i) << i;
    bits &= ~std::uint64_t{0} >> (kBits - there);
    for (; bits != 0; bits &= bits - 1) {
      const std::uint32_t tag = here[__builtin_ctzll(bits)].tag;
      slots[found] = tag & kSlotMask;
      found += (tag >> kSlotBits | flags) == stream::kWholeFlags ? 1 : 0;
    }
  }
  return found;
}

}  // namespace
}  // namespace cellsweep::queries

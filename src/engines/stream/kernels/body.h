/// @file
/// The kernels for any vector: `Lanes` says how wide it is, gathers, broadcasts and compares.
///
/// Whatever kernels call has internal linkage, here and in the other headers of this folder, and nothing of
/// it is the standard library's. Of an inline function that several source files have, a member of std::array
/// for example, the linker keeps one copy for the whole program, and must not choose one that was compiled
/// for a larger instruction set: processors without that would stop there. Optimised builds seldom show it,
/// because they put most calls in line; tests look at what the object files export.
#pragma once

#include "engines/stream/kernels/faces.h"
#include "engines/stream/kernels/kernel.h"

namespace cellsweep::stream {
namespace {

/// `Lanes::kCount` boxes side by side, to be compared with one other at a time. At least one is `there`; of
/// sixteen only the first eight are read where no more are.
template <class Lanes>
class Block {
 public:
  Block(const TaggedBox* boxes, std::uint32_t there) { Lanes::gather(boxes, there, faces_); }

  /// Which of them a box overlaps, a bit each.
  std::uint32_t hits(const Aabb& box) const {
    const float* const face = faces_of(box);
    auto all = Lanes::less_equal(faces_[0], Lanes::broadcast(face + 3));
    all = Lanes::both(all, Lanes::less_equal(Lanes::broadcast(face), faces_[3]));
    all = Lanes::both(all, Lanes::less_equal(faces_[1], Lanes::broadcast(face + 4)));
    all = Lanes::both(all, Lanes::less_equal(Lanes::broadcast(face + 1), faces_[4]));
    all = Lanes::both(all, Lanes::less_equal(faces_[2], Lanes::broadcast(face + 5)));
    all = Lanes::both(all, Lanes::less_equal(Lanes::broadcast(face + 2), faces_[5]));
    return Lanes::bits(all);
  }

 private:
  typename Lanes::Vector faces_[6];
};

inline bool owns(std::uint32_t tag, std::uint32_t other) {
  return (tag | other) >> kSlotBits == kWholeFlags;
}

inline std::uint64_t key_of(std::uint32_t tag, std::uint32_t other) {
  const std::uint64_t a = tag & kSlotMask;
  const std::uint64_t b = other & kSlotMask;
  return a < b ? a << 32 | b : b << 32 | a;
}

/// A bit for each lane below `count`.
template <class Lanes>
std::uint32_t lanes_below(std::uint32_t count) {
  return count >= Lanes::kCount ? (1U << Lanes::kCount) - 1 : (1U << count) - 1;
}

/// A box and the boxes of a block that it overlaps.
struct Hits {
  std::uint32_t place;
  std::uint32_t lanes;
};

/// So many boxes are compared with a block before the hits are looked at: no branch depends on a comparison.
inline constexpr std::uint32_t kStrip = 128;

inline void add_pairs(const Hits* hits, std::size_t count, const TaggedBox* boxes, std::uint32_t first,
                      KeyBuffer& found) {
  std::uint64_t* key = found.keys + found.size;
  for (std::size_t h = 0; h < count; ++h) {
    const std::uint32_t tag = boxes[hits[h].place].tag;
    for (std::uint32_t lanes = hits[h].lanes; lanes != 0; lanes &= lanes - 1) {
      const std::uint32_t other = boxes[first + static_cast<unsigned>(__builtin_ctz(lanes))].tag;
      *key = key_of(tag, other);
      key += owns(tag, other) ? 1 : 0;
    }
  }
  found.size = static_cast<std::size_t>(key - found.keys);
}

template <class Lanes>
void all_pairs(const CellBoxes& cell, std::uint32_t rows, KeyBuffer& found) {
  // Copies: what is written to `hits` must not look like a change of these.
  const TaggedBox* const boxes = cell.boxes;
  const std::uint32_t end_of_cell = cell.count;
  Hits hits[kStrip];
  for (std::uint32_t first = 0; first < end_of_cell; first += Lanes::kCount) {
    const Block<Lanes> block(boxes + first, end_of_cell - first);
    const std::uint32_t there = lanes_below<Lanes>(end_of_cell - first);
    const std::uint32_t end = first + Lanes::kCount < rows ? first + Lanes::kCount : rows;
    for (std::uint32_t strip = 0; strip < end; strip += kStrip) {
      const std::uint32_t strip_end = strip + kStrip < end ? strip + kStrip : end;
      std::size_t count = 0;
      for (std::uint32_t i = strip; i < strip_end; ++i) {
        // Boxes of the block itself, each with those behind it only.
        const std::uint32_t behind = i < first ? 0 : i + 1 - first;
        hits[count] = {i, block.hits(boxes[i].box) & there & (~0U << behind)};
        count += hits[count].lanes != 0 ? 1 : 0;
      }
      make_room(found, count * Lanes::kCount);
      add_pairs(hits, count, boxes, first, found);
    }
  }
}

template <class Lanes>
void partners(const CellBoxes& cell, const TaggedBox& box, KeyBuffer& slots) {
  for (std::uint32_t first = 0; first < cell.count; first += Lanes::kCount) {
    const Block<Lanes> block(cell.boxes + first, cell.count - first);
    make_room(slots, Lanes::kCount);
    std::uint32_t lanes = block.hits(box.box) & lanes_below<Lanes>(cell.count - first);
    for (; lanes != 0; lanes &= lanes - 1) {
      const std::uint32_t other = cell.boxes[first + static_cast<unsigned>(__builtin_ctz(lanes))].tag;
      slots.keys[slots.size] = other & kSlotMask;
      slots.size += owns(box.tag, other) ? 1 : 0;
    }
  }
}

/// `eight_rows` and `sweep` are null where there are no vectors of bytes.
template <class Lanes>
constexpr Kernels make_kernels(VectorIsa isa, const char* name,
                               decltype(Kernels::eight_rows) eight_rows = nullptr,
                               decltype(Kernels::sweep) sweep = nullptr) {
  static_assert(Lanes::kCount <= kMaxLanes);
  return {isa,        name, Lanes::kCount, Lanes::kEightBlocks, all_pairs<Lanes>, partners<Lanes>,
          eight_rows, sweep};
}

}  // namespace
}  // namespace cellsweep::stream

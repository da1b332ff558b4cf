/// @file
/// The kernels for any vector: `Lanes` says how wide it is, loads, broadcasts and compares.
///
/// Everything here has internal linkage and calls nothing of the standard library that is not in the header's
/// own lines: the linker must not choose a function that was compiled for a larger instruction set.
#pragma once

#include "engines/stream/kernel.h"

namespace cellsweep::stream {
namespace {

/// `Lanes::kCount` boxes side by side, to be compared with one other at a time.
template <class Lanes>
class Block {
 public:
  Block(const CellBoxes& cell, std::uint32_t first) {
    for (unsigned face = 0; face < 6; ++face) faces_[face] = Lanes::load(cell.faces(face) + first);
  }

  /// Which of them the box at `place` overlaps, a bit each.
  std::uint32_t hits(const float* place, std::size_t step) const {
    auto all = Lanes::less_equal(faces_[0], Lanes::broadcast(place + 3 * step));
    all = Lanes::both(all, Lanes::less_equal(Lanes::broadcast(place), faces_[3]));
    all = Lanes::both(all, Lanes::less_equal(faces_[1], Lanes::broadcast(place + 4 * step)));
    all = Lanes::both(all, Lanes::less_equal(Lanes::broadcast(place + step), faces_[4]));
    all = Lanes::both(all, Lanes::less_equal(faces_[2], Lanes::broadcast(place + 5 * step)));
    all = Lanes::both(all, Lanes::less_equal(Lanes::broadcast(place + 2 * step), faces_[5]));
    return Lanes::bits(all);
  }

 private:
  typename Lanes::Vector faces_[6];
};

inline bool owns(std::uint32_t tag, std::uint32_t other) {
  return (tag | other) >> kSlotBits == kWholeFlags;
}

inline std::uint64_t key_of(std::uint32_t tag, std::uint32_t other, const BodyId* ids) {
  std::uint64_t a = tag & kSlotMask;
  std::uint64_t b = other & kSlotMask;
  if (ids != nullptr) {
    a = ids[a];
    b = ids[b];
  }
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
constexpr std::uint32_t kStrip = 128;

inline void add_pairs(const Hits* hits, std::size_t count, const std::uint32_t* tags, std::uint32_t first,
                      const BodyId* ids, KeyBuffer& found) {
  for (std::size_t h = 0; h < count; ++h) {
    const std::uint32_t tag = tags[hits[h].place];
    for (std::uint32_t lanes = hits[h].lanes; lanes != 0; lanes &= lanes - 1) {
      const std::uint32_t other = tags[first + static_cast<unsigned>(__builtin_ctz(lanes))];
      found.keys[found.size] = key_of(tag, other, ids);
      found.size += owns(tag, other) ? 1 : 0;
    }
  }
}

template <class Lanes>
void all_pairs(const CellBoxes& cell, const BodyId* ids, KeyBuffer& found) {
  // Copies: what is written to `hits` must not look like a change of these.
  const float* const boxes = cell.arrays;
  const std::size_t step = cell.capacity;
  const std::uint32_t end_of_cell = cell.count;
  Hits hits[kStrip];
  for (std::uint32_t first = 0; first < end_of_cell; first += Lanes::kCount) {
    const Block<Lanes> block(cell, first);
    const std::uint32_t there = lanes_below<Lanes>(end_of_cell - first);
    const std::uint32_t end = first + Lanes::kCount < end_of_cell ? first + Lanes::kCount : end_of_cell;
    for (std::uint32_t strip = 0; strip < end; strip += kStrip) {
      const std::uint32_t strip_end = strip + kStrip < end ? strip + kStrip : end;
      const std::uint32_t before_end = strip_end < first ? strip_end : first;
      std::size_t count = 0;
      std::uint32_t i = strip;
      for (; i < before_end; ++i) {
        hits[count] = {i, block.hits(boxes + i, step) & there};
        count += hits[count].lanes != 0 ? 1 : 0;
      }
      for (; i < strip_end; ++i) {  // boxes of the block itself, each with those behind it
        hits[count] = {i, block.hits(boxes + i, step) & there & ~0U << (i - first) << 1};
        count += hits[count].lanes != 0 ? 1 : 0;
      }
      found.need(count * Lanes::kCount);
      add_pairs(hits, count, cell.tags(), first, ids, found);
    }
  }
}

/// Notes what became of one pair, `old` and `now` saying whether the boxes overlapped.
inline void note_change(bool old, bool now, std::uint64_t key, const KeyChanges& changes) {
  if (old == now) return;
  KeyBuffer& buffer = now ? changes.began : changes.ended;
  buffer.need(1);
  buffer.keys[buffer.size++] = key;
}

template <class Lanes>
void changed_pairs(const CellBoxes& old, const CellBoxes& now, std::span<const std::uint32_t> changed,
                   const std::uint32_t* rank, const BodyId* ids, const KeyChanges& changes) {
  const std::uint32_t* old_tags = old.tags();
  const std::uint32_t* now_tags = now.tags();
  for (std::uint32_t first = 0; first < now.count; first += Lanes::kCount) {
    const Block<Lanes> was(old, first);
    const Block<Lanes> is(now, first);
    const std::uint32_t there = lanes_below<Lanes>(now.count - first);
    for (std::size_t c = 0; c < changed.size(); ++c) {
      const std::uint32_t place = changed.data()[c];
      const std::uint32_t before = was.hits(old.arrays + place, old.capacity) & there;
      const std::uint32_t after = is.hits(now.arrays + place, now.capacity) & there;
      for (std::uint32_t any = before | after; any != 0; any &= any - 1) {
        const auto lane = static_cast<unsigned>(__builtin_ctz(any));
        const std::uint32_t other = first + lane;
        if (rank[other] <= c) continue;
        note_change((before >> lane & 1) != 0 && owns(old_tags[place], old_tags[other]),
                    (after >> lane & 1) != 0 && owns(now_tags[place], now_tags[other]),
                    key_of(now_tags[place], now_tags[other], ids), changes);
      }
    }
  }
}

template <class Lanes>
constexpr Kernels make_kernels(VectorIsa isa, const char* name) {
  static_assert(Lanes::kCount <= kMaxLanes);
  return {isa, name, Lanes::kCount, all_pairs<Lanes>, changed_pairs<Lanes>};
}

}  // namespace
}  // namespace cellsweep::stream

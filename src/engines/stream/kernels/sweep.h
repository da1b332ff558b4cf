/// @file
/// The sweep, for any vectors of bytes: `FourBytes` says which of kBoxes boxes of four bytes are within
/// bounds.
#pragma once

#include <smmintrin.h>

#include "engines/stream/kernels/faces.h"
#include "engines/stream/kernels/four_sse41.h"
#include "engines/stream/kernels/kernel.h"

namespace cellsweep::stream {
namespace {

/// A box, and which of those from `first` on it overlaps as far as bytes tell, a bit each.
struct SweptHits {
  std::uint64_t lanes;
  std::uint32_t place;
  std::uint32_t first;
};

/// So many boxes with hits are looked at at once: no branch depends on a comparison before.
inline constexpr std::uint32_t kHitsAtOnce = 128;

/// Bits for those below `count`.
inline std::uint64_t bits_below(std::uint32_t count) {
  return count >= 64 ? ~std::uint64_t{0} : (std::uint64_t{1} << count) - 1;
}

/// Returns how many tests that took.
inline std::uint64_t test_hits(const SweptBoxes& boxes, const SweptHits* hits, std::uint32_t count,
                               KeyBuffer& found) {
  std::uint64_t tests = 0;
  for (std::uint32_t h = 0; h < count; ++h) {
    const std::uint64_t a = boxes.slots[hits[h].place];
    const FourFloats box(boxes.boxes[a]);
    make_room(found, 64);
    std::uint64_t* key = found.keys + found.size;
    for (std::uint64_t lanes = hits[h].lanes; lanes != 0; lanes &= lanes - 1) {
      const std::uint64_t b = boxes.slots[hits[h].first + static_cast<unsigned>(__builtin_ctzll(lanes))];
      *key = a < b ? a << 32 | b : b << 32 | a;
      key += do_overlap(box, FourFloats(boxes.boxes[b])) ? 1 : 0;
      ++tests;
    }
    found.size = static_cast<std::size_t>(key - found.keys);
  }
  return tests;
}

/// What no byte of a box that overlaps this one is above: its bytes, those of lower ends in the place of
/// those of upper ones and the other way round, of each what is left to 255.
inline __m128i bounds_of(std::uint32_t box) {
  const __m128i other_ends = _mm_setr_epi8(1, 0, 3, 2, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1);
  return _mm_shuffle_epi8(_mm_cvtsi32_si128(static_cast<int>(~box)), other_ends);
}

/// Of the boxes from `first` on to `end`, so many at most as are compared at once.
template <class FourBytes>
std::uint64_t byte_hits(const SweptBoxes& boxes, std::uint32_t place, std::uint32_t first,
                        std::uint32_t end) {
  const auto bounds = FourBytes::broadcast(bounds_of(boxes.bytes[place]));
  return FourBytes::within(boxes.bytes + first, bounds) & bits_below(end - first);
}

template <class FourBytes>
SweepResult sweep(const SweptBoxes& swept, std::uint64_t most_tests, KeyBuffer& found) {
  static_assert(FourBytes::kBoxes <= SweptBoxes::kRoom);
  const SweptBoxes boxes = swept;  // a copy: what is written must not look like a change of it
  SweptHits hits[kHitsAtOnce];
  const std::size_t before = found.size;
  std::uint64_t tests = 0;
  std::uint32_t place = 0, first = 1;
  while (place < boxes.count) {
    std::uint32_t count = 0;
    while (place < boxes.count && count < kHitsAtOnce) {
      const std::uint32_t end = boxes.end[place];
      // Once whether there is a box behind it or not, which no branch could know: nearly all have one.
      do {
        hits[count] = {byte_hits<FourBytes>(boxes, place, first, end), place, first};
        count += hits[count].lanes != 0 ? 1 : 0;
        first += FourBytes::kBoxes;
      } while (first < end && count < kHitsAtOnce);
      if (first < end) break;
      first = ++place + 1;
    }
    tests += test_hits(boxes, hits, count, found);
    if (tests > 4 * (found.size - before) + most_tests) return {tests, false};
  }
  return {tests, true};
}

}  // namespace
}  // namespace cellsweep::stream

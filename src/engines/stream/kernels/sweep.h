/// @file
/// The sweep, for any vector of bytes: `Bytes` says how wide it is, loads, broadcasts and compares.
#pragma once

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

/// So many vectors with hits are looked at at once: no branch depends on a comparison before.
inline constexpr std::uint32_t kHitsAtOnce = 128;

/// Bits for those below `count`.
template <class Bytes>
std::uint64_t bytes_below(std::uint32_t count) {
  return count >= Bytes::kCount ? ~std::uint64_t{0} : (std::uint64_t{1} << count) - 1;
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

template <class Bytes>
std::uint64_t byte_hits(const SweptBoxes& boxes, std::uint32_t place, std::uint32_t first,
                        std::uint32_t end) {
  const auto low_y = Bytes::broadcast(boxes.low_y[place]), high_y = Bytes::broadcast(boxes.high_y[place]);
  const auto low_z = Bytes::broadcast(boxes.low_z[place]), high_z = Bytes::broadcast(boxes.high_z[place]);
  auto all = Bytes::less_equal(Bytes::load(boxes.low_y + first), high_y);
  all = Bytes::both(all, Bytes::less_equal(low_y, Bytes::load(boxes.high_y + first)));
  all = Bytes::both(all, Bytes::less_equal(Bytes::load(boxes.low_z + first), high_z));
  all = Bytes::both(all, Bytes::less_equal(low_z, Bytes::load(boxes.high_z + first)));
  return Bytes::bits(all) & bytes_below<Bytes>(end - first);
}

template <class Bytes>
SweepResult sweep(const SweptBoxes& swept, std::uint64_t most_tests, KeyBuffer& found) {
  const SweptBoxes boxes = swept;  // a copy: what is written must not look like a change of it
  SweptHits hits[kHitsAtOnce];
  const std::size_t before = found.size;
  std::uint64_t tests = 0;
  std::uint32_t place = 0, first = 1;
  while (place < boxes.count) {
    std::uint32_t count = 0;
    while (place < boxes.count && count < kHitsAtOnce) {
      const std::uint32_t end = boxes.end[place];
      // A first vector whether there is one behind it or not, which no branch could know: nearly all have.
      do {
        hits[count] = {byte_hits<Bytes>(boxes, place, first, end), place, first};
        count += hits[count].lanes != 0 ? 1 : 0;
        first += Bytes::kCount;
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

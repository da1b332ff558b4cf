#include "engines/stream/sweep/sorted_rows.h"

#include <algorithm>
#include <bit>

#include "base/tuning.h"

namespace cellsweep::stream {
namespace {

/// Neighbouring numbers share a place where there are many more of them than boxes: to count takes longer
/// than to compare with one or two boxes more.
unsigned shift_for(std::uint32_t numbers, std::size_t rows) {
  const std::size_t most = tuning::kPlacesOfBox * std::bit_ceil(rows + 1);
  unsigned shift = 0;
  while (numbers >> shift > most) ++shift;
  return shift;
}

}  // namespace

// By counting.
void SortedRows::sort(std::span<const SweepRow> rows, std::uint32_t numbers) {
  slots_.renew(rows.size());
  ends_.renew(rows.size());
  bytes_.renew(4 * room());
  Slot* const slots = slots_.data();
  std::uint32_t* const ends = ends_.data();
  std::uint8_t* const low_y = bytes_.data();
  std::uint8_t* const high_y = low_y + room();
  std::uint8_t* const low_z = high_y + room();
  std::uint8_t* const high_z = low_z + room();
  const unsigned shift = shift_for(numbers, rows.size());
  const std::uint32_t places = numbers >> shift;
  counts_.renew(2 * std::size_t{places} + 1);
  std::uint32_t* const next = counts_.data();
  std::uint32_t* const first = next + places;  // of each place, and how many there are
  std::fill_n(first, places + 1, 0U);
  for (const SweepRow& row : rows) ++first[(row.low() >> shift) + 1];
  for (std::uint32_t place = 0; place < places; ++place) {
    next[place] = first[place];
    first[place + 1] += first[place];
  }
  for (const SweepRow row : rows) {
    const std::uint32_t to = next[row.low() >> shift]++;
    slots[to] = row.slot;
    ends[to] = first[(row.high() >> shift) + 1];
    low_y[to] = static_cast<std::uint8_t>(row.on_others);
    high_y[to] = static_cast<std::uint8_t>(row.on_others >> 8);
    low_z[to] = static_cast<std::uint8_t>(row.on_others >> 16);
    high_z[to] = static_cast<std::uint8_t>(row.on_others >> 24);
  }
}

SweptBoxes SortedRows::view(std::span<const Aabb> boxes) const {
  const std::uint8_t* const bytes = bytes_.data();
  return {bytes,        bytes + room(), bytes + 2 * room(), bytes + 3 * room(),
          ends_.data(), slots_.data(),  boxes.data(),       static_cast<std::uint32_t>(slots_.size())};
}

std::uint64_t SortedRows::comparisons() const {
  std::uint64_t sum = 0;
  for (std::uint32_t place = 0; place < ends_.size(); ++place) sum += ends_.view()[place] - place;
  return sum;
}

}  // namespace cellsweep::stream

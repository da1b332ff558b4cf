#include "engines/stream/sweep/sorted_rows.h"

#include <algorithm>
#include <bit>
#include <utility>

#include "base/tuning.h"

namespace cellsweep::stream {
namespace {

/// The bytes of a row that are upper ends.
constexpr std::uint32_t kUpperEnds = 0xff00ff00;

/// Neighbouring numbers share a place where there are many more of them than boxes: to count takes longer
/// than to compare with one or two boxes more.
unsigned shift_for(std::uint32_t numbers, std::size_t rows) {
  const std::size_t most = tuning::kPlacesOfBox * std::bit_ceil(rows + 1);
  unsigned shift = 0;
  while (numbers >> shift > most) ++shift;
  return shift;
}

}  // namespace

// By counting: where the rows of a place begin becomes where they end as they are put there.
void SortedRows::sort(std::span<const SweepRow> rows, std::uint32_t numbers) {
  const unsigned shift = shift_for(numbers, rows.size());
  const std::uint32_t places = numbers >> shift;
  next_.renew(places);
  std::uint32_t* const next = next_.data();
  std::fill_n(next, places, 0U);
  for (const SweepRow& row : rows) ++next[row.low() >> shift];
  std::uint32_t sum = 0;
  for (std::uint32_t place = 0; place < places; ++place) sum += std::exchange(next[place], sum);
  rows_.renew(rows.size());
  SweepRow* const sorted = rows_.data();
  for (const SweepRow& row : rows) sorted[next[row.low() >> shift]++] = row;
  set_columns(shift);
}

void SortedRows::set_columns(unsigned shift) {
  const auto count = static_cast<std::uint32_t>(rows_.size());
  slots_.renew(count);
  ends_.renew(count);
  bytes_.renew(count + SweptBoxes::kRoom);
  const SweepRow* const rows = rows_.data();
  const std::uint32_t* const end_of_place = next_.data();
  Slot* const slots = slots_.data();
  std::uint32_t* const ends = ends_.data();
  std::uint32_t* const bytes = bytes_.data();
  comparisons_ = 0;
  for (std::uint32_t i = 0; i < count; ++i) {
    const std::uint32_t end = end_of_place[rows[i].high() >> shift];
    slots[i] = rows[i].slot;
    bytes[i] = rows[i].on_others ^ kUpperEnds;
    ends[i] = end;
    comparisons_ += end - i;
  }
}

SweptBoxes SortedRows::view(std::span<const Aabb> boxes) const {
  return {bytes_.data(), ends_.data(), slots_.data(), boxes.data(), static_cast<std::uint32_t>(rows_.size())};
}

}  // namespace cellsweep::stream

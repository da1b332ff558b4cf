#include "engines/stream/search/sorted_rows.h"

#include <algorithm>
#include <bit>

#include "base/sorting/prefix_sums.h"
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

// By counting: where the rows of a number begin becomes where they end as they are put there.
void SortedRows::sort(std::span<const SweepRow> rows, std::uint32_t numbers) {
  const unsigned shift = shift_for(numbers, rows.size());
  const std::uint32_t places = numbers >> shift;
  next_.renew(places);
  std::uint32_t* const next = next_.data();
  std::fill_n(next, places, 0U);
  for (const SweepRow& row : rows) ++next[row.low() >> shift];
  make_prefix_sums({next, places});
  slots_.renew(rows.size());
  ends_.renew(rows.size());
  bytes_.renew(rows.size() + SweptBoxes::kRoom);
  Slot* const slots = slots_.data();
  std::uint32_t* const ends = ends_.data();
  std::uint32_t* const bytes = bytes_.data();
  for (const SweepRow row : rows) {
    const std::uint32_t to = next[row.low() >> shift]++;
    slots[to] = row.slot;
    ends[to] = row.high() >> shift;
    bytes[to] = row.on_others ^ kUpperEnds;
  }
  comparisons_ = 0;
  for (std::uint32_t place = 0; place < rows.size(); ++place) {
    ends[place] = next[ends[place]];
    comparisons_ += ends[place] - place;
  }
}

SweptBoxes SortedRows::view(std::span<const Aabb> boxes) const {
  return {bytes_.data(), ends_.data(), slots_.data(), boxes.data(),
          static_cast<std::uint32_t>(slots_.size())};
}

}  // namespace cellsweep::stream

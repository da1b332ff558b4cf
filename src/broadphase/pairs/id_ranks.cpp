#include "broadphase/pairs/id_ranks.h"

#include <array>
#include <utility>

#include "base/key_sort.h"
#include "base/tuning.h"

namespace cellsweep {
namespace {

/// An id above its slot.
using Entry = std::uint64_t;

constexpr unsigned kDigitBits = 11;
constexpr unsigned kDigits = 3;
constexpr std::size_t kValues = std::size_t{1} << kDigitBits;

std::size_t digit_of(Entry entry, unsigned digit) {
  return (entry >> (32 + digit * kDigitBits)) & (kValues - 1);
}

/// How often each value of each digit occurs.
using Counts = std::array<std::array<std::uint32_t, kValues>, kDigits>;

void count_digits(std::span<const Entry> entries, Counts& counts) {
  for (auto& of_digit : counts) of_digit.fill(0);
  for (const Entry entry : entries) {
    for (unsigned digit = 0; digit < kDigits; ++digit) ++counts[digit][digit_of(entry, digit)];
  }
}

/// By one digit, stably.
void distribute(std::span<const Entry> from, unsigned digit, std::array<std::uint32_t, kValues>& counts,
                Entry* to) {
  std::uint32_t prefix_sum = 0;
  for (std::uint32_t& count : counts) prefix_sum += std::exchange(count, prefix_sum);
  for (const Entry entry : from) to[counts[digit_of(entry, digit)]++] = entry;
}

/// Radix sort, digit by digit.
void sort_by_digits(Array<Entry>& entries) {
  Counts counts;
  count_digits(entries.view(), counts);
  Array<Entry> other;
  other.renew(entries.size());
  for (unsigned digit = 0; digit < kDigits; ++digit) {
    distribute(entries.view(), digit, counts[digit], other.data());
    std::swap(entries, other);
  }
}

/// By id; the order of equal ids does not matter.
void sort_entries(Array<Entry>& entries) {
  if (entries.size() <= tuning::kManyIds) return sort_keys(entries.view());
  sort_by_digits(entries);
}

}  // namespace

void IdRanks::refresh(const IdTable& table) {
  if (are_fresh(table)) return;
  Array<Entry> entries;
  entries.renew(table.slot_count());
  for (Slot slot = 0; slot < table.slot_count(); ++slot)
    entries.data()[slot] = std::uint64_t{table.id(slot)} << 32 | slot;
  sort_entries(entries);
  ranks_.renew(entries.size());
  ids_.renew(entries.size());
  for (std::uint32_t rank = 0; rank < entries.size(); ++rank) {
    ranks_.data()[static_cast<Slot>(entries.data()[rank])] = rank;
    ids_.data()[rank] = static_cast<BodyId>(entries.data()[rank] >> 32);
  }
  version_ = table.version();
}

}  // namespace cellsweep

#include "mfc/reservations.h"

#include <algorithm>

namespace spu_emu {

namespace {
void read_line(const std::byte* line, LineWords& words) {
  const auto* from = reinterpret_cast<const LineWord*>(line);
  for (std::size_t i = 0; i < words.size(); ++i) words[i] = __atomic_load_n(from + i, __ATOMIC_ACQUIRE);
}

void write_line(std::byte* line, const LineWords& words) {
  auto* to = reinterpret_cast<LineWord*>(line);
  for (std::size_t i = 0; i < words.size(); ++i) __atomic_store_n(to + i, words[i], __ATOMIC_RELEASE);
}

/// Writes the words that differ, each only if it still is what was loaded. False if one no longer was.
bool exchange_line(std::byte* line, LineWords loaded, const LineWords& words) {
  auto* to = reinterpret_cast<LineWord*>(line);
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (loaded[i] == words[i]) continue;
    if (!__atomic_compare_exchange_n(to + i, &loaded[i], words[i], false, __ATOMIC_ACQ_REL,
                                     __ATOMIC_ACQUIRE)) {
      return false;
    }
  }
  return true;
}

std::byte* line_of(const std::byte* address) {
  return reinterpret_cast<std::byte*>(reinterpret_cast<std::uintptr_t>(address) &
                                      ~std::uintptr_t{kLineSize - 1});
}
}  // namespace

ReservationTable& ReservationTable::instance() {
  static ReservationTable table;
  return table;
}

ReservationTable::Bucket& ReservationTable::bucket(const std::byte* line) {
  return buckets_[(reinterpret_cast<std::uintptr_t>(line) / kLineSize) % kBuckets];
}

void ReservationTable::end(Bucket& bucket, Reservation& holder) {
  std::erase(bucket.holders, &holder);
  holder.line_.store(nullptr);
  count_.fetch_sub(1);
}

void ReservationTable::lose_line(Bucket& bucket, const std::byte* line) {
  for (std::size_t i = bucket.holders.size(); i-- > 0;) {
    Reservation& holder = *bucket.holders[i];
    if (holder.line_.load() != line) continue;
    end(bucket, holder);
    holder.lost();
  }
}

void ReservationTable::drop(Reservation& holder) {
  std::byte* line = holder.line_.load();
  if (line == nullptr) return;
  Bucket& home = bucket(line);
  const std::lock_guard lock(home.mutex);
  if (holder.line_.load() == line) end(home, holder);
}

void ReservationTable::load(Reservation& holder, std::byte* line, LineWords& words) {
  drop(holder);
  Bucket& home = bucket(line);
  const std::lock_guard lock(home.mutex);
  home.holders.push_back(&holder);
  holder.line_.store(line);
  count_.fetch_add(1);
  read_line(line, words);
  holder.loaded_ = words;
}

bool ReservationTable::store_conditional(Reservation& holder, std::byte* line, const LineWords& words) {
  Bucket& home = bucket(line);
  {
    const std::lock_guard lock(home.mutex);
    if (holder.line_.load() == line) {
      LineWords now{};
      read_line(line, now);
      const bool written = now == holder.loaded_ && exchange_line(line, holder.loaded_, words);
      end(home, holder);
      if (written) lose_line(home, line);
      return written;
    }
  }
  drop(holder);
  return false;
}

void ReservationTable::store(std::byte* line, const LineWords& words) {
  Bucket& home = bucket(line);
  const std::lock_guard lock(home.mutex);
  write_line(line, words);
  lose_line(home, line);
}

void ReservationTable::lose_range(const std::byte* first, std::size_t size) {
  for (std::byte* line = line_of(first); line < first + size; line += kLineSize) {
    Bucket& home = bucket(line);
    const std::lock_guard lock(home.mutex);
    lose_line(home, line);
  }
}

bool ReservationTable::changed(Reservation& holder) {
  std::byte* line = holder.line_.load();
  if (line == nullptr) return false;
  Bucket& home = bucket(line);
  const std::lock_guard lock(home.mutex);
  if (holder.line_.load() != line) return false;
  LineWords now{};
  read_line(line, now);
  return now != holder.loaded_;
}

}  // namespace spu_emu

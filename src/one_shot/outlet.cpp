#include "one_shot/outlet.h"

#include <algorithm>

#include "one_shot/exact.h"

namespace cellsweep::one_shot {

Outlet::Outlet(Found& found) : found_(found) {
  keys = room_;
  capacity = kRoom;
  grow = [](KeyBuffer& buffer, std::size_t) { static_cast<Outlet&>(buffer).flush(); };
}

void Outlet::flush() {
  const std::size_t written = size;
  const std::size_t pairs = translate();
  size = 0;
  // Counted first: a visitor sees no more than may be.
  const std::uint64_t before = found_.pairs.fetch_add(pairs, std::memory_order_relaxed);
  if (found_.exact != nullptr) {
    const std::uint64_t more = written - pairs;
    const std::uint64_t candidates = found_.candidates.fetch_add(more, std::memory_order_relaxed) + more;
    if (candidates > found_.most_candidates && candidates - found_.most_candidates > before + pairs)
      throw TooManyCandidates();
  }
  const std::uint64_t left = found_.most_pairs - std::min(before, found_.most_pairs);
  take({room_, static_cast<std::size_t>(std::min<std::uint64_t>(pairs, left))});
  if (pairs > left) throw stream::TooManyPairs();
}

void Outlet::write(std::span<const std::uint64_t> slot_keys) {
  while (!slot_keys.empty()) {
    if (size == capacity) flush();
    const std::size_t count = std::min(slot_keys.size(), capacity - size);
    std::copy_n(slot_keys.begin(), count, keys + size);
    size += count;
    slot_keys = slot_keys.subspan(count);
  }
}

// Of how many that overlap.
std::size_t Outlet::translate() {
  const SearchedBoxes& boxes = *found_.boxes;
  const std::uint32_t* const places = boxes.places.size() == 0 ? nullptr : boxes.places.data();
  if (places == nullptr && found_.exact == nullptr && !boxes.are_two) return size;
  const std::uint64_t second = boxes.are_two ? boxes.second_place : 0;
  std::uint64_t* to = room_;
  for (std::size_t i = 0; i < size; ++i) {
    auto a = static_cast<std::uint32_t>(room_[i] >> 32);
    auto b = static_cast<std::uint32_t>(room_[i]);
    if (places != nullptr) a = places[a], b = places[b];
    *to = (std::uint64_t{a} << 32 | b) - second;
    to += found_.exact == nullptr || overlap(found_.exact[a], found_.exact[b]) ? 1 : 0;
  }
  return static_cast<std::size_t>(to - room_);
}

void ListOutlet::take(std::span<const std::uint64_t> place_keys) {
  KeyBuffer& list = keys_.buffer();
  stream::make_room(list, place_keys.size());
  std::copy(place_keys.begin(), place_keys.end(), list.keys + list.size);
  list.size += place_keys.size();
}

}  // namespace cellsweep::one_shot

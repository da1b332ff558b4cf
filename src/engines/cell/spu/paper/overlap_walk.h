/// @file
/// Step C11, overlap method 1: the IDs on the way from a changed ID's first endpoint to its second overlap
/// it.
#pragma once

#include <cstdint>

#include "engines/cell/wire.h"

namespace cellsweep::cell::paper {

/// Where the endpoints of an ID are in the sorted order.
struct Place {
  std::uint32_t first;
  std::uint32_t second;  ///< kDone: all overlaps of this ID have been passed on
};

/// No ID's second endpoint is in front.
inline constexpr std::uint32_t kDone = 0;

/// C11's ruling: IDs in value order cannot be searched by halves, so a table is built, by ID.
inline void build_place_table(const std::uint32_t* ids, std::uint32_t count, Place* places) {
  for (std::uint32_t i = 0; i < count && ids[i] != kUnchanged; ++i) {
    Place& place = places[ids[i] & ~kMaximumFlag];
    if ((ids[i] & kMaximumFlag) == 0) {
      place.first = i;
    } else {
      place.second = i;
    }
  }
}

/// The exact default. Passes to keys.add() the key of every pair of a changed ID and an ID that overlaps it,
/// each pair once. Overlapping are the IDs that are open before the first endpoint, and those that begin on
/// the way; those that only end on the way were open before. `places` is used up.
template <class Keys>
void walk_overlaps(const std::uint32_t* ids, Place* places, const std::int32_t* changed, std::uint32_t count,
                   Keys& keys) {
  for (std::uint32_t i = 0; i < count; ++i) {
    const auto target = static_cast<std::uint32_t>(changed[i]);
    const Place place = places[target];
    for (std::uint32_t j = 0; j < place.first; ++j) {
      const bool begins = (ids[j] & kMaximumFlag) == 0;
      if (begins && places[ids[j]].second > place.first) keys.add(pair_key_of_ids(target, ids[j]));
    }
    for (std::uint32_t j = place.first + 1; j < place.second; ++j) {
      const bool begins = (ids[j] & kMaximumFlag) == 0;
      if (begins && places[ids[j]].second != kDone) keys.add(pair_key_of_ids(target, ids[j]));
    }
    places[target].second = kDone;
  }
}

/// Listing 4.12 as it stands, on plain IDs, but that no search and no walk leaves the array: linear search
/// for the first endpoint, then every ID up to the second one, as often as it is met.
template <class Keys>
void walk_overlaps_literal(const std::uint32_t* ids, std::uint32_t endpoints, const std::int32_t* changed,
                           std::uint32_t count, Keys& keys) {
  for (std::uint32_t i = 0; i < count; ++i) {
    const auto target = static_cast<std::uint32_t>(changed[i]);
    std::uint32_t j = 0;
    while (j < endpoints && ids[j] != target) ++j;
    for (++j; j < endpoints && ids[j] != target; ++j) {
      if (ids[j] != kUnchanged) keys.add(pair_key_of_ids(target, ids[j]));
    }
  }
}

}  // namespace cellsweep::cell::paper

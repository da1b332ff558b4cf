/// @file
/// The document's pair manager (X1, X2): a map from a hashed pair of ids to the pair's overlap on each axis.
#pragma once

#include <cstdint>
#include <map>

namespace cellsweep::control {

/// Listing 4.1: one number for two ids below 2^16, the smaller one first.
constexpr int pair_hash(int smaller, int larger) {
  const auto low = static_cast<std::uint32_t>(smaller) & 0xffffU;
  const auto high = static_cast<std::uint32_t>(larger) << 16;
  return static_cast<int>(low | high);
}

/// Listing 4.2.
struct PairInfo {
  int aID;
  int bID;
  bool value[3];

  bool colliding() const { return value[0] && value[1] && value[2]; }
};

/// What one entry costs: 32 bytes of tree links and colour, 16 of key and PairInfo, and what the allocator
/// adds to make 48 bytes a block of its own (glibc: 64 in all).
inline constexpr std::uint64_t kPairMapEntryBytes = 64;

/// Ids that fit Listing 4.1's key.
inline constexpr std::uint64_t kPairHashIds = 65536;

/// The bodies whose pairs fit a map of so many bytes, at most kPairHashIds.
std::uint64_t bodies_that_fit(std::uint64_t map_bytes);

/// Every possible pair of bodies, colliding or not.
class PairManager {
 public:
  /// Enters a pair of two ids, not overlapping on any axis.
  void add(int one, int other);

  /// Takes a pair out and returns what was known of it; the pair must be there.
  PairInfo remove(int one, int other);

  /// The entry of a pair that is there.
  PairInfo& find(int one, int other);

  /// Finds pairs in ascending order of their hashes. Where they lie close together it walks along the map
  /// instead of searching from its root. Holds until the map gets or loses a pair.
  class Cursor {
   public:
    explicit Cursor(PairManager& pairs) : pairs_(pairs.axis_collisions_), at_(pairs_.begin()) {}

    /// The entry of a pair that is there.
    PairInfo& find(int hash);

   private:
    static constexpr int kStepsBeforeSearch = 2;

    std::map<int, PairInfo>& pairs_;
    std::map<int, PairInfo>::iterator at_;
  };

  std::size_t size() const { return axis_collisions_.size(); }

 private:
  std::map<int, PairInfo> axis_collisions_;
};

}  // namespace cellsweep::control

/// @file
/// Holds the pairs of a peer against the oracle's.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "bench/peers/peer_run.h"

namespace cellsweep::bench {

/// By how many pairs a peer is off.
struct Mismatch {
  std::size_t missing = 0;
  std::size_t extra = 0;  ///< pairs that do not overlap, and those listed again

  bool none() const { return missing == 0 && extra == 0; }
};

/// "3 pairs missing, 0 too many".
std::string describe(const Mismatch& mismatch);

/// How the pairs of the run's last frame differ from those that the oracle finds: all boxes against all up to
/// 10,000 of them, beyond that by cells.
Mismatch compare_with_oracle(const PeerRun& run);

/// Runs the peer, untimed, over a few frames of the setting's scene, and compares each with all boxes against
/// all. The sum over the frames.
Mismatch check_peer(const PeerInfo& info, const PeerSetting& setting, std::size_t frames);

/// Count and hash of the oracle's pairs.
struct PairSum {
  std::size_t pairs = 0;
  std::uint64_t hash = 0;

  friend bool operator==(const PairSum&, const PairSum&) = default;
};

/// The oracle's, for the last frame of a run of this setting; found once for each.
PairSum oracle_sum(const PeerSetting& setting, const PeerRun& run);

}  // namespace cellsweep::bench

/// @file
/// Runs a peer through the frames of a scene, with a clock on what it does.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "bench/peers/peer.h"
#include "bench/peers/peer_mode.h"
#include "cellsweep/world/frame_source.h"

namespace cellsweep::bench {

/// What a row runs. Its scene has seed 1.
struct PeerSetting {
  std::string scene;
  std::size_t bodies = 0;
  PeerMode mode = PeerMode::initial;
};

const PeerModeInfo& info_of(PeerMode mode);

/// How many timed frames a row of this setting has.
std::size_t frames_of(const PeerSetting& setting);

/// A peer on its way through a scene. Frame 0, for all modes but `initial`, is not among those timed.
class PeerRun {
 public:
  PeerRun(const PeerInfo& info, const PeerSetting& setting);

  /// Seconds from the new boxes to the list of pairs, of the next frame. The scene moves on before, outside
  /// of the clock, and with `initial` a new peer is made.
  double next_frame();

  std::span<const Aabb> boxes() const { return source_->boxes(); }
  /// The list of the last frame, as the peer wrote it.
  const std::vector<Pair>& listed() const { return pairs_; }
  /// The same list, of bodies by their numbers, the smaller first.
  std::vector<Pair> pairs() const;

 private:
  void make_peer();
  double insert_all();
  double update(std::span<const BodyId> moved);

  const PeerInfo* info_;
  PeerSetting setting_;
  std::unique_ptr<FrameSource> source_;
  std::vector<BodyId> all_;
  std::unique_ptr<Peer> peer_;
  std::vector<Pair> pairs_;
};

}  // namespace cellsweep::bench

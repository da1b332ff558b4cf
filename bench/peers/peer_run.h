/// @file
/// Runs a peer through the frames of a scene, with a clock on what it does.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "bench/peers/peer.h"
#include "bench/peers/peer_mode.h"
#include "cellsweep/world/frame_source.h"
#include "cellsweep/world/scene.h"

namespace cellsweep::bench {

/// What a row runs. Its scene has seed 1, but for other worlds of mode `initial`.
struct PeerSetting {
  std::string scene;
  std::size_t bodies = 0;
  PeerMode mode = PeerMode::initial;
  GiantSlot giant = GiantSlot::none;
};

const PeerModeInfo& info_of(PeerMode mode);

/// How many timed frames a row of this setting has.
std::size_t frames_of(const PeerSetting& setting);

/// The scene of a setting.
SceneSettings scene_of(const PeerSetting& setting, std::uint64_t seed);

/// Whether there are rows of a peer in a scene (a place in kPeerScenes) and mode.
bool has_rows(const PeerInfo& info, std::size_t scene, PeerMode mode);

/// Which boxes a frame has: with the same setting's scene, the same boxes.
struct FrameKey {
  std::uint64_t seed = 1;
  std::size_t frame = 0;
};

/// A peer on its way through a scene. Frame 0, for all modes but `initial`, is not among those timed.
class PeerRun {
 public:
  PeerRun(const PeerInfo& info, const PeerSetting& setting);

  /// Seconds from the new boxes to the list of pairs, of the next frame. The scene moves on before, outside
  /// of the clock, and so a new peer is made for one that is given all anew.
  double next_frame();

  /// By id; those of bodies() are of meaning.
  std::span<const Aabb> boxes() const;
  std::span<const BodyId> bodies() const;
  FrameKey key() const { return key_; }

  /// What the peer counted in the last frame.
  const Work& work() const { return work_; }

  /// The list of the last frame, as the peer wrote it.
  const std::vector<Pair>& listed() const { return pairs_; }
  /// The same list, of bodies by their numbers, the smaller first.
  std::vector<Pair> pairs() const;

 private:
  void go_to_next_world();
  void make_peer(std::span<const Aabb> boxes);
  double insert(std::span<const Aabb> boxes);
  double insert_those_there();
  double update(const PeerChanges& changes);
  double run_frame();
  BodyId body_of(BodyId listed) const;

  const PeerInfo* info_;
  PeerSetting setting_;
  Aabb world_;
  std::unique_ptr<FrameSource> source_;    // but for mode `initial`
  std::vector<std::vector<Aabb>> worlds_;  // of mode `initial`, as far as they were needed
  FrameKey key_;
  std::vector<BodyId> all_;
  std::vector<Aabb> there_boxes_;  // of a peer that is given all anew: those that are there,
  std::vector<BodyId> there_ids_;  // and who they are
  std::unique_ptr<Peer> peer_;
  std::vector<Pair> pairs_;
  Work work_;
  Work work_before_;  // of the same peer, before the last frame
};

}  // namespace cellsweep::bench

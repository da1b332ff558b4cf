#include "bench/peers/peer_run.h"

#include <algorithm>
#include <chrono>
#include <utility>

#include "cellsweep/world/scene.h"
#include "world/scene_recipes.h"

namespace cellsweep::bench {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

Aabb world_of(const PeerSetting& setting) {
  for (const SceneRecipe& recipe : scene_recipes()) {
    if (recipe.info.name != setting.scene) continue;
    const auto edge = static_cast<float>(recipe.world_edge(static_cast<double>(setting.bodies)));
    return {{0, 0, 0}, {edge, edge, edge}};
  }
  return {};
}

std::unique_ptr<FrameSource> frames_of_scene(const PeerSetting& setting) {
  SceneSettings scene;
  scene.scene = setting.scene;
  scene.bodies = setting.bodies;
  scene.moving = info_of(setting.mode).moving;
  return std::move(*make_scene_frames(scene));
}

}  // namespace

const PeerModeInfo& info_of(PeerMode mode) {
  return *std::find_if(kPeerModes.begin(), kPeerModes.end(),
                       [mode](const PeerModeInfo& info) { return info.mode == mode; });
}

std::size_t frames_of(const PeerSetting& setting) {
  const auto& frames = info_of(setting.mode).frames;
  for (std::size_t i = 0; i < kPeerBodies.size(); ++i) {
    if (setting.bodies <= kPeerBodies[i]) return frames[i];
  }
  return frames.back();
}

PeerRun::PeerRun(const PeerInfo& info, const PeerSetting& setting)
    : info_(&info), setting_(setting), source_(frames_of_scene(setting)) {
  all_.resize(setting.bodies);
  for (std::size_t i = 0; i < all_.size(); ++i) all_[i] = static_cast<BodyId>(i);
  if (setting.mode == PeerMode::initial) return;
  make_peer();
  insert_all();
}

void PeerRun::make_peer() {
  peer_ = info_->make();
  peer_->prepare({world_of(setting_), boxes()});
}

double PeerRun::insert_all() {
  const Clock::time_point start = Clock::now();
  peer_->insert(boxes());
  peer_->list_pairs(pairs_);
  return seconds_since(start);
}

double PeerRun::update(std::span<const BodyId> moved) {
  const Clock::time_point start = Clock::now();
  peer_->update(boxes(), moved);
  peer_->list_pairs(pairs_);
  return seconds_since(start);
}

std::vector<Pair> PeerRun::pairs() const {
  std::vector<Pair> pairs;
  pairs.reserve(pairs_.size());
  for (const Pair& pair : pairs_)
    pairs.push_back(make_pair_of(peer_->body_of(pair.a), peer_->body_of(pair.b)));
  return pairs;
}

double PeerRun::next_frame() {
  switch (setting_.mode) {
    case PeerMode::initial:
      make_peer();
      pairs_ = {};
      return insert_all();
    case PeerMode::static_told:
      return update({});
    case PeerMode::static_given:
      return update(all_);
    default:
      source_->advance();
      return update(source_->moved());
  }
}

}  // namespace cellsweep::bench

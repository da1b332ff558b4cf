#include "bench/peers/peer_run.h"

#include <algorithm>
#include <chrono>
#include <utility>

namespace cellsweep::bench {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

std::unique_ptr<FrameSource> frames_of_scene(const PeerSetting& setting, std::uint64_t seed) {
  return std::move(*make_scene_frames(scene_of(setting, seed)));
}

bool has_own_motion(std::string_view scene) {
  const auto place = std::find(kPeerScenes.begin(), kPeerScenes.end(), scene) - kPeerScenes.begin();
  return !moves_as_told(static_cast<std::size_t>(place));
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

bool has_rows(const PeerInfo& info, std::size_t scene, PeerMode mode) {
  if (!has_mode(scene, mode)) return false;
  if (mode == PeerMode::static_told && !info.remembers) return false;
  const auto& out = info.left_out;
  return std::find(out.begin(), out.end(), kPeerScenes[scene]) == out.end();
}

SceneSettings scene_of(const PeerSetting& setting, std::uint64_t seed) {
  SceneSettings scene;
  scene.scene = setting.scene;
  scene.bodies = setting.bodies;
  scene.seed = seed;
  scene.giant = setting.giant;
  if (!has_own_motion(setting.scene)) scene.moving = info_of(setting.mode).moving;
  return scene;
}

PeerRun::PeerRun(const PeerInfo& info, const PeerSetting& setting)
    : info_(&info), setting_(setting), world_(*scene_bounds(scene_of(setting, 1))) {
  all_.resize(setting.bodies);
  for (std::size_t i = 0; i < all_.size(); ++i) all_[i] = static_cast<BodyId>(i);
  if (setting.mode == PeerMode::initial) {
    key_.seed = 0;  // before the first world
    return;
  }
  source_ = frames_of_scene(setting, key_.seed);
  make_peer(boxes());
  insert(boxes());
}

std::span<const Aabb> PeerRun::boxes() const {
  return source_ ? source_->boxes() : std::span<const Aabb>(worlds_[key_.seed - 1]);
}

std::span<const BodyId> PeerRun::bodies() const {
  return source_ ? source_->bodies() : std::span<const BodyId>(all_);
}

void PeerRun::go_to_next_world() {
  const std::size_t worlds = setting_.bodies <= kMostBodiesInManyWorlds ? kManyWorlds : 1;
  key_.seed = key_.seed % worlds + 1;
  if (key_.seed <= worlds_.size()) return;
  const auto source = frames_of_scene(setting_, key_.seed);
  worlds_.emplace_back(source->boxes().begin(), source->boxes().end());
}

void PeerRun::make_peer(std::span<const Aabb> boxes) {
  peer_ = info_->make();
  work_before_ = {};
  peer_->prepare({world_, boxes});
}

double PeerRun::insert(std::span<const Aabb> boxes) {
  const Clock::time_point start = Clock::now();
  peer_->insert(boxes);
  peer_->list_pairs(pairs_);
  return seconds_since(start);
}

// One that starts anew by itself keeps its memory.
double PeerRun::insert_those_there() {
  there_ids_.assign(bodies().begin(), bodies().end());
  there_boxes_.clear();
  for (const BodyId id : there_ids_) there_boxes_.push_back(boxes()[id]);
  if (info_->remembers) make_peer(there_boxes_);
  return insert(there_boxes_);
}

double PeerRun::update(const PeerChanges& changes) {
  const Clock::time_point start = Clock::now();
  peer_->update(boxes(), changes);
  peer_->list_pairs(pairs_);
  return seconds_since(start);
}

BodyId PeerRun::body_of(BodyId listed) const {
  const BodyId id = peer_->body_of(listed);
  return there_ids_.empty() ? id : there_ids_[id];
}

std::vector<Pair> PeerRun::pairs() const {
  std::vector<Pair> pairs;
  pairs.reserve(pairs_.size());
  for (const Pair& pair : pairs_) pairs.push_back(make_pair_of(body_of(pair.a), body_of(pair.b)));
  return pairs;
}

double PeerRun::next_frame() {
  work_before_ = peer_ ? peer_->work() : Work();
  const double seconds = run_frame();
  work_ = peer_->work() - work_before_;
  return seconds;
}

double PeerRun::run_frame() {
  switch (setting_.mode) {
    case PeerMode::initial:
      go_to_next_world();
      make_peer(boxes());
      pairs_ = {};
      return insert(boxes());
    case PeerMode::static_told:
      return update({});
    case PeerMode::static_given:
      return update({all_});
    default:
      source_->advance();
      ++key_.frame;
      if (source_->bodies_come_and_go() && !info_->removes) return insert_those_there();
      return update({source_->moved(), source_->inserted(), source_->removed()});
  }
}

}  // namespace cellsweep::bench

/// @file
/// Embree's tree over user geometry, run against itself by rtcCollide().
#include <embree3/rtcore.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <mutex>
#include <thread>
#include <type_traits>

#include "base/inside_embree.h"
#include "bench/peers/peer_table.h"

namespace cellsweep::bench {
namespace {

using embree::CalledByEmbree;
using embree::InsideEmbree;

// More than the threads of most machines; those beyond share the last list.
constexpr std::size_t kLists = 256;

std::size_t number_of_this_thread() {
  static std::atomic<std::size_t> threads = 0;
  static thread_local const std::size_t number = threads++;
  return std::min(number, kLists - 1);
}

// What a ray would meet; none is ever sent.
void meet_no_ray(const RTCIntersectFunctionNArguments*) {}
void hide_no_ray(const RTCOccludedFunctionNArguments*) {}

class EmbreePeer final : public Peer {
 public:
  EmbreePeer(RTCBuildQuality quality, bool refit) : quality_(quality), refit_(refit) {}

  ~EmbreePeer() override {
    const InsideEmbree inside(this);
    geometry_.reset();
    scene_.reset();
    device_.reset();
  }

  void prepare(const Stage&) override {
    const InsideEmbree inside(this);
    device_.reset(rtcNewDevice(("threads=" + std::to_string(std::thread::hardware_concurrency())).c_str()));
  }

  void insert(std::span<const Aabb> boxes) override {
    boxes_ = boxes;
    {
      const InsideEmbree inside(this);
      make_scene(static_cast<unsigned>(boxes.size()));
      rtcCommitScene(scene_.get());
    }
    collide();
  }

  void update(std::span<const Aabb> boxes, const PeerChanges& changes) override {
    boxes_ = boxes;
    if (changes.any()) {
      const InsideEmbree inside(this);
      rtcCommitGeometry(geometry_.get());
      rtcCommitScene(scene_.get());
    }
    collide();
  }

  void list_pairs(std::vector<Pair>& pairs) override {
    pairs.clear();
    for (const List& list : lists_) pairs.insert(pairs.end(), list.pairs.begin(), list.pairs.end());
  }

 private:
  template <class Handle, void (*Release)(Handle)>
  struct Releaser {
    void operator()(Handle handle) const { Release(handle); }
  };
  using Device = std::unique_ptr<std::remove_pointer_t<RTCDevice>, Releaser<RTCDevice, rtcReleaseDevice>>;
  using Scene = std::unique_ptr<std::remove_pointer_t<RTCScene>, Releaser<RTCScene, rtcReleaseScene>>;
  using Geometry =
      std::unique_ptr<std::remove_pointer_t<RTCGeometry>, Releaser<RTCGeometry, rtcReleaseGeometry>>;

  /// What one thread has found.
  struct alignas(64) List {
    std::vector<Pair> pairs;
  };

  void make_scene(unsigned bodies) {
    scene_.reset(rtcNewScene(device_.get()));
    rtcSetSceneFlags(scene_.get(), RTC_SCENE_FLAG_DYNAMIC);
    rtcSetSceneBuildQuality(scene_.get(), quality_);
    geometry_.reset(rtcNewGeometry(device_.get(), RTC_GEOMETRY_TYPE_USER));
    rtcSetGeometryBuildQuality(geometry_.get(), refit_ ? RTC_BUILD_QUALITY_REFIT : quality_);
    rtcSetGeometryUserPrimitiveCount(geometry_.get(), bodies);
    rtcSetGeometryUserData(geometry_.get(), this);
    rtcSetGeometryBoundsFunction(geometry_.get(), tell_bounds, nullptr);
    rtcSetGeometryIntersectFunction(geometry_.get(), meet_no_ray);
    rtcSetGeometryOccludedFunction(geometry_.get(), hide_no_ray);
    rtcCommitGeometry(geometry_.get());
    rtcAttachGeometry(scene_.get(), geometry_.get());
  }

  static void tell_bounds(const RTCBoundsFunctionArguments* arguments) {
    const auto* self = static_cast<const EmbreePeer*>(arguments->geometryUserPtr);
    const CalledByEmbree called(self);
    const Aabb& box = self->boxes_[arguments->primID];
    *arguments->bounds_o = {box.min[0], box.min[1], box.min[2], 0, box.max[0], box.max[1], box.max[2], 0};
  }

  // Both orders of a pair come, from whichever threads, and those trees that were not built at medium quality
  // also name near misses.
  static void take_candidates(void* user, RTCCollision* candidates, unsigned count) {
    auto* self = static_cast<EmbreePeer*>(user);
    const CalledByEmbree called(self);
    const std::size_t number = number_of_this_thread();
    std::unique_lock lock(self->shared_list_, std::defer_lock);
    if (number == kLists - 1) lock.lock();
    for (unsigned i = 0; i < count; ++i) {
      const Pair pair{candidates[i].primID0, candidates[i].primID1};
      if (pair.a < pair.b && overlap(self->boxes_[pair.a], self->boxes_[pair.b])) {
        self->lists_[number].pairs.push_back(pair);
      }
    }
  }

  void collide() {
    for (List& list : lists_) list.pairs.clear();
    const InsideEmbree inside(this);
    rtcCollide(scene_.get(), scene_.get(), take_candidates, this);
  }

  RTCBuildQuality quality_;
  bool refit_;
  Device device_;
  Scene scene_;
  Geometry geometry_;
  std::span<const Aabb> boxes_;
  std::array<List, kLists> lists_;
  std::mutex shared_list_;
};

PeerInfo embree_peer(std::string_view name, std::string_view settings, RTCBuildQuality quality, bool refit) {
  PeerInfo info;
  info.name = name;
  info.threads = "all cores";
  info.margin = "none";
  info.settings = settings;
  info.exactness = "each pair twice, in an order that changes from run to run, and near misses; dropped here";
  info.most_bodies = kAnyNumber;
  info.make = [=] { return std::make_unique<EmbreePeer>(quality, refit); };
  return info;
}

}  // namespace

void add_embree_peers(std::vector<PeerInfo>& peers) {
  peers.push_back(embree_peer("embree_medium",
                              "`rtcCollide`; tree built anew when a box moved, medium quality",
                              RTC_BUILD_QUALITY_MEDIUM, false));
  peers.push_back(embree_peer("embree_low",
                              "`rtcCollide`; tree built anew when a box moved, low quality (Morton order)",
                              RTC_BUILD_QUALITY_LOW, false));
  peers.push_back(embree_peer("embree_refit", "`rtcCollide`; built once at medium quality, then refitted",
                              RTC_BUILD_QUALITY_MEDIUM, true));
}

}  // namespace cellsweep::bench

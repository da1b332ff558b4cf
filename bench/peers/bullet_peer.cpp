/// @file
/// Bullet's dynamic tree and its sweep and prune, by their own interface.
#include <BulletCollision/BroadphaseCollision/btAxisSweep3.h>
#include <BulletCollision/BroadphaseCollision/btDbvtBroadphase.h>
#include <btBulletCollisionCommon.h>

#include <cstdint>
#include <utility>

#include "bench/peers/peer_table.h"

namespace cellsweep::bench {
namespace {

enum class Kind { axis_16, axis_32, tree };

constexpr float kDefaultMargin = 0.05F;

btVector3 vector_of(const std::array<float, 3>& corner) {
  return {corner[0], corner[1], corner[2]};
}

class BulletPeer final : public Peer {
 public:
  BulletPeer(Kind kind, float margin) : kind_(kind), margin_(margin) {}

  ~BulletPeer() override {
    if (!broadphase_) return;
    // A sweep's memory goes with it; the tree's proxies are on the heap.
    for (btBroadphaseProxy* proxy : proxies_) {
      if (kind_ == Kind::tree && proxy != nullptr) btAlignedFree(proxy);
    }
  }

  void prepare(const Stage& stage) override { world_ = stage.world; }

  void insert(std::span<const Aabb> boxes) override {
    boxes_ = boxes;
    gDbvtMargin = margin_;
    make_broadphase(boxes.size());
    proxies_.resize(boxes.size());
    for (std::size_t id = 0; id < boxes.size(); ++id) enter(static_cast<BodyId>(id));
    broadphase_->calculateOverlappingPairs(&dispatcher_);
  }

  void update(std::span<const Aabb> boxes, const PeerChanges& changes) override {
    boxes_ = boxes;
    gDbvtMargin = margin_;
    for (const BodyId id : changes.removed) {
      broadphase_->destroyProxy(std::exchange(proxies_[id], nullptr), &dispatcher_);
    }
    for (const BodyId id : changes.inserted) enter(id);
    for (const BodyId id : changes.moved) {
      broadphase_->setAabb(proxies_[id], vector_of(boxes[id].min), vector_of(boxes[id].max), &dispatcher_);
    }
    broadphase_->calculateOverlappingPairs(&dispatcher_);
  }

  void list_pairs(std::vector<Pair>& pairs) override {
    pairs.clear();
    btOverlappingPairCache* cache = broadphase_->getOverlappingPairCache();
    const btBroadphasePair* found = cache->getOverlappingPairArrayPtr();
    for (int i = 0; i < cache->getNumOverlappingPairs(); ++i) {
      const Pair pair = make_pair_of(id_of(*found[i].m_pProxy0), id_of(*found[i].m_pProxy1));
      if (overlap(boxes_[pair.a], boxes_[pair.b])) pairs.push_back(pair);
    }
  }

 private:
  void enter(BodyId id) {
    // A body without a client object would be skipped.
    auto* client = reinterpret_cast<void*>(static_cast<std::uintptr_t>(id) + 1);
    proxies_[id] = broadphase_->createProxy(vector_of(boxes_[id].min), vector_of(boxes_[id].max),
                                            BOX_SHAPE_PROXYTYPE, client, btBroadphaseProxy::DefaultFilter,
                                            btBroadphaseProxy::AllFilter, &dispatcher_);
  }

  static BodyId id_of(const btBroadphaseProxy& proxy) {
    return static_cast<BodyId>(reinterpret_cast<std::uintptr_t>(proxy.m_clientObject) - 1);
  }

  void make_broadphase(std::size_t bodies) {
    const btVector3 low = vector_of(world_.min);
    const btVector3 high = vector_of(world_.max);
    constexpr std::size_t kSpare = 8;  // handles of Bullet's own
    switch (kind_) {
      case Kind::axis_16:
        broadphase_ = std::make_unique<btAxisSweep3>(low, high, static_cast<unsigned short>(bodies + kSpare),
                                                     nullptr, true);
        break;
      case Kind::axis_32:
        broadphase_ = std::make_unique<bt32BitAxisSweep3>(low, high, static_cast<unsigned>(bodies + kSpare),
                                                          nullptr, true);
        break;
      case Kind::tree:
        broadphase_ = std::make_unique<btDbvtBroadphase>();
        break;
    }
  }

  Kind kind_;
  float margin_;
  Aabb world_;
  btDefaultCollisionConfiguration configuration_;
  btCollisionDispatcher dispatcher_{&configuration_};
  std::unique_ptr<btBroadphaseInterface> broadphase_;
  std::vector<btBroadphaseProxy*> proxies_;
  std::span<const Aabb> boxes_;
};

PeerInfo bullet_peer(std::string_view name, Kind kind, float margin) {
  PeerInfo info;
  info.name = name;
  info.threads = "1";
  info.removes = true;
  info.exactness = "the pairs and those of boxes made larger or rounded; dropped here when the list is made";
  info.make = [=] { return std::make_unique<BulletPeer>(kind, margin); };
  return info;
}

}  // namespace

void add_bullet_peers(std::vector<PeerInfo>& peers) {
  PeerInfo tree = bullet_peer("bullet_dbvt", Kind::tree, kDefaultMargin);
  tree.margin = "0.05 when a box leaves its larger one (default)";
  tree.settings = "`btDbvtBroadphase` as it comes; pairs that ended go over some frames";
  tree.most_bodies = kAnyNumber;
  tree.most_in_wall = 100'000;
  PeerInfo tight = bullet_peer("bullet_dbvt_margin0", Kind::tree, 0);
  tight.margin = "0";
  tight.settings = tree.settings;
  tight.most_bodies = kAnyNumber;
  tight.most_in_wall = tree.most_in_wall;
  PeerInfo sweep_16 = bullet_peer("bullet_axis16", Kind::axis_16, 0);
  sweep_16.margin = "to the grid of 16 bits";
  sweep_16.settings = "`btAxisSweep3`, the world's bounds known; bodies entered singly; no tree for rays";
  sweep_16.most_bodies = 16'000;
  PeerInfo sweep_32 = bullet_peer("bullet_axis32", Kind::axis_32, 0);
  sweep_32.margin = "to the grid of 32 bits";
  sweep_32.settings = "`bt32BitAxisSweep3`, otherwise the same";
  sweep_32.most_bodies = 1'000;
  for (PeerInfo* info : {&tree, &tight, &sweep_16, &sweep_32}) peers.push_back(std::move(*info));
}

}  // namespace cellsweep::bench

/// @file
/// A broadphase for the worlds of the physics engine Bullet.
#pragma once

#include <BulletCollision/BroadphaseCollision/btBroadphaseInterface.h>
#include <BulletCollision/BroadphaseCollision/btOverlappingPairCache.h>
#include <cellsweep/broadphase.h>
#include <cellsweep/query.h>

#include <cstddef>
#include <cstdint>
#include <vector>

#include "moved_list.h"
#include "proxy_pool.h"

/// Stands in a btCollisionWorld or btDynamicsWorld where a btDbvtBroadphase would:
///
///     CellsweepBroadphase broadphase;
///     btDiscreteDynamicsWorld world(&dispatcher, &broadphase, &solver, &configuration);
///
/// Pairs are those whose boxes overlap, no more and no fewer, from one calculateOverlappingPairs() to the
/// next, which Bullet calls in each step. Groups and masks are honoured, and what belongs to
/// btBroadphaseProxy::StaticFilter alone and does not meet it is never compared with its like. Where the pair
/// cache has a filter callback, that decides alone, as in Bullet's own broadphases. Filters are read when a
/// proxy is made: btCollisionWorld::refreshBroadphaseProxy() makes it anew.
///
/// With a margin, a length, a body that moves gets a fat box, larger by so much on each side, and nothing is
/// done for it while it stays in there. Pairs are then those whose fat boxes overlap: all that there were
/// without, and some that only come near. Bullet's own tree goes about it like this, with a margin of 0.05.
/// Where bodies tremble a step takes half of the time; a pile has twice the pairs.
///
/// One thread at a time, like the world that it belongs to; inside, `stream` may use more.
class CellsweepBroadphase final : public btBroadphaseInterface {
 public:
  /// `broadphase` has no bodies: one with the default options, or what cellsweep::make_broadphase() made.
  /// Throws std::invalid_argument when `margin` is negative, infinite or NaN.
  explicit CellsweepBroadphase(cellsweep::Broadphase broadphase = {}, btScalar margin = 0);
  CellsweepBroadphase(const CellsweepBroadphase&) = delete;
  CellsweepBroadphase& operator=(const CellsweepBroadphase&) = delete;

  /// What the last calculateOverlappingPairs() was refused, by a limit on pairs, for example. The pairs are
  /// then those of the call before, without those of proxies that are gone, and the next call takes up all
  /// that was not heard.
  const cellsweep::Status& status() const { return status_; }
  const cellsweep::Broadphase& broadphase() const { return broadphase_; }

  btBroadphaseProxy* createProxy(const btVector3& aabb_min, const btVector3& aabb_max, int shape_type,
                                 void* user, int group, int mask, btDispatcher* dispatcher) override;
  void destroyProxy(btBroadphaseProxy* proxy, btDispatcher* dispatcher) override;
  void setAabb(btBroadphaseProxy* proxy, const btVector3& aabb_min, const btVector3& aabb_max,
               btDispatcher* dispatcher) override;
  void getAabb(btBroadphaseProxy* proxy, btVector3& aabb_min, btVector3& aabb_max) const override;

  /// These two call process() once for each whose box, as it is now, meets the ray by btRayAabb2() or the box
  /// by TestAabbAgainstAabb2(). What it returns is not looked at, as in Bullet's tree; it may ask again.
  ///
  /// Fast: they look at what is on the way or in the box, and at what was created or moved since the last
  /// calculateOverlappingPairs(). As slow as a loop over all boxes: when that was refused, until one is not;
  /// for a ray or box with NaN or infinity, inside out, or with an end below 0; for a ray that is millions of
  /// units long.
  ///
  /// Those on a ray come nearer ones first, and then what was created or moved. A process() that lowers
  /// m_lambda_max gets none from then on that begins behind it.
  void rayTest(const btVector3& from, const btVector3& to, btBroadphaseRayCallback& callback,
               const btVector3& aabb_min = {0, 0, 0}, const btVector3& aabb_max = {0, 0, 0}) override;
  void aabbTest(const btVector3& aabb_min, const btVector3& aabb_max,
                btBroadphaseAabbCallback& callback) override;

  void calculateOverlappingPairs(btDispatcher* dispatcher) override;
  btOverlappingPairCache* getOverlappingPairCache() override { return &pairs_; }
  const btOverlappingPairCache* getOverlappingPairCache() const override { return &pairs_; }
  void getBroadphaseAabb(btVector3& aabb_min, btVector3& aabb_max) const override;
  void printStats() override {}

 private:
  /// What there is to know of a proxy besides.
  struct Body {
    std::uint32_t place = 0;  // in the list of those that moved, if it is there: has_moved()
    bool is_there = false;
    bool is_told = false;  // to the broadphase
  };

  using Proxies = std::vector<const Proxy*>;

  Proxies candidates(const cellsweep::Path& path) const;
  Proxies candidates(const cellsweep::Aabb& box) const;
  Proxies everybody() const;
  void add_seen(cellsweep::BodyId id, Proxies& proxies) const;
  void add_unseen(Proxies& proxies) const;

  Proxy& take_proxy();
  void make_room_for(std::size_t bodies);
  bool has_moved(cellsweep::BodyId id) const;
  void forget_move(cellsweep::BodyId id);
  cellsweep::Status tell_changes();
  cellsweep::Status tell_removed();
  cellsweep::Status tell_created();
  cellsweep::Status tell_moved();
  cellsweep::Status tell_filters();
  cellsweep::BodyFilter filter_of(const Proxy& proxy) const;

  cellsweep::Broadphase broadphase_;
  btScalar margin_;
  cellsweep::Status status_;
  bool has_seen_all_ = true;  // that the broadphase was told: its last update was not refused
  btHashedOverlappingPairCache pairs_;
  bool callback_decides_ = false;  // the pair cache's, when filters were last told
  bool offers_all_ = false;        // what one way to decide refused, another may allow
  ProxyPool proxies_;
  std::vector<Body> bodies_;           // by id
  std::vector<cellsweep::Aabb> told_;  // by id, where there is a margin: what the broadphase has or will get
  std::vector<cellsweep::BodyId> free_;  // ids
  std::vector<cellsweep::BodyId> gone_;  // ids that are free when the next update has succeeded
  // What the next update is to be told, by id.
  std::vector<cellsweep::BodyId> removed_;
  std::vector<cellsweep::BodyId> created_;
  MovedList moved_;
  // Of one call.
  std::vector<cellsweep::BodyId> ids_;
  std::vector<cellsweep::Aabb> boxes_;
  std::vector<cellsweep::BodyFilter> filters_;
};

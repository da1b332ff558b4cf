#include "cellsweep_broadphase.h"

#include <LinearMath/btAabbUtil2.h>

#include <cmath>
#include <cstring>
#include <stdexcept>
#include <string>
#include <utility>

#include "fat_box.h"
#include "proxy_box.h"
#include "ray_path.h"

using cellsweep::BodyFilter;
using cellsweep::BodyId;
using cellsweep::Status;

namespace {

// To the bit: one comparison instead of three. Where 0 has become -0 a box is told once more than it need be.
bool is_same(const btVector3& one, const btVector3& other) {
  return std::memcmp(one.m_floats, other.m_floats, 3 * sizeof(btScalar)) == 0;
}

}  // namespace

CellsweepBroadphase::CellsweepBroadphase(cellsweep::Broadphase broadphase, btScalar margin)
    : broadphase_(std::move(broadphase)), margin_(margin) {
  if (!(margin >= 0 && std::isfinite(margin)))
    throw std::invalid_argument("margin " + std::to_string(margin) + ": a length of at least 0");
}

Proxy& CellsweepBroadphase::take_proxy() {
  if (free_.empty()) {
    bodies_.resize(proxies_.size() + 1);
    if (margin_ > 0) told_.resize(bodies_.size());
    make_room_for(bodies_.capacity());
    return proxies_.add();
  }
  Proxy& proxy = proxies_[free_.back()];
  free_.pop_back();
  return proxy;
}

// A body is on each list at most once: with room for all, only a new body asks for memory between updates.
void CellsweepBroadphase::make_room_for(std::size_t bodies) {
  for (std::vector<BodyId>* const list : {&free_, &gone_, &removed_, &created_}) list->reserve(bodies);
  moved_.reserve(bodies);
}

btBroadphaseProxy* CellsweepBroadphase::createProxy(const btVector3& aabb_min, const btVector3& aabb_max, int,
                                                    void* user, int group, int mask, btDispatcher*) {
  Proxy& proxy = take_proxy();
  proxy.m_clientObject = user;
  proxy.m_collisionFilterGroup = group;
  proxy.m_collisionFilterMask = mask;
  proxy.m_aabbMin = aabb_min;
  proxy.m_aabbMax = aabb_max;
  bodies_[proxy.id()].is_there = true;
  created_.push_back(proxy.id());
  return &proxy;
}

void CellsweepBroadphase::destroyProxy(btBroadphaseProxy* base, btDispatcher* dispatcher) {
  pairs_.removeOverlappingPairsContainingProxy(base, dispatcher);
  const BodyId id = static_cast<Proxy&>(*base).id();
  Body& body = bodies_[id];
  forget_move(id);
  if (body.is_told) removed_.push_back(id);
  gone_.push_back(id);
  body.is_there = body.is_told = false;
}

// Bullet says where everything is in each step, whether it moved or not, mostly in the order in which it
// came.
void CellsweepBroadphase::setAabb(btBroadphaseProxy* base, const btVector3& aabb_min,
                                  const btVector3& aabb_max, btDispatcher*) {
  auto& proxy = static_cast<Proxy&>(*base);
  ProxyPool::prefetch_behind(proxy);
  if (margin_ == 0 && is_same(proxy.m_aabbMin, aabb_min) && is_same(proxy.m_aabbMax, aabb_max)) return;
  proxy.m_aabbMin = aabb_min;
  proxy.m_aabbMax = aabb_max;
  const BodyId id = proxy.id();
  if (margin_ > 0 && holds(told_[id], aabb_min, aabb_max)) return;
  Body& body = bodies_[id];
  if (!body.is_told) return;
  if (margin_ == 0) return moved_.put(id, box_of(aabb_min, aabb_max), body.place);
  told_[id] = fat_box_of(aabb_min, aabb_max, margin_);
  moved_.put(id, told_[id], body.place);
}

bool CellsweepBroadphase::has_moved(BodyId id) const {
  return moved_.has(id, bodies_[id].place);
}

void CellsweepBroadphase::forget_move(BodyId id) {
  if (!has_moved(id)) return;
  const std::uint32_t place = bodies_[id].place;
  bodies_[moved_.take_out(place)].place = place;
}

void CellsweepBroadphase::getAabb(btBroadphaseProxy* proxy, btVector3& aabb_min, btVector3& aabb_max) const {
  aabb_min = proxy->m_aabbMin;
  aabb_max = proxy->m_aabbMax;
}

// Bullet's own callback asks so for a ray from a point to itself: NaN is an end that is before everything.
void CellsweepBroadphase::rayTest(const btVector3& from, const btVector3&, btBroadphaseRayCallback& callback,
                                  const btVector3& aabb_min, const btVector3& aabb_max) {
  if (std::isnan(callback.m_lambda_max)) return;
  const auto path = path_of(from, callback, aabb_min, aabb_max);
  for (const Proxy* const proxy : path ? candidates(*path) : everybody()) {
    if (!bodies_[proxy->id()].is_there) continue;
    // A box that is cast along the ray makes the others larger.
    const btVector3 bounds[2] = {proxy->m_aabbMin - aabb_max, proxy->m_aabbMax - aabb_min};
    btScalar where = 1;
    if (btRayAabb2(from, callback.m_rayDirectionInverse, callback.m_signs, bounds, where, 0,
                   callback.m_lambda_max))
      callback.process(proxy);
  }
}

void CellsweepBroadphase::aabbTest(const btVector3& aabb_min, const btVector3& aabb_max,
                                   btBroadphaseAabbCallback& callback) {
  for (const Proxy* const proxy : candidates(box_of(aabb_min, aabb_max))) {
    if (bodies_[proxy->id()].is_there &&
        TestAabbAgainstAabb2(aabb_min, aabb_max, proxy->m_aabbMin, proxy->m_aabbMax))
      callback.process(proxy);
  }
}

// Each of these lists has all that may be asked for, once, and some more. It is the question's own, as
// process() may ask another.

CellsweepBroadphase::Proxies CellsweepBroadphase::candidates(const cellsweep::Path& path) const {
  std::vector<cellsweep::Touch> touches;
  if (!has_seen_all_ || !broadphase_.queries().find_touches(path, touches).ok()) return everybody();
  Proxies proxies;
  for (const cellsweep::Touch& touch : touches) add_seen(touch.body, proxies);
  add_unseen(proxies);
  return proxies;
}

CellsweepBroadphase::Proxies CellsweepBroadphase::candidates(const cellsweep::Aabb& box) const {
  std::vector<BodyId> ids;
  if (!has_seen_all_ || !broadphase_.queries().find_overlaps(box, ids).ok()) return everybody();
  Proxies proxies;
  for (const BodyId id : ids) add_seen(id, proxies);
  add_unseen(proxies);
  return proxies;
}

CellsweepBroadphase::Proxies CellsweepBroadphase::everybody() const {
  Proxies proxies;
  for (BodyId id = 0; id < proxies_.size(); ++id) proxies.push_back(&proxies_[id]);
  return proxies;
}

// The last update saw its box, or it is gone since.
void CellsweepBroadphase::add_seen(BodyId id, Proxies& proxies) const {
  if (!has_moved(id)) proxies.push_back(&proxies_[id]);
}

void CellsweepBroadphase::add_unseen(Proxies& proxies) const {
  for (const BodyId id : created_) proxies.push_back(&proxies_[id]);
  for (const BodyId id : moved_.ids()) proxies.push_back(&proxies_[id]);
}

void CellsweepBroadphase::getBroadphaseAabb(btVector3& aabb_min, btVector3& aabb_max) const {
  aabb_min.setValue(BT_LARGE_FLOAT, BT_LARGE_FLOAT, BT_LARGE_FLOAT);
  aabb_max = -aabb_min;
  for (BodyId id = 0; id < bodies_.size(); ++id) {
    if (!bodies_[id].is_there) continue;
    aabb_min.setMin(proxies_[id].m_aabbMin);
    aabb_max.setMax(proxies_[id].m_aabbMax);
  }
}

void CellsweepBroadphase::calculateOverlappingPairs(btDispatcher* dispatcher) {
  has_seen_all_ = false;  // also when something is thrown on the way
  status_ = tell_changes();
  if (!status_.ok()) return;
  const auto changes = broadphase_.update();
  if (!changes) {
    status_ = changes.status();
    return;
  }
  has_seen_all_ = true;
  for (const cellsweep::Pair& pair : changes->ended) {
    if (bodies_[pair.a].is_there && bodies_[pair.b].is_there)
      pairs_.removeOverlappingPair(&proxies_[pair.a], &proxies_[pair.b], dispatcher);
  }
  // The cache keeps a pair that it has.
  for (const cellsweep::Pair& pair : std::exchange(offers_all_, false) ? broadphase_.pairs() : changes->began)
    pairs_.addOverlappingPair(&proxies_[pair.a], &proxies_[pair.b]);
  free_.insert(free_.end(), gone_.begin(), gone_.end());
  gone_.clear();
}

// In most steps nobody comes or goes, and with a margin few have left it: a call that says nothing would only
// bring code and tables into the caches, which Bullet's own have put out of them.
Status CellsweepBroadphase::tell_changes() {
  if (Status status = tell_removed(); !status.ok()) return status;
  if (Status status = tell_filters(); !status.ok()) return status;
  if (Status status = tell_created(); !status.ok()) return status;
  return tell_moved();
}

Status CellsweepBroadphase::tell_removed() {
  if (removed_.empty()) return {};
  Status status = broadphase_.remove(removed_);
  if (status.ok()) removed_.clear();
  return status;
}

// Of the bodies that are there already, where a callback has come to decide, or gone.
Status CellsweepBroadphase::tell_filters() {
  const bool callback_decides = pairs_.getOverlapFilterCallback() != nullptr;
  if (callback_decides == callback_decides_) return {};
  callback_decides_ = callback_decides;
  ids_.clear();
  filters_.clear();
  for (BodyId id = 0; id < bodies_.size(); ++id) {
    if (!bodies_[id].is_told) continue;
    ids_.push_back(id);
    filters_.push_back(filter_of(proxies_[id]));
  }
  Status status = broadphase_.set_filters(ids_, filters_);
  if (status.ok()) {
    offers_all_ = true;
  } else {
    callback_decides_ = !callback_decides;
  }
  return status;
}

Status CellsweepBroadphase::tell_created() {
  if (created_.empty()) return {};
  ids_.clear();
  boxes_.clear();
  filters_.clear();
  for (const BodyId id : created_) {
    const Proxy& proxy = proxies_[id];
    if (!bodies_[id].is_there) continue;  // destroyed before anybody heard of it
    ids_.push_back(id);
    boxes_.push_back(box_of(proxy));
    filters_.push_back(filter_of(proxy));
  }
  Status status = broadphase_.insert(ids_, boxes_, filters_);
  if (!status.ok()) return status;
  for (std::size_t i = 0; i < ids_.size(); ++i) {
    bodies_[ids_[i]].is_told = true;
    if (margin_ > 0) told_[ids_[i]] = boxes_[i];
  }
  created_.clear();
  return status;
}

Status CellsweepBroadphase::tell_moved() {
  if (moved_.ids().empty()) return {};
  Status status = broadphase_.move(moved_.ids(), moved_.boxes());
  if (status.ok()) {
    moved_.clear();
  } else if (margin_ > 0) {
    // A fat box without an end would hold whatever comes next.
    for (const BodyId id : moved_.ids()) told_[id] = kHoldsNothing;
  }
  return status;
}

BodyFilter CellsweepBroadphase::filter_of(const Proxy& proxy) const {
  return callback_decides_ ? BodyFilter() : ::filter_of(proxy);
}

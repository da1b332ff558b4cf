/// @file
/// Where the proxies of a broadphase are.
#pragma once

#include <BulletCollision/BroadphaseCollision/btBroadphaseProxy.h>
#include <cellsweep/pair.h>

#include <cstddef>
#include <vector>

#include "prefetch.h"

/// A body of the broadphase, or a place for the next one. It has a line of the caches to itself: Bullet says
/// where each is in every step, which has put them out of the caches.
struct alignas(64) Proxy : btBroadphaseProxy {
  cellsweep::BodyId id() const { return static_cast<cellsweep::BodyId>(m_uniqueId) - 1; }
};

/// Proxies by id, which stay where they are, many in a row: an allocation of its own for each, among those of
/// Bullet's bodies, would be on another page. Throws std::bad_alloc and has added nothing then.
class ProxyPool {
 public:
  std::size_t size() const { return size_; }
  Proxy& operator[](std::size_t id) { return blocks_[id / kBlock][id % kBlock]; }
  const Proxy& operator[](std::size_t id) const { return blocks_[id / kBlock][id % kBlock]; }

  /// Gets the line of one that is asked for soon, when they are in the order in which they were added.
  static void prefetch_behind(const Proxy& proxy) {
    constexpr std::size_t kAhead = 32;
    if (proxy.id() % kBlock < kBlock - kAhead) prefetch((&proxy)[kAhead]);
  }

  Proxy& add() {
    if (size_ == blocks_.size() * kBlock) blocks_.emplace_back(kBlock);
    Proxy& proxy = (*this)[size_++];
    proxy.m_uniqueId = static_cast<int>(size_);
    return proxy;
  }

 private:
  static constexpr std::size_t kBlock = 1024;

  // Not by new: Bullet's own for proxies, which Proxy has from its base, aligns to 16 bytes only.
  std::vector<std::vector<Proxy>> blocks_;
  std::size_t size_ = 0;
};

/// @file
/// A broadphase of Bullet with a clock around it.
#pragma once

#include <BulletCollision/BroadphaseCollision/btBroadphaseInterface.h>

#include <chrono>
#include <memory>
#include <utility>
#include <vector>

namespace cellsweep::bench {

/// Boxes wait until calculateOverlappingPairs(), which Bullet calls next, so that a clock need not be read
/// for each of them; everything else goes straight on to the broadphase inside.
class TimedBroadphase final : public btBroadphaseInterface {
 public:
  explicit TimedBroadphase(std::unique_ptr<btBroadphaseInterface> inside) : inside_(std::move(inside)) {}

  /// What the boxes and pairs of the last step took.
  double seconds() const { return seconds_; }

  btBroadphaseProxy* createProxy(const btVector3& low, const btVector3& high, int shape, void* user,
                                 int group, int mask, btDispatcher* dispatcher) override {
    return inside_->createProxy(low, high, shape, user, group, mask, dispatcher);
  }
  void destroyProxy(btBroadphaseProxy* proxy, btDispatcher* dispatcher) override {
    inside_->destroyProxy(proxy, dispatcher);
  }
  void setAabb(btBroadphaseProxy* proxy, const btVector3& low, const btVector3& high,
               btDispatcher*) override {
    boxes_.push_back({proxy, low, high});
  }
  void getAabb(btBroadphaseProxy* proxy, btVector3& low, btVector3& high) const override {
    inside_->getAabb(proxy, low, high);
  }
  void rayTest(const btVector3& from, const btVector3& to, btBroadphaseRayCallback& callback,
               const btVector3& low, const btVector3& high) override {
    inside_->rayTest(from, to, callback, low, high);
  }
  void aabbTest(const btVector3& low, const btVector3& high, btBroadphaseAabbCallback& callback) override {
    inside_->aabbTest(low, high, callback);
  }
  void calculateOverlappingPairs(btDispatcher* dispatcher) override {
    const auto start = std::chrono::steady_clock::now();
    for (const Box& box : boxes_) inside_->setAabb(box.proxy, box.low, box.high, dispatcher);
    inside_->calculateOverlappingPairs(dispatcher);
    seconds_ = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    boxes_.clear();
  }
  btOverlappingPairCache* getOverlappingPairCache() override { return inside_->getOverlappingPairCache(); }
  const btOverlappingPairCache* getOverlappingPairCache() const override {
    return std::as_const(*inside_).getOverlappingPairCache();
  }
  void getBroadphaseAabb(btVector3& low, btVector3& high) const override {
    inside_->getBroadphaseAabb(low, high);
  }
  void printStats() override { inside_->printStats(); }

 private:
  struct Box {
    btBroadphaseProxy* proxy;
    btVector3 low;
    btVector3 high;
  };

  std::unique_ptr<btBroadphaseInterface> inside_;
  std::vector<Box> boxes_;
  double seconds_ = 0;
};

}  // namespace cellsweep::bench

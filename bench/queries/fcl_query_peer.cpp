/// @file
/// FCL's dynamic tree, asked for what an object collides with and how far it is from others.
#include <fcl/broadphase/broadphase_dynamic_AABB_tree.h>
#include <fcl/geometry/shape/box.h>
#include <fcl/narrowphase/collision_object.h>

#include "bench/queries/float_ray.h"
#include "bench/queries/query_peer.h"

namespace cellsweep::bench {
namespace {

/// An object that has our box in the place of one derived from a shape and a pose.
class BodyObject final : public fcl::CollisionObjectd {
 public:
  BodyObject(const std::shared_ptr<fcl::CollisionGeometryd>& shape, BodyId id)
      : fcl::CollisionObjectd(shape), id_(id) {}

  BodyId id() const { return id_; }

  void set_box(const Aabb& box) {
    for (int k = 0; k < 3; ++k) {
      aabb.min_[k] = static_cast<double>(box.min[static_cast<std::size_t>(k)]);
      aabb.max_[k] = static_cast<double>(box.max[static_cast<std::size_t>(k)]);
    }
  }

 private:
  BodyId id_;
};

BodyId id_of(const fcl::CollisionObjectd* object) {
  return static_cast<const BodyObject*>(object)->id();
}

class FclQueries final : public QueryPeer {
 public:
  ~FclQueries() override { manager_.clear(); }

  void build(std::span<const Aabb> boxes) override {
    boxes_ = boxes;
    std::vector<fcl::CollisionObjectd*> all;
    for (std::size_t id = 0; id < boxes.size(); ++id) {
      objects_.push_back(std::make_unique<BodyObject>(shape_, static_cast<BodyId>(id)));
      objects_.back()->set_box(boxes[id]);
      all.push_back(objects_.back().get());
    }
    manager_.registerObjects(all);
    manager_.setup();
  }

  void move(std::span<const BodyId> bodies) override {
    for (const BodyId body : bodies) objects_[body]->set_box(boxes_[body]);
    manager_.update();
  }

  void find_overlaps(const Aabb& box, std::vector<BodyId>& found) override {
    found.clear();
    question_.set_box(box);
    manager_.collide(&question_, &found, [](fcl::CollisionObjectd* body, fcl::CollisionObjectd*, void* list) {
      static_cast<std::vector<BodyId>*>(list)->push_back(id_of(body));
      return false;
    });
  }

  void find_nearest(const Point& point, std::size_t count, std::vector<Neighbor>& found) override {
    NearestHeap nearest(count, found);
    question_.set_box(box_at(point));
    manager_.distance(&question_, &nearest, offer);
    nearest.finish();
  }

 private:
  static bool offer(fcl::CollisionObjectd* body, fcl::CollisionObjectd* question, void* list, double& most) {
    auto* nearest = static_cast<NearestHeap*>(list);
    const double distance = body->getAABB().distance(question->getAABB());
    nearest->offer(id_of(body), static_cast<float>(distance * distance));
    most = std::sqrt(double{nearest->most()});
    return most == 0;
  }

  std::shared_ptr<fcl::CollisionGeometryd> shape_ = std::make_shared<fcl::Boxd>(1, 1, 1);
  BodyObject question_{shape_, 0};
  std::span<const Aabb> boxes_;
  std::vector<std::unique_ptr<BodyObject>> objects_;
  fcl::DynamicAABBTreeCollisionManagerd manager_;
};

}  // namespace

void add_fcl_query_peers(std::vector<QueryPeerInfo>& peers) {
  using enum QuestionKind;
  QueryPeerInfo info;
  info.name = "fcl";
  info.settings = "`DynamicAABBTreeCollisionManager`, `collide` and `distance` with an object of its own";
  info.answers = {boxes, big_boxes, points, nearest1, nearest8};
  info.make = [] { return std::make_unique<FclQueries>(); };
  peers.push_back(std::move(info));
}

}  // namespace cellsweep::bench

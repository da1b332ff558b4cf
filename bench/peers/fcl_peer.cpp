/// @file
/// FCL's dynamic tree and its sweep and prune, by its managers of collision objects.
#include <fcl/broadphase/broadphase_SaP.h>
#include <fcl/broadphase/broadphase_dynamic_AABB_tree.h>
#include <fcl/geometry/shape/box.h>
#include <fcl/narrowphase/collision_object.h>

#include <array>
#include <cstdint>

#include "bench/peers/peer_table.h"

namespace cellsweep::bench {
namespace {

/// An object that has our box, to the last bit, in the place of one derived from a shape and a pose.
class BoxObject final : public fcl::CollisionObjectd {
 public:
  BoxObject(const std::shared_ptr<fcl::CollisionGeometryd>& shape, BodyId id)
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

template <class Manager>
class FclPeer final : public Peer {
 public:
  ~FclPeer() override { manager_.clear(); }

  void prepare(const Stage& stage) override {
    const auto shape = std::make_shared<fcl::Boxd>(1, 1, 1);
    for (std::size_t id = 0; id < stage.boxes.size(); ++id) {
      objects_.push_back(std::make_unique<BoxObject>(shape, static_cast<BodyId>(id)));
      all_.push_back(objects_.back().get());
    }
  }

  void insert(std::span<const Aabb> boxes) override {
    for (std::size_t id = 0; id < boxes.size(); ++id) objects_[id]->set_box(boxes[id]);
    manager_.registerObjects(all_);
    manager_.setup();
    collide();
  }

  void update(std::span<const Aabb> boxes, const PeerChanges& changes) override {
    for (const BodyId id : changes.removed) manager_.unregisterObject(objects_[id].get());
    for (const BodyId id : changes.inserted) {
      objects_[id]->set_box(boxes[id]);
      manager_.registerObject(objects_[id].get());
    }
    moved_.clear();
    for (const BodyId id : changes.moved) {
      objects_[id]->set_box(boxes[id]);
      moved_.push_back(objects_[id].get());
    }
    if (moved_.size() == boxes.size()) {
      manager_.update();
    } else if (!moved_.empty()) {
      manager_.update(moved_);
    }
    collide();
  }

  void list_pairs(std::vector<Pair>& pairs) override { pairs.swap(found_); }

 private:
  static bool take_candidate(fcl::CollisionObjectd* one, fcl::CollisionObjectd* other, void* found) {
    if (one->getAABB().overlap(other->getAABB())) {
      static_cast<std::vector<Pair>*>(found)->push_back(
          make_pair_of(static_cast<BoxObject*>(one)->id(), static_cast<BoxObject*>(other)->id()));
    }
    return false;
  }

  void collide() {
    found_.clear();
    manager_.collide(&found_, take_candidate);
  }

  std::vector<std::unique_ptr<BoxObject>> objects_;
  std::vector<fcl::CollisionObjectd*> all_;
  std::vector<fcl::CollisionObjectd*> moved_;
  Manager manager_;
  std::vector<Pair> found_;
};

constexpr std::array<std::string_view, 4> kNotForSap = {"stacks", "pile", "level", "open-world"};

template <class Manager>
PeerInfo fcl_peer(std::string_view name, std::string_view settings, std::size_t most_bodies) {
  PeerInfo info;
  info.name = name;
  info.threads = "1";
  info.removes = true;
  info.margin = "none";
  info.settings = settings;
  info.exactness = "what `collide()` calls back for; tested again here";
  info.most_bodies = most_bodies;
  info.most_in_wall = 100'000;
  info.make = [] { return std::make_unique<FclPeer<Manager>>(); };
  return info;
}

}  // namespace

void add_fcl_peers(std::vector<PeerInfo>& peers) {
  peers.push_back(fcl_peer<fcl::DynamicAABBTreeCollisionManagerd>(
      "fcl_tree", "`DynamicAABBTreeCollisionManager`, all entered at once, moved ones updated singly",
      kAnyNumber));
  peers.push_back(fcl_peer<fcl::SaPCollisionManagerd>(
      "fcl_sap",
      "`SaPCollisionManager`, the same; 1,000 bodies at most: with 10,000 that all move in scene `wall` its "
      "`update()` did not return within a minute. Left out of `stacks` and `pile`, where it never returns, "
      "of "
      "`level`, where it misses pairs that touch, and of `open-world`, where it keeps pairs of objects that "
      "were taken out",
      1'000));
  peers.back().left_out = kNotForSap;
}

}  // namespace cellsweep::bench

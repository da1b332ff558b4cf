/// @file
/// Bullet's dynamic tree: its own queries, and walks through its nodes of the kind that a user would write
/// where it has none, or none that stops early.
#include <BulletCollision/BroadphaseCollision/btDbvt.h>

#include <array>
#include <cstdint>
#include <utility>

#include "bench/queries/float_ray.h"
#include "bench/queries/query_peer.h"

namespace cellsweep::bench {
namespace {

enum class Way {
  as_it_comes,  ///< collideTV() and rayTestInternal()
  nearest_first
};

btVector3 vector_of(const Point& corner) {
  return {corner[0], corner[1], corner[2]};
}

btDbvtVolume volume_of(const Aabb& box) {
  return btDbvtVolume::FromMM(vector_of(box.min), vector_of(box.max));
}

BodyId body_of(const btDbvtNode& leaf) {
  return static_cast<BodyId>(reinterpret_cast<std::uintptr_t>(leaf.data));
}

/// Calls a function with each leaf.
template <class Take>
struct Taker final : btDbvt::ICollide {
  explicit Taker(const Take& taken) : take(taken) {}
  void Process(const btDbvtNode* leaf) override { take(*leaf); }

  const Take& take;
};

class BulletQueries final : public QueryPeer {
 public:
  explicit BulletQueries(Way way) : way_(way) {}

  void build(std::span<const Aabb> boxes) override {
    boxes_ = boxes;
    for (std::size_t i = 0; i < boxes.size(); ++i) {
      leaves_.push_back(tree_.insert(volume_of(boxes[i]), reinterpret_cast<void*>(std::uintptr_t{i})));
    }
    tree_.optimizeTopDown();
  }

  // As btDbvtBroadphase does it: singly, then a hundredth of the tree anew.
  void move(std::span<const BodyId> bodies) override {
    for (const BodyId body : bodies) {
      btDbvtVolume volume = volume_of(boxes_[body]);
      tree_.update(leaves_[body], volume);
    }
    tree_.optimizeIncremental(1 + tree_.m_leaves / 100);
  }

  void find_overlaps(const Aabb& box, std::vector<BodyId>& found) override {
    found.clear();
    const auto take = [&](const btDbvtNode& leaf) { found.push_back(body_of(leaf)); };
    Taker taker(take);
    tree_.collideTVNoStackAlloc(tree_.m_root, volume_of(box), stack_, taker);
  }

  void find_within(const Point& center, float radius, std::vector<BodyId>& found) override {
    found.clear();
    Aabb around = box_at(center);
    for (std::size_t k = 0; k < 3; ++k) {
      around.min[k] -= radius;
      around.max[k] += radius;
    }
    const auto take = [&](const btDbvtNode& leaf) {
      if (square_of_distance(center, leaf.volume.Mins(), leaf.volume.Maxs()) <= radius * radius)
        found.push_back(body_of(leaf));
    };
    Taker taker(take);
    tree_.collideTVNoStackAlloc(tree_.m_root, volume_of(around), stack_, taker);
  }

  std::optional<Touch> first_touch(const Ray& ray) override {
    FloatRay path(ray);
    std::optional<Touch> first;
    const auto take = [&](const btDbvtNode& leaf) {
      const float time = path.enters(leaf.volume.Mins(), leaf.volume.Maxs());
      if (time > path.end) return;
      path.end = time;
      first = Touch{body_of(leaf), time};
    };
    if (way_ == Way::as_it_comes) {
      test_ray(ray, take);
    } else {
      walk_along(path, take);
    }
    return first;
  }

  bool any_touch(const Ray& ray) override {
    if (way_ == Way::as_it_comes) {
      bool any = false;
      test_ray(ray, [&](const btDbvtNode&) { any = true; });
      return any;
    }
    FloatRay path(ray);
    bool any = false;
    walk_along(path, [&](const btDbvtNode&) {
      any = true;
      path.end = -1;
    });
    return any;
  }

  void find_touches(const Ray& ray, std::vector<Touch>& found) override {
    found.clear();
    const FloatRay path(ray);
    test_ray(ray, [&](const btDbvtNode& leaf) {
      const float time = path.enters(leaf.volume.Mins(), leaf.volume.Maxs());
      if (time <= path.end) found.push_back({body_of(leaf), time});
    });
  }

  void find_nearest(const Point& point, std::size_t count, std::vector<Neighbor>& found) override {
    NearestHeap nearest(count, found);
    const auto distance = [&](const btDbvtNode& node) {
      return square_of_distance(point, node.volume.Mins(), node.volume.Maxs());
    };
    walk(
        distance, [&] { return nearest.most(); },
        [&](const btDbvtNode& leaf, float square) { nearest.offer(body_of(leaf), square); });
    nearest.finish();
  }

 private:
  template <class Take>
  void test_ray(const Ray& ray, const Take& take) {
    const FloatRay path(ray);
    const btVector3 inverse(path.inverse[0], path.inverse[1], path.inverse[2]);
    unsigned signs[3] = {inverse[0] < 0, inverse[1] < 0, inverse[2] < 0};
    const btVector3 none(0, 0, 0);
    Taker taker(take);
    tree_.rayTestInternal(tree_.m_root, vector_of(ray.origin), none, inverse, signs, path.end, none, none,
                          ray_stack_, taker);
  }

  template <class Take>
  void walk_along(FloatRay& path, const Take& take) {
    const auto enters = [&](const btDbvtNode& node) {
      return path.enters(node.volume.Mins(), node.volume.Maxs());
    };
    walk(
        enters, [&] { return path.end; }, [&](const btDbvtNode& leaf, float) { take(leaf); });
  }

  /// Of two children the nearer one first; `most` says from where on a node is too far.
  template <class Key, class Most, class Take>
  void walk(const Key& key, const Most& most, const Take& take) {
    waiting_.clear();
    if (tree_.m_root == nullptr) return;
    waiting_.push_back({tree_.m_root, key(*tree_.m_root)});
    while (!waiting_.empty()) {
      const auto [node, distance] = waiting_.back();
      waiting_.pop_back();
      if (!(distance <= most())) continue;
      if (node->isleaf()) {
        take(*node, distance);
        continue;
      }
      Waiting near{node->childs[0], key(*node->childs[0])};
      Waiting far{node->childs[1], key(*node->childs[1])};
      if (far.distance < near.distance) std::swap(near, far);
      if (far.distance <= most()) waiting_.push_back(far);
      if (near.distance <= most()) waiting_.push_back(near);
    }
  }

  struct Waiting {
    const btDbvtNode* node;
    float distance;
  };

  Way way_;
  btDbvt tree_;
  std::span<const Aabb> boxes_;
  std::vector<btDbvtNode*> leaves_;
  btNodeStack stack_;
  btAlignedObjectArray<const btDbvtNode*> ray_stack_;
  std::vector<Waiting> waiting_;
};

}  // namespace

void add_bullet_query_peers(std::vector<QueryPeerInfo>& peers) {
  using enum QuestionKind;
  QueryPeerInfo tree;
  tree.name = "bullet";
  tree.settings = "`btDbvt`, `collideTV` and `rayTestInternal`; after all were entered, `optimizeTopDown`";
  tree.answers = {boxes, big_boxes, points, radius, rays, down, segments, any, all};
  tree.make = [] { return std::make_unique<BulletQueries>(Way::as_it_comes); };
  peers.push_back(tree);
  QueryPeerInfo walk = tree;
  walk.name = "bullet_walk";
  walk.settings = "the same tree, walked through by us: nearer nodes first, none behind what was found";
  walk.answers = {rays, down, segments, any, nearest1, nearest8};
  walk.make = [] { return std::make_unique<BulletQueries>(Way::nearest_first); };
  peers.push_back(std::move(walk));
}

}  // namespace cellsweep::bench

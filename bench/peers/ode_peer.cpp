/// @file
/// ODE's sweep and prune space, with a class of geometries of our own that hand out our boxes.
#include <ode/ode.h>

#include <cstdint>

#include "bench/peers/peer_table.h"

namespace cellsweep::bench {
namespace {

/// What ODE keeps for a geometry of ours.
struct GeometryData {
  Aabb box;
};

void tell_bounds(dGeomID geometry, dReal bounds[6]) {
  const Aabb& box = static_cast<const GeometryData*>(dGeomGetClassData(geometry))->box;
  for (std::size_t k = 0; k < 3; ++k) {
    bounds[2 * k] = static_cast<dReal>(box.min[k]);
    bounds[2 * k + 1] = static_cast<dReal>(box.max[k]);
  }
}

dColliderFn* no_collider(int) {
  return nullptr;
}

// ODE has room for four classes, for good.
int geometry_class() {
  static const int number = [] {
    dInitODE2(0);
    dGeomClass description{};
    description.bytes = sizeof(GeometryData);
    description.collider = no_collider;
    description.aabb = tell_bounds;
    return dCreateGeomClass(&description);
  }();
  return number;
}

class OdePeer final : public Peer {
 public:
  ~OdePeer() override {
    // A geometry that is destroyed leaves its space.
    for (const dGeomID geometry : geometries_) dGeomDestroy(geometry);
    if (space_ != nullptr) dSpaceDestroy(space_);
  }

  void prepare(const Stage& stage) override {
    for (std::size_t id = 0; id < stage.boxes.size(); ++id) {
      geometries_.push_back(dCreateGeom(geometry_class()));
      dGeomSetData(geometries_.back(), reinterpret_cast<void*>(static_cast<std::uintptr_t>(id)));
    }
  }

  void insert(std::span<const Aabb> boxes) override {
    boxes_ = boxes;
    space_ = dSweepAndPruneSpaceCreate(nullptr, dSAP_AXES_XZY);
    for (std::size_t id = 0; id < boxes.size(); ++id) enter(id);
    collide();
  }

  void update(std::span<const Aabb> boxes, const PeerChanges& changes) override {
    boxes_ = boxes;
    for (const BodyId id : changes.removed) dSpaceRemove(space_, geometries_[id]);
    for (const BodyId id : changes.inserted) enter(id);
    for (const BodyId id : changes.moved) set_box(id);
    collide();
  }

  void list_pairs(std::vector<Pair>& pairs) override { pairs.swap(found_); }

 private:
  void enter(std::size_t id) {
    set_box(id);
    dSpaceAdd(space_, geometries_[id]);
  }

  // Setting a place is how a geometry says that its bounds are no longer what they were.
  void set_box(std::size_t id) {
    const Aabb& box = boxes_[id];
    static_cast<GeometryData*>(dGeomGetClassData(geometries_[id]))->box = box;
    dGeomSetPosition(geometries_[id], static_cast<dReal>(box.min[0]), static_cast<dReal>(box.min[1]),
                     static_cast<dReal>(box.min[2]));
  }

  static void take_candidate(void* user, dGeomID one, dGeomID other) {
    auto* self = static_cast<OdePeer*>(user);
    const Pair pair = make_pair_of(id_of(one), id_of(other));
    if (overlap(self->boxes_[pair.a], self->boxes_[pair.b])) self->found_.push_back(pair);
  }

  static BodyId id_of(dGeomID geometry) {
    return static_cast<BodyId>(reinterpret_cast<std::uintptr_t>(dGeomGetData(geometry)));
  }

  void collide() {
    found_.clear();
    dSpaceCollide(space_, this, take_candidate);
  }

  dSpaceID space_ = nullptr;
  std::vector<dGeomID> geometries_;
  std::span<const Aabb> boxes_;
  std::vector<Pair> found_;
};

}  // namespace

void add_ode_peers(std::vector<PeerInfo>& peers) {
  PeerInfo info;
  info.name = "ode_sap";
  info.threads = "1";
  info.removes = true;
  info.margin = "none";
  info.settings = "`dSweepAndPruneSpaceCreate`, axes XZY; it sorts anew in each frame";
  info.exactness = "what `dSpaceCollide` calls back for; tested again here";
  info.most_bodies = 100'000;
  info.make = [] { return std::make_unique<OdePeer>(); };
  peers.push_back(std::move(info));
}

}  // namespace cellsweep::bench

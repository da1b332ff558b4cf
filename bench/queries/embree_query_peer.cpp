/// @file
/// Embree's tree over user geometry, asked by rays and by point queries.
#include <embree3/rtcore.h>

#include <cmath>
#include <limits>
#include <string>
#include <thread>
#include <type_traits>

#include "base/inside_embree.h"
#include "bench/queries/float_ray.h"
#include "bench/queries/query_peer.h"

namespace cellsweep::bench {
namespace {

using embree::CalledByEmbree;
using embree::InsideEmbree;

/// What a ray's callbacks get beside Embree's own context.
struct RayContext {
  RTCIntersectContext context;  // first: Embree hands out its address
  const FloatRay* path;
  std::vector<Touch>* all;  ///< none: only the first is wanted
};

/// What a point query's callback gets.
struct NearContext {
  std::span<const Aabb> boxes;
  const Point* center;
  const Aabb* box;  ///< bodies that overlap this, if any,
  float square;     ///< or are within this distance, squared,
  std::vector<BodyId>* found;
  NearestHeap* nearest;  ///< or the nearest
};

class EmbreeQueries final : public QueryPeer {
 public:
  explicit EmbreeQueries(bool refit) : refit_(refit) {
    const InsideEmbree inside(this);
    device_.reset(rtcNewDevice(("threads=" + std::to_string(std::thread::hardware_concurrency())).c_str()));
  }
  ~EmbreeQueries() override {
    const InsideEmbree inside(this);
    geometry_.reset();
    scene_.reset();
    device_.reset();
  }
  EmbreeQueries(const EmbreeQueries&) = delete;
  EmbreeQueries& operator=(const EmbreeQueries&) = delete;

  void build(std::span<const Aabb> boxes) override {
    boxes_ = boxes;
    const InsideEmbree inside(this);
    scene_.reset(rtcNewScene(device_.get()));
    rtcSetSceneFlags(scene_.get(), refit_ ? RTC_SCENE_FLAG_DYNAMIC : RTC_SCENE_FLAG_NONE);
    rtcSetSceneBuildQuality(scene_.get(), RTC_BUILD_QUALITY_MEDIUM);
    geometry_.reset(rtcNewGeometry(device_.get(), RTC_GEOMETRY_TYPE_USER));
    rtcSetGeometryBuildQuality(geometry_.get(), refit_ ? RTC_BUILD_QUALITY_REFIT : RTC_BUILD_QUALITY_MEDIUM);
    rtcSetGeometryUserPrimitiveCount(geometry_.get(), static_cast<unsigned>(boxes.size()));
    rtcSetGeometryUserData(geometry_.get(), this);
    rtcSetGeometryBoundsFunction(geometry_.get(), tell_bounds, nullptr);
    rtcSetGeometryIntersectFunction(geometry_.get(), meet);
    rtcSetGeometryOccludedFunction(geometry_.get(), hide);
    rtcCommitGeometry(geometry_.get());
    rtcAttachGeometry(scene_.get(), geometry_.get());
    rtcCommitScene(scene_.get());
  }

  void move(std::span<const BodyId> /*bodies*/) override {
    const InsideEmbree inside(this);
    rtcCommitGeometry(geometry_.get());
    rtcCommitScene(scene_.get());
  }

  // It has no query by a box: those are sought that are as near as its corners are, a little more for
  // rounding.
  void find_overlaps(const Aabb& box, std::vector<BodyId>& found) override {
    Point center{};
    float square = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      center[k] = 0.5F * (box.min[k] + box.max[k]);
      const float half = std::max(center[k] - box.min[k], box.max[k] - center[k]);
      square += half * half;
    }
    found.clear();
    NearContext context{boxes_, &center, &box, 0, &found, nullptr};
    const float reach = std::sqrt(square) * 1.00001F + 1e-30F;
    ask_near(center, reach, context);
  }

  void find_within(const Point& center, float radius, std::vector<BodyId>& found) override {
    found.clear();
    NearContext context{boxes_, &center, nullptr, radius * radius, &found, nullptr};
    ask_near(center, radius * 1.00001F, context);
  }

  std::optional<Touch> first_touch(const Ray& ray) override {
    const FloatRay path(ray);
    RayContext context = context_of(path, nullptr);
    const RTCRayHit hit = send(ray, context);
    if (hit.hit.geomID == RTC_INVALID_GEOMETRY_ID) return std::nullopt;
    return Touch{hit.hit.primID, hit.ray.tfar};
  }

  bool any_touch(const Ray& ray) override {
    const FloatRay path(ray);
    RayContext context = context_of(path, nullptr);
    RTCRay sent = ray_of(ray);
    rtcOccluded1(scene_.get(), &context.context, &sent);
    return sent.tfar < 0;
  }

  void find_touches(const Ray& ray, std::vector<Touch>& found) override {
    found.clear();
    const FloatRay path(ray);
    RayContext context = context_of(path, &found);
    send(ray, context);
  }

  void find_nearest(const Point& point, std::size_t count, std::vector<Neighbor>& found) override {
    NearestHeap nearest(count, found);
    NearContext context{boxes_, &point, nullptr, 0, nullptr, &nearest};
    ask_near(point, std::numeric_limits<float>::infinity(), context);
    nearest.finish();
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

  static RayContext context_of(const FloatRay& path, std::vector<Touch>* all) {
    RayContext context;
    rtcInitIntersectContext(&context.context);
    context.path = &path;
    context.all = all;
    return context;
  }

  static RTCRay ray_of(const Ray& ray) {
    RTCRay sent{};
    sent.org_x = ray.origin[0];
    sent.org_y = ray.origin[1];
    sent.org_z = ray.origin[2];
    sent.dir_x = static_cast<float>(ray.direction[0]);
    sent.dir_y = static_cast<float>(ray.direction[1]);
    sent.dir_z = static_cast<float>(ray.direction[2]);
    sent.tfar = static_cast<float>(ray.end);
    sent.mask = ~0U;
    return sent;
  }

  RTCRayHit send(const Ray& ray, RayContext& context) {
    RTCRayHit hit{};
    hit.ray = ray_of(ray);
    hit.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    rtcIntersect1(scene_.get(), &context.context, &hit);
    return hit;
  }

  void ask_near(const Point& center, float radius, NearContext& context) {
    RTCPointQuery query{center[0], center[1], center[2], 0, radius};
    RTCPointQueryContext stack;
    rtcInitPointQueryContext(&stack);
    rtcPointQuery(scene_.get(), &query, &stack, look_at, &context);
  }

  static void tell_bounds(const RTCBoundsFunctionArguments* arguments) {
    const auto* self = static_cast<const EmbreeQueries*>(arguments->geometryUserPtr);
    const CalledByEmbree called(self);
    const Aabb& box = self->boxes_[arguments->primID];
    *arguments->bounds_o = {box.min[0], box.min[1], box.min[2], 0, box.max[0], box.max[1], box.max[2], 0};
  }

  // Rays are sent singly: N is 1.
  static void meet(const RTCIntersectFunctionNArguments* arguments) {
    const auto* self = static_cast<const EmbreeQueries*>(arguments->geometryUserPtr);
    const auto* context = reinterpret_cast<const RayContext*>(arguments->context);
    const Aabb& box = self->boxes_[arguments->primID];
    const float time = context->path->enters(box.min.data(), box.max.data());
    auto* hit = reinterpret_cast<RTCRayHit*>(arguments->rayhit);
    if (!(time <= hit->ray.tfar)) return;
    if (context->all != nullptr) return context->all->push_back({arguments->primID, time});
    hit->ray.tfar = time;
    hit->hit.primID = arguments->primID;
    hit->hit.geomID = arguments->geomID;
  }

  static void hide(const RTCOccludedFunctionNArguments* arguments) {
    const auto* self = static_cast<const EmbreeQueries*>(arguments->geometryUserPtr);
    const auto* context = reinterpret_cast<const RayContext*>(arguments->context);
    const Aabb& box = self->boxes_[arguments->primID];
    auto* ray = reinterpret_cast<RTCRay*>(arguments->ray);
    if (context->path->enters(box.min.data(), box.max.data()) <= ray->tfar)
      ray->tfar = -std::numeric_limits<float>::infinity();
  }

  static bool look_at(RTCPointQueryFunctionArguments* arguments) {
    const auto& context = *static_cast<const NearContext*>(arguments->userPtr);
    const Aabb& box = context.boxes[arguments->primID];
    if (context.box != nullptr) {
      if (overlap(box, *context.box)) context.found->push_back(arguments->primID);
      return false;
    }
    const float square = square_of_distance(*context.center, box.min.data(), box.max.data());
    if (context.nearest == nullptr) {
      if (square <= context.square) context.found->push_back(arguments->primID);
      return false;
    }
    context.nearest->offer(arguments->primID, square);
    const float reach = std::sqrt(context.nearest->most()) * 1.00001F + 1e-30F;
    if (!(reach < arguments->query->radius)) return false;
    arguments->query->radius = reach;
    return true;
  }

  bool refit_;
  Device device_;
  Scene scene_;
  Geometry geometry_;
  std::span<const Aabb> boxes_;
};

}  // namespace

void add_embree_query_peers(std::vector<QueryPeerInfo>& peers) {
  QueryPeerInfo medium;
  medium.name = "embree";
  medium.settings =
      "user geometry, medium quality; `rtcIntersect1`, `rtcOccluded1`, `rtcPointQuery` (a box by its sphere)";
  for (const QuestionKindInfo& kind : kQuestionKinds) medium.answers.push_back(kind.kind);
  medium.make = [] { return std::make_unique<EmbreeQueries>(false); };
  peers.push_back(medium);
  QueryPeerInfo refit = medium;
  refit.name = "embree_refit";
  refit.settings = "the same for bodies that move: the tree refitted";
  refit.only_when_moved = true;
  refit.make = [] { return std::make_unique<EmbreeQueries>(true); };
  peers.push_back(std::move(refit));
}

}  // namespace cellsweep::bench

#include "report/picture/solids.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <new>
#include <utility>

#include "base/inside_embree.h"

namespace cellsweep::report {
namespace {

using Eigen::Vector3f;
using embree::CalledByEmbree;
using embree::InsideEmbree;

constexpr float kNowhere = std::numeric_limits<float>::infinity();

/// The stretch of a ray inside a solid, and the axis through whose face it comes in.
struct Stretch {
  float in = 0;
  float out = 0;
  int axis = 0;
};

// The ray as the solid sees it.
std::pair<Vector3f, Vector3f> local_ray(const Solid& solid, const Vector3f& origin,
                                        const Vector3f& direction) {
  return {solid.axes.transpose() * (origin - solid.centre), solid.axes.transpose() * direction};
}

// Empty (in > out) when the ray misses. A ray along a face divides 0 by 0; min and max drop what comes of it.
Stretch cut(const Solid& solid, const Vector3f& from, const Vector3f& along) {
  Stretch stretch{-kNowhere, kNowhere, 0};
  for (int axis = 0; axis < 3; ++axis) {
    const float inverse = 1 / along[axis];
    const float one = (-solid.half_extents[axis] - from[axis]) * inverse;
    const float other = (solid.half_extents[axis] - from[axis]) * inverse;
    const float near = std::min(one, other);
    if (near > stretch.in) {
      stretch.in = near;
      stretch.axis = axis;
    }
    stretch.out = std::min(stretch.out, std::max(one, other));
  }
  return stretch;
}

// How far along the ray its entry into the solid is; infinity for one that misses or begins inside.
float entry_distance(const Solid& solid, const Vector3f& origin, const Vector3f& direction) {
  const auto [from, along] = local_ray(solid, origin, direction);
  const Stretch stretch = cut(solid, from, along);
  if (stretch.in > 0 && stretch.in <= stretch.out) return stretch.in;
  return kNowhere;
}

Hit describe_hit(const Solid& solid, std::uint32_t number, const Ray& ray) {
  const auto [from, along] = local_ray(solid, ray.origin, ray.direction);
  const Stretch stretch = cut(solid, from, along);
  Hit hit{number, stretch.in, solid.axes.col(stretch.axis), kNowhere};
  if (along[stretch.axis] > 0) hit.normal = -hit.normal;
  const Vector3f point = from + stretch.in * along;
  for (int axis = 0; axis < 3; ++axis) {
    if (axis == stretch.axis) continue;
    hit.edge_distance = std::min(hit.edge_distance, solid.half_extents[axis] - std::fabs(point[axis]));
  }
  return hit;
}

template <class EmbreeRay>
EmbreeRay embree_ray(const Ray& ray) {
  EmbreeRay result{};
  result.org_x = ray.origin.x();
  result.org_y = ray.origin.y();
  result.org_z = ray.origin.z();
  result.dir_x = ray.direction.x();
  result.dir_y = ray.direction.y();
  result.dir_z = ray.direction.z();
  result.tfar = kNowhere;
  result.mask = ~0U;
  return result;
}

}  // namespace

Solid solid_of(const BodyPose& pose) {
  const auto& q = pose.orientation;
  const Eigen::Quaternionf turn(q[3], q[0], q[1], q[2]);
  return {Vector3f(pose.centre[0], pose.centre[1], pose.centre[2]),
          Vector3f(pose.half_extents[0], pose.half_extents[1], pose.half_extents[2]),
          turn.normalized().toRotationMatrix()};
}

Solids::Solids(std::vector<Solid> solids) : solids_(std::move(solids)) {
  const InsideEmbree inside(this);
  device_ = rtcNewDevice(nullptr);
  if (device_ == nullptr) throw std::bad_alloc();
  scene_ = rtcNewScene(device_);
  rtcSetSceneFlags(scene_, RTC_SCENE_FLAG_ROBUST);
  RTCGeometry geometry = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_USER);
  rtcSetGeometryUserPrimitiveCount(geometry, static_cast<unsigned>(solids_.size()));
  rtcSetGeometryUserData(geometry, this);
  rtcSetGeometryBoundsFunction(geometry, tell_bounds, nullptr);
  rtcSetGeometryIntersectFunction(geometry, intersect);
  rtcSetGeometryOccludedFunction(geometry, occlude);
  rtcCommitGeometry(geometry);
  rtcAttachGeometry(scene_, geometry);
  rtcReleaseGeometry(geometry);
  rtcCommitScene(scene_);
  if (rtcGetDeviceError(device_) != RTC_ERROR_NONE) {
    release();
    throw std::bad_alloc();
  }
}

Solids::~Solids() {
  const InsideEmbree inside(this);
  release();
}

void Solids::release() {
  if (scene_ != nullptr) rtcReleaseScene(scene_);
  rtcReleaseDevice(device_);
}

void Solids::tell_bounds(const RTCBoundsFunctionArguments* arguments) {
  const auto* self = static_cast<const Solids*>(arguments->geometryUserPtr);
  const CalledByEmbree called(self);
  const Solid& solid = self->solids_[arguments->primID];
  const Vector3f reach = solid.axes.cwiseAbs() * solid.half_extents;
  const float margin = 1e-5F * (reach.maxCoeff() + solid.centre.cwiseAbs().maxCoeff());
  const Vector3f low = solid.centre - reach - Vector3f::Constant(margin);
  const Vector3f high = solid.centre + reach + Vector3f::Constant(margin);
  *arguments->bounds_o = {low.x(), low.y(), low.z(), 0, high.x(), high.y(), high.z(), 0};
}

void Solids::intersect(const RTCIntersectFunctionNArguments* arguments) {
  if (arguments->valid[0] == 0) return;
  const auto* self = static_cast<const Solids*>(arguments->geometryUserPtr);
  auto* found = reinterpret_cast<RTCRayHit*>(arguments->rayhit);
  RTCRay& ray = found->ray;
  const float distance = entry_distance(self->solids_[arguments->primID], {ray.org_x, ray.org_y, ray.org_z},
                                        {ray.dir_x, ray.dir_y, ray.dir_z});
  const bool nearer = distance < ray.tfar;
  const bool first_of_equals = distance == ray.tfar && arguments->primID < found->hit.primID;
  if (distance == kNowhere || !(nearer || first_of_equals)) return;
  ray.tfar = distance;
  found->hit.primID = arguments->primID;
  found->hit.geomID = arguments->geomID;
}

void Solids::occlude(const RTCOccludedFunctionNArguments* arguments) {
  if (arguments->valid[0] == 0) return;
  const auto* self = static_cast<const Solids*>(arguments->geometryUserPtr);
  RTCRay& ray = *reinterpret_cast<RTCRay*>(arguments->ray);
  const float distance = entry_distance(self->solids_[arguments->primID], {ray.org_x, ray.org_y, ray.org_z},
                                        {ray.dir_x, ray.dir_y, ray.dir_z});
  if (distance < kNowhere) ray.tfar = -kNowhere;
}

bool Solids::first_hit(const Ray& ray, Hit& hit) const {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  RTCRayHit found{};
  found.ray = embree_ray<RTCRay>(ray);
  found.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  found.hit.primID = RTC_INVALID_GEOMETRY_ID;
  rtcIntersect1(scene_, &context, &found);
  if (found.hit.geomID == RTC_INVALID_GEOMETRY_ID) return false;
  hit = describe_hit(solids_[found.hit.primID], found.hit.primID, ray);
  return true;
}

bool Solids::is_blocked(const Ray& ray) const {
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  RTCRay shadow = embree_ray<RTCRay>(ray);
  rtcOccluded1(scene_, &context, &shadow);
  return shadow.tfar < 0;
}

}  // namespace cellsweep::report

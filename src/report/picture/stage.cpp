#include "report/picture/stage.h"

#include <algorithm>
#include <cmath>

#include "cellsweep/world/eigen.h"
#include "cellsweep/world/world.h"

namespace cellsweep::report {
namespace {

using Eigen::Vector3f;

constexpr float kFrameThickness = 0.0018F;  // lengths in edges of the world
constexpr float kStepOff = 2e-5F;
constexpr float kFloorCells = 10;
constexpr float kSunWidth = 0.035F;
constexpr unsigned kSunPurpose = 1;
constexpr unsigned kSkyPurpose = 2;

const Light kPaper(0.90F, 0.93F, 0.96F);
const Light kFloor(0.60F, 0.62F, 0.66F);
const Light kFrame(0.06F, 0.08F, 0.12F);
const Light kSun(0.86F, 0.80F, 0.70F);
const Light kSky(0.46F, 0.52F, 0.60F);
const Light kShade(0.11F, 0.115F, 0.12F);
const Vector3f kToSun = Vector3f(0.30F, 0.86F, 0.42F).normalized();

// The world's colours are as a screen shows them; light adds up by their squares, more or less.
Light linear(const Color& color) {
  return {color[0] * color[0], color[1] * color[1], color[2] * color[2]};
}

// Eight that a person tells apart, also one who sees no red or green; then the same again, darker.
Color color_of_group(std::uint32_t group) {
  constexpr Color kColors[] = {{0.90F, 0.62F, 0.00F}, {0.34F, 0.71F, 0.91F}, {0.00F, 0.62F, 0.45F},
                               {0.94F, 0.89F, 0.26F}, {0.00F, 0.45F, 0.70F}, {0.84F, 0.37F, 0.00F},
                               {0.80F, 0.47F, 0.65F}, {0.70F, 0.70F, 0.75F}};
  constexpr float kDarker[] = {1.0F, 0.72F, 0.5F};
  Color color = kColors[group % std::size(kColors)];
  for (float& part : color) part *= kDarker[group / std::size(kColors) % std::size(kDarker)];
  return color;
}

// The twelve edges of a box, as thin bars.
void add_frame(const Aabb& world, float thickness, std::vector<Solid>& solids) {
  const Eigen::AlignedBox3f bounds = to_eigen(world);
  for (int axis = 0; axis < 3; ++axis) {
    for (int corner = 0; corner < 4; ++corner) {
      const int one = (axis + 1) % 3;
      const int other = (axis + 2) % 3;
      Vector3f centre = bounds.center();
      centre[one] = (corner & 1) != 0 ? bounds.max()[one] : bounds.min()[one];
      centre[other] = (corner & 2) != 0 ? bounds.max()[other] : bounds.min()[other];
      Vector3f half_extents = Vector3f::Constant(thickness);
      half_extents[axis] = 0.5F * bounds.sizes()[axis] + thickness;
      solids.push_back({centre, half_extents, Eigen::Matrix3f::Identity()});
    }
  }
}

std::vector<Solid> solids_of(const Tableau& tableau, float thickness) {
  std::vector<Solid> solids;
  solids.reserve(tableau.bodies.size() + 12 * (1 + tableau.frames.size()));
  for (const BodyPose& pose : tableau.bodies) solids.push_back(solid_of(pose));
  add_frame(tableau.world, thickness, solids);
  for (const Aabb& frame : tableau.frames) add_frame(frame, 2 * thickness, solids);
  return solids;
}

float longest_edge(const Aabb& world) {
  return to_eigen(world).sizes().maxCoeff();
}

// 0 on a line of the floor's grid, 1 off it.
float off_line(float place, float half_width) {
  return std::fabs(place - std::floor(place + 0.5F)) < half_width ? 0.0F : 1.0F;
}

}  // namespace

Stage::Stage(const Tableau& tableau)
    : world_(tableau.world),
      centre_(to_eigen(tableau.world).center()),
      size_(longest_edge(tableau.world)),
      colliding_(tableau.colliding),
      groups_(tableau.groups),
      solids_(solids_of(tableau, kFrameThickness * longest_edge(tableau.world))) {}

Light Stage::albedo_of(const Hit& hit) const {
  if (hit.solid >= colliding_.size()) return kFrame;
  static const WorldColors colors;
  const Light albedo = linear(!groups_.empty()        ? color_of_group(groups_[hit.solid])
                              : colliding_[hit.solid] ? colors.colliding
                                                      : colors.plain);
  // A fine dark line along its edges tells a box from the one behind.
  return hit.edge_distance < 0.0012F * size_ ? Light(0.45F * albedo) : albedo;
}

// Lines every tenth of the world, and nothing beyond it.
Light Stage::floor_albedo(const Vector3f& point) const {
  const float cell = size_ / kFloorCells;
  const float x = (point.x() - world_.min[0]) / cell;
  const float z = (point.z() - world_.min[2]) / cell;
  const bool inside = point.x() > world_.min[0] && point.x() < world_.max[0] && point.z() > world_.min[2] &&
                      point.z() < world_.max[2];
  const float line = inside ? off_line(x, 0.016F) * off_line(z, 0.016F) : 1.0F;
  return kFloor * (0.62F + 0.38F * line);
}

bool Stage::meets_floor(const Ray& ray, Vector3f& point) const {
  const float height = ray.origin.y() - world_.min[1];
  if (ray.direction.y() >= 0 || height <= 0) return false;
  point = ray.origin - ray.direction * (height / ray.direction.y());
  return true;
}

Light Stage::lit(const Surface& surface, const Samples& samples, unsigned index) const {
  const Vector3f origin = surface.point + surface.normal * (kStepOff * size_);
  Light light = kShade;
  const Point2 disk = on_disk(samples.point(index, kSunPurpose));
  const Vector3f to_sun = around(kToSun, {kSunWidth * disk.x, kSunWidth * disk.y}, 1);
  const float facing = surface.normal.dot(to_sun);
  if (facing > 0 && !solids_.is_blocked({origin, to_sun})) light += kSun * facing;
  const Vector3f to_sky = above_surface(surface.normal, samples.point(index, kSkyPurpose));
  if (!solids_.is_blocked({origin, to_sky})) {
    const float height = to_sky.y();
    light += height > 0 ? Light(kSky * (0.75F + 0.35F * height)) : Light(kFloor * 0.22F);
  }
  return surface.albedo.cwiseProduct(light);
}

Light Stage::seen_by(const Ray& ray, const Samples& samples, unsigned index) const {
  Hit hit;
  if (solids_.first_hit(ray, hit)) {
    const Vector3f point = ray.origin + ray.direction * hit.distance;
    return lit({point, hit.normal, albedo_of(hit)}, samples, index);
  }
  Vector3f point;
  if (!meets_floor(ray, point)) return kPaper;
  // The floor fades away instead of having an end.
  const float away = (point - Vector3f(centre_.x(), point.y(), centre_.z())).norm() / size_;
  const float fade = std::clamp((away - 0.75F) / 0.9F, 0.0F, 1.0F);
  if (fade >= 1) return kPaper;
  const Light floor = lit({point, Vector3f::UnitY(), floor_albedo(point)}, samples, index);
  return kPaper * fade + floor * (1 - fade);
}

}  // namespace cellsweep::report

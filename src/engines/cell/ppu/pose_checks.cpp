#include "engines/cell/ppu/pose_checks.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "base/text.h"
#include "geometry/canonical.h"

namespace cellsweep::cell {
namespace {

constexpr double kShortest = 0x1p-10;
constexpr double kLongest = 0x1p10;

double squared_length(const BodyPose& pose) {
  double sum = 0;
  for (const double x : pose.orientation) sum += x * x;
  return sum;
}

// A NaN fails every comparison.
bool has_good_orientation(const BodyPose& pose) {
  const double square = squared_length(pose);
  return square >= kShortest * kShortest && square <= kLongest * kLongest;
}

bool has_good_extents(const BodyPose& pose) {
  return std::ranges::all_of(pose.half_extents, [](float extent) { return extent >= 0; });
}

// Any rotation: an axis may be reached by the three extents together at most.
bool is_in_reach(const BodyPose& pose) {
  double extent = 0;
  for (const double half : pose.half_extents) extent += half;
  return std::ranges::all_of(
      pose.centre, [&](double centre) { return std::fabs(centre) + extent <= double{kLargestPoseReach}; });
}

std::string describe_fault(const BodyPose& pose) {
  if (!has_good_orientation(pose)) {
    return text("its orientation's length is ", std::sqrt(squared_length(pose)),
                ", which is not from 1/1024 to 1024");
  }
  if (!has_good_extents(pose)) return "a half extent is not 0 or more";
  return text("centre and half extents are not finite or reach further than ", kLargestPoseReach);
}

BodyPose canonical_pose(const BodyPose& pose) {
  BodyPose result = pose;
  for (float& x : result.centre) x = canonical(x);
  for (float& x : result.half_extents) x = canonical(x);
  for (float& x : result.orientation) x = canonical(x);
  return result;
}

bool is_valid(const BodyPose& pose) {
  return has_good_orientation(pose) && has_good_extents(pose) && is_in_reach(pose);
}

/// The faults of the bodies at these places of the call, as many as a status names.
std::string describe_faults(std::span<const std::size_t> bad, std::span<const BodyId> ids,
                            std::span<const BodyPose> poses) {
  std::string words;
  for (const std::size_t place : bad.first(std::min(bad.size(), Status::kMostBodies))) {
    if (!words.empty()) words += text("; body ", ids[place], ": ");
    words += describe_fault(poses[place]);
  }
  if (bad.size() > Status::kMostBodies) words += text("; and ", bad.size() - Status::kMostBodies, " more");
  return words;
}

}  // namespace

Result<std::vector<BodyPose>> checked_poses(std::span<const BodyId> ids, std::span<const BodyPose> poses) {
  std::vector<BodyPose> checked;
  checked.reserve(poses.size());
  std::vector<std::size_t> bad;
  for (std::size_t i = 0; i < poses.size(); ++i) {
    checked.push_back(canonical_pose(poses[i]));
    if (!is_valid(checked.back())) bad.push_back(i);
  }
  if (bad.empty()) return checked;
  std::vector<BodyId> bodies;
  bodies.reserve(bad.size());
  for (const std::size_t place : bad) bodies.push_back(ids[place]);
  return Status::bad_bodies(
      StatusCode::invalid_box,
      text("The pose of body ", bodies.front(), " is refused: ", describe_faults(bad, ids, checked), "."),
      bodies);
}

}  // namespace cellsweep::cell

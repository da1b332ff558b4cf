#include "engines/cell/ppu/pose_blocks.h"

namespace cellsweep::cell {
namespace {

void write_lane(PoseBlock& block, std::size_t lane, const BodyPose& pose) {
  for (std::size_t i = 0; i < 4; ++i) block.orientation[i][lane] = pose.orientation[i];
  for (std::size_t i = 0; i < 3; ++i) {
    block.half_extents[i][lane] = pose.half_extents[i];
    block.centre[i][lane] = pose.centre[i];
  }
}

}  // namespace

void pack(std::span<const BodyPose> poses, std::span<PoseBlock> blocks) {
  const std::size_t filled = (poses.size() + kLanes - 1) / kLanes * kLanes;
  for (std::size_t i = 0; i < filled; ++i)
    write_lane(blocks[i / kLanes], i % kLanes, i < poses.size() ? poses[i] : BodyPose{});
}

}  // namespace cellsweep::cell

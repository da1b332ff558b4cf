#include "cellsweep/broadphase.h"

#include "base/text.h"

namespace cellsweep {
namespace {

Status no_poses_status(std::string_view engine) {
  return {StatusCode::bad_option,
          text("Engine ", engine,
               " makes no boxes from poses; cell-resident does, when it is made with spu_boxes."),
          std::nullopt,
          0,
          0,
          "spu_boxes"};
}

}  // namespace

Status Broadphase::insert_poses(std::span<const BodyId>, std::span<const BodyPose>) {
  return no_poses_status(name());
}

Status Broadphase::move_poses(std::span<const BodyId>, std::span<const BodyPose>) {
  return no_poses_status(name());
}

Status Broadphase::boxes(std::span<const BodyId>, std::span<Aabb>) const {
  return no_poses_status(name());
}

}  // namespace cellsweep

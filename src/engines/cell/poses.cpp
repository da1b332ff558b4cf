#include <vector>

#include "base/text.h"
#include "cellsweep/cell.h"
#include "cellsweep/engine/engine.h"
#include "engines/cell/cell_engine.h"
#include "engines/cell/ppu/pose_checks.h"

namespace cellsweep {
namespace {

Status no_poses_status(std::string_view engine) {
  return Status::bad_option("spu_boxes",
                            text("Engine ", engine,
                                 " makes no boxes from poses; cell-resident does, when it is made with "
                                 "spu_boxes."));
}

/// What insert() and move() are to be called with instead of the poses.
Result<std::vector<Aabb>> boxes_of(Broadphase& broadphase, std::span<const BodyId> ids,
                                   std::span<const BodyPose> poses) {
  auto* maker = dynamic_cast<cell::PoseBoxes*>(&EngineAccess::engine_of(broadphase));
  if (maker == nullptr || !maker->takes_poses()) return no_poses_status(broadphase.name());
  if (ids.size() != poses.size()) {
    return Status::bad_input(
        text("There are ", ids.size(), " ids but ", poses.size(), " poses; one pose an id is needed."));
  }
  auto checked = cell::checked_poses(ids, poses);
  if (!checked) return checked.status();
  std::vector<Aabb> boxes(poses.size());
  if (Status status = maker->make_boxes(*checked, boxes); !status.ok()) return status;
  return boxes;
}

}  // namespace

Status insert_poses(Broadphase& broadphase, std::span<const BodyId> ids, std::span<const BodyPose> poses) {
  const auto boxes = boxes_of(broadphase, ids, poses);
  return boxes ? broadphase.insert(ids, *boxes) : boxes.status();
}

Status move_poses(Broadphase& broadphase, std::span<const BodyId> ids, std::span<const BodyPose> poses) {
  const auto boxes = boxes_of(broadphase, ids, poses);
  return boxes ? broadphase.move(ids, *boxes) : boxes.status();
}

}  // namespace cellsweep

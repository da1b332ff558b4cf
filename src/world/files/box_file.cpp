#include "world/files/box_file.h"

#include "geometry/bounds.h"

namespace cellsweep {

Result<Recording> recording_of(const BoxFile& head, const std::function<Status(std::span<Aabb>)>& read) {
  Recording recording;
  recording.name = head.name;
  recording.type = head.type;
  recording.bodies = head.block.bodies;
  recording.boxes.resize(head.boxes());
  if (Status status = read(recording.boxes); !status.ok()) return status;
  Bounds bounds;
  if (!head.world) {
    for (const Aabb& box : recording.boxes) bounds.include(box);
  }
  recording.world = head.world.value_or(bounds.box());
  return recording;
}

Result<Recording> load_all(const BoxFile& head, std::span<const std::byte> file) {
  return recording_of(
      head, [&](std::span<Aabb> boxes) { return head.load(file.subspan(head.block.offset), 0, boxes); });
}

}  // namespace cellsweep

#include "report/hand_over.h"

#include <span>
#include <vector>

#include "base/text.h"
#include "report/all_engines.h"
#include "report/engine_settings.h"

namespace cellsweep::report {
namespace {

constexpr const char* kPosesSetting = "spu_boxes";

// What the bodies have in a list by id; the list itself when all have something there.
template <class T>
class PartOf {
 public:
  PartOf(std::span<const T> all, std::span<const BodyId> bodies) : part_(all) {
    if (bodies.size() == all.size()) return;
    some_.reserve(bodies.size());
    for (const BodyId id : bodies) some_.push_back(all[id]);
    part_ = some_;
  }
  PartOf(const PartOf&) = delete;
  PartOf& operator=(const PartOf&) = delete;

  std::span<const T> get() const { return part_; }

 private:
  std::vector<T> some_;
  std::span<const T> part_;
};

Status insert(Broadphase& engine, const FrameSource& source, std::span<const BodyId> bodies, Shape shape) {
  const PartOf filters(source.filters(), source.filters().empty() ? std::span<const BodyId>() : bodies);
  if (shape == Shape::boxes)
    return engine.insert(bodies, PartOf(source.boxes(), bodies).get(), filters.get());
  if (Status status = insert_posed(engine, bodies, PartOf(source.poses(), bodies).get()); !status.ok())
    return status;
  return filters.get().empty() ? Status() : engine.set_filters(bodies, filters.get());
}

Status move(Broadphase& engine, const FrameSource& source, std::span<const BodyId> bodies, Shape shape) {
  if (shape == Shape::boxes) return engine.move(bodies, PartOf(source.boxes(), bodies).get());
  return move_posed(engine, bodies, PartOf(source.poses(), bodies).get());
}

}  // namespace

Shape shape_of(const SettingValues& settings) {
  return value_of(settings, kPosesSetting) == "true" ? Shape::poses : Shape::boxes;
}

Status insert_all(Broadphase& engine, const FrameSource& source, Shape shape) {
  if (shape == Shape::boxes || source.poses().size() == source.boxes().size()) {
    return insert(engine, source, source.bodies(), shape);
  }
  return Status::bad_input(
      text("Source ", source.name(), " has boxes only; no engine can make them from poses."), kPosesSetting);
}

// An id that goes and one that comes are never the same in one frame, so that the order is of no matter.
Status hand_over_changes(Broadphase& engine, const FrameSource& source, Shape shape) {
  if (source.bodies_come_and_go()) {
    if (Status status = engine.remove(source.removed()); !status.ok()) return status;
    if (Status status = insert(engine, source, source.inserted(), shape); !status.ok()) return status;
  }
  return move(engine, source, source.moved(), shape);
}

}  // namespace cellsweep::report

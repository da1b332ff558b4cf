#include "report/hand_over.h"

#include <numeric>
#include <vector>

#include "base/text.h"
#include "report/all_engines.h"
#include "report/engine_settings.h"

namespace cellsweep::report {
namespace {

constexpr const char* kPosesSetting = "spu_boxes";

template <class T>
std::vector<T> of_moved(const FrameSource& source, std::span<const T> all) {
  std::vector<T> some;
  some.reserve(source.moved().size());
  for (const BodyId id : source.moved()) some.push_back(all[id]);
  return some;
}

}  // namespace

Shape shape_of(const SettingValues& settings) {
  return value_of(settings, kPosesSetting) == "true" ? Shape::poses : Shape::boxes;
}

Status insert_all(Broadphase& engine, const FrameSource& source, Shape shape) {
  std::vector<BodyId> ids(source.boxes().size());
  std::iota(ids.begin(), ids.end(), BodyId{0});
  if (shape == Shape::boxes) return engine.insert(ids, source.boxes());
  if (source.poses().size() == ids.size()) return insert_posed(engine, ids, source.poses());
  return Status::bad_input(
      text("Source ", source.name(), " has boxes only; no engine can make them from poses."), kPosesSetting);
}

Status move_changed(Broadphase& engine, const FrameSource& source, Shape shape) {
  if (shape == Shape::boxes) return engine.move(source.moved(), of_moved(source, source.boxes()));
  return move_posed(engine, source.moved(), of_moved(source, source.poses()));
}

}  // namespace cellsweep::report

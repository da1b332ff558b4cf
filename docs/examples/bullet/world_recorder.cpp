#include "world_recorder.h"

#include "proxy_box.h"

using cellsweep::Status;

Status WorldRecorder::record(const btCollisionWorld& world) {
  ++frame_;
  const btCollisionObjectArray& objects = world.getCollisionObjectArray();
  for (int i = 0; i < objects.size(); ++i) {
    const btBroadphaseProxy* proxy = objects[i]->getBroadphaseHandle();
    if (proxy == nullptr) continue;
    if (Status status = record(*objects[i], *proxy); !status.ok()) return status;
  }
  for (auto place = bodies_.begin(); place != bodies_.end();) {
    if (place->second.frame == frame_) {
      ++place;
      continue;
    }
    if (Status status = recorder_.remove(place->second.id); !status.ok()) return status;
    place = bodies_.erase(place);
  }
  recorder_.end_frame();
  return {};
}

Status WorldRecorder::record(const btCollisionObject& object, const btBroadphaseProxy& proxy) {
  const auto [place, is_new] = bodies_.try_emplace(&object, Body{next_id_, frame_});
  place->second.frame = frame_;
  if (is_new) return recorder_.insert(next_id_++, box_of(proxy), filter_of(proxy));
  if (Status status = recorder_.move(place->second.id, box_of(proxy)); !status.ok()) return status;
  return recorder_.set_filter(place->second.id, filter_of(proxy));
}

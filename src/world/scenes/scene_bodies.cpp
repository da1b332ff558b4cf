#include "world/scenes/scene_bodies.h"

namespace cellsweep {
namespace {

void append_ascending(std::vector<BodyId>& ids, BodyId id) {
  assert(ids.empty() || ids.back() < id);
  ids.push_back(id);
}

}  // namespace

SceneBodies::SceneBodies(std::size_t bodies, std::optional<BodyId> giant, const Aabb& giant_box)
    : giant_(giant), boxes_(bodies), has_(bodies, 0) {
  if (!giant) return;
  boxes_[*giant] = giant_box;
  has_[*giant] = 1;
}

void SceneBodies::begin_frame() {
  moved_.clear();
  inserted_.clear();
  removed_.clear();
}

void SceneBodies::end_frame() {
  if (inserted_.empty() && removed_.empty() && !bodies_.empty()) return;
  bodies_.clear();
  for (std::size_t id = 0; id < has_.size(); ++id) {
    if (has_[id] != 0) bodies_.push_back(static_cast<BodyId>(id));
  }
}

void SceneBodies::insert(BodyId id, const Aabb& box) {
  if (giant_ == id) return;
  assert(!has(id));
  has_[id] = 1;
  boxes_[id] = box;
  append_ascending(inserted_, id);
}

void SceneBodies::remove(BodyId id) {
  if (giant_ == id) return;
  assert(has(id));
  has_[id] = 0;
  append_ascending(removed_, id);
}

void SceneBodies::move(BodyId id, const Aabb& box) {
  if (giant_ == id || box == boxes_[id]) return;
  assert(has(id));
  boxes_[id] = box;
  append_ascending(moved_, id);
}

}  // namespace cellsweep

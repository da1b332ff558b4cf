#include "ranks/engine_plan.h"

#include <algorithm>
#include <span>

namespace cellsweep::ranks {

void EnginePlan::reserve(std::size_t bodies) {
  for (std::vector<Local>* list : {&removed_, &inserted_, &filtered_, &moved_})
    list->reserve(list->size() + bodies);
  for (std::vector<Aabb>* list : {&inserted_boxes_, &moved_boxes_}) list->reserve(list->size() + bodies);
  for (std::vector<BodyFilter>* list : {&inserted_filters_, &filters_}) list->reserve(list->size() + bodies);
}

void EnginePlan::insert(Local local, const Aabb& box, const BodyFilter& filter) {
  inserted_.push_back(local);
  inserted_boxes_.push_back(box);
  inserted_filters_.push_back(filter);
}

void EnginePlan::set_filter(Local local, const BodyFilter& filter) {
  filtered_.push_back(local);
  filters_.push_back(filter);
}

void EnginePlan::move(Local local, const Aabb& box) {
  moved_.push_back(local);
  moved_boxes_.push_back(box);
}

Status EnginePlan::run(Broadphase& engine) {
  if (Status status = engine.remove(removed_); !status.ok()) return status;
  removed_.clear();
  // An engine that knows of no filters asks nobody for them.
  const bool all_meet =
      std::ranges::all_of(inserted_filters_, [](const BodyFilter& filter) { return filter == BodyFilter(); });
  const std::span<const BodyFilter> filters = all_meet ? std::span<const BodyFilter>() : inserted_filters_;
  if (Status status = engine.insert(inserted_, inserted_boxes_, filters); !status.ok()) return status;
  inserted_.clear();
  inserted_boxes_.clear();
  inserted_filters_.clear();
  if (Status status = engine.set_filters(filtered_, filters_); !status.ok()) return status;
  filtered_.clear();
  filters_.clear();
  if (Status status = engine.move(moved_, moved_boxes_); !status.ok()) return status;
  moved_.clear();
  moved_boxes_.clear();
  return {};
}

}  // namespace cellsweep::ranks

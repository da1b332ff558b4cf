#include "ranks/staged_calls.h"

#include <algorithm>
#include <utility>

namespace cellsweep::ranks {

const StagedCall* StagedCalls::find(GlobalId id) const {
  const auto place = places_.find(id);
  return place == kNoSlot ? nullptr : &calls_[place];
}

void StagedCalls::reserve(std::size_t more) {
  const std::size_t wanted = calls_.size() + more;
  places_.reserve(wanted);
  if (wanted > calls_.capacity()) calls_.reserve(std::max(wanted, calls_.capacity() + calls_.capacity() / 2));
}

StagedCall& StagedCalls::call_for(GlobalId id, bool must_exist) {
  const auto place = places_.find(id);
  if (place != kNoSlot) return calls_[place];
  places_.insert(id, static_cast<Slot>(calls_.size()));
  StagedCall& call = calls_.emplace_back();
  call.id = id;
  call.must_exist = must_exist;
  return call;
}

void StagedCalls::insert(GlobalId id, const Aabb& box, const FilterRow& filter) {
  StagedCall& call = call_for(id, false);
  call.inserted = call.exists = call.has_box = call.has_filter = true;
  call.box = box;
  call.filter = filter;
}

void StagedCalls::move(GlobalId id, const Aabb& box) {
  StagedCall& call = call_for(id, true);
  call.has_box = true;
  call.box = box;
}

void StagedCalls::set_filter(GlobalId id, const FilterRow& filter) {
  StagedCall& call = call_for(id, true);
  call.has_filter = true;
  call.filter = filter;
}

void StagedCalls::remove(GlobalId id) {
  StagedCall& call = call_for(id, true);
  call.exists = call.inserted = call.has_box = call.has_filter = false;
}

void StagedCalls::forget(std::vector<GlobalId> ids) {
  std::ranges::sort(ids);
  StagedCalls kept;
  kept.reserve(calls_.size());
  for (const StagedCall& call : calls_) {
    if (!std::ranges::binary_search(ids, call.id)) kept.call_for(call.id, call.must_exist) = call;
  }
  *this = std::move(kept);
}

void StagedCalls::clear() {
  *this = StagedCalls();
}

}  // namespace cellsweep::ranks

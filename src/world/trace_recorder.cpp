#include "cellsweep/world/trace_recorder.h"

#include <algorithm>
#include <functional>
#include <string>

#include "world/files/file_fault.h"

namespace cellsweep {
namespace {

Status not_there(BodyId id) {
  return bad_recording("body " + std::to_string(id) + " is not there");
}

}  // namespace

TraceRecorder::Body* TraceRecorder::find(BodyId id) {
  const auto number = numbers_.find(id);
  return number == numbers_.end() ? nullptr : &bodies_[number->second];
}

// At least one number is free then. No list has a number twice: with room for all, they never ask for memory.
void TraceRecorder::make_room() {
  if (!free_.empty()) return;
  if (bodies_.size() == bodies_.capacity()) bodies_.reserve(2 * bodies_.size() + 64);
  for (std::vector<BodyId>* list : {&noted_, &removed_, &free_}) list->reserve(bodies_.capacity());
  bodies_.emplace_back();
  free_.push_back(static_cast<BodyId>(bodies_.size() - 1));
}

// Takes the number that make_room() made sure of.
void TraceRecorder::enter(BodyId number, const Aabb& box, const BodyFilter& filter) {
  free_.pop_back();
  bodies_[number] = {box, box, filter, true, true, false};
  note(number);
}

void TraceRecorder::note(BodyId number) {
  if (bodies_[number].is_noted) return;
  noted_.push_back(number);
  bodies_[number].is_noted = true;
}

Status TraceRecorder::insert(BodyId id, const Aabb& box, const BodyFilter& filter) {
  if (find(id) != nullptr) return bad_recording("body " + std::to_string(id) + " is there already");
  make_room();
  const BodyId number = free_.back();
  numbers_.emplace(id, number);
  enter(number, box, filter);
  return {};
}

Status TraceRecorder::move(BodyId id, const Aabb& box) {
  Body* const body = find(id);
  if (body == nullptr) return not_there(id);
  body->next = box;
  note(numbers_[id]);
  return {};
}

// Another body, in the trace.
Status TraceRecorder::set_filter(BodyId id, const BodyFilter& filter) {
  Body* const body = find(id);
  if (body == nullptr) return not_there(id);
  if (body->filter == filter) return {};
  if (body->is_new) {
    body->filter = filter;
    return {};
  }
  const Aabb box = body->next;
  make_room();
  BodyId& number = numbers_.find(id)->second;
  leave(number);
  number = free_.back();
  enter(number, box, filter);
  return {};
}

Status TraceRecorder::remove(BodyId id) {
  if (find(id) == nullptr) return not_there(id);
  leave(numbers_[id]);
  numbers_.erase(id);
  return {};
}

void TraceRecorder::leave(BodyId number) {
  if (!bodies_[number].is_new) removed_.push_back(number);
  bodies_[number].is_there = false;
  note(number);
}

void TraceRecorder::end_frame() {
  std::ranges::sort(noted_);
  std::ranges::sort(removed_);
  try {
    list_frame();
  } catch (...) {
    forget_frame();
    throw;
  }
  for (const BodyId number : noted_) {
    Body& body = bodies_[number];
    if (!body.is_there) free_.push_back(number);
    body.box = body.next;
    body.is_new = body.is_noted = false;
  }
  noted_.clear();
  removed_.clear();
  std::ranges::sort(free_, std::greater<>());
}

void TraceRecorder::list_frame() {
  for (const BodyId number : noted_) {
    const Body& body = bodies_[number];
    if (!body.is_there) continue;
    if (body.is_new) {
      trace_.inserted.push_back(number);
      trace_.inserted_boxes.push_back(body.next);
      trace_.inserted_filters.push_back(body.filter);
    } else if (body.next != body.box) {
      trace_.moved.push_back(number);
      trace_.moved_boxes.push_back(body.next);
    }
  }
  trace_.removed.insert(trace_.removed.end(), removed_.begin(), removed_.end());
  trace_.inserted_ends.push_back(trace_.inserted.size());
  trace_.removed_ends.push_back(trace_.removed.size());
  trace_.moved_ends.push_back(trace_.moved.size());
}

// What list_frame() did of one.
void TraceRecorder::forget_frame() {
  const std::size_t frames =
      std::min({trace_.inserted_ends.size(), trace_.removed_ends.size(), trace_.moved_ends.size()});
  const auto cut = [&](std::vector<std::size_t>& ends, auto&... lists) {
    ends.resize(frames);
    const std::size_t size = frames == 0 ? 0 : ends.back();
    (lists.resize(std::min(lists.size(), size)), ...);
  };
  cut(trace_.inserted_ends, trace_.inserted, trace_.inserted_boxes, trace_.inserted_filters);
  cut(trace_.removed_ends, trace_.removed);
  cut(trace_.moved_ends, trace_.moved, trace_.moved_boxes);
}

}  // namespace cellsweep

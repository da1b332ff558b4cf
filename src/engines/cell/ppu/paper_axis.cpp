#include "engines/cell/ppu/paper_axis.h"

#include <algorithm>
#include <bit>

namespace cellsweep::cell {
namespace {

const auto kPaddingValue = std::bit_cast<float>(kPaddingValueBits);

}  // namespace

void PaperAxis::rebuild(std::span<const std::uint32_t> places, std::span<const Aabb> boxes) {
  const auto endpoints = static_cast<std::uint32_t>(2 * places.size());
  const std::uint32_t maximum = has(kPaperLiteral) ? 0 : kMaximumFlag;
  values_.assign(round_up(endpoints, kLanes), kPaddingValue);
  ids_.assign(values_.size(), kUnchanged);
  changed_.resize(values_.size());
  for (std::size_t i = 0; i < places.size(); ++i) {
    const std::uint32_t id = places[i] + 1;
    values_[2 * i] = boxes[places[i]].min[axis_];
    values_[2 * i + 1] = boxes[places[i]].max[axis_];
    ids_[2 * i] = id;
    ids_[2 * i + 1] = id | maximum;
  }
  met_.assign(boxes.size() + 1, false);
  make_room_for_keys(places.size());
}

// Every pair comes once, but for Listing 4.12's walk, which sends an ID as often as it meets it.
void PaperAxis::make_room_for_keys(std::uint64_t bodies) {
  const std::uint64_t once = bodies * bodies / 2;
  keys_.reserve((has(kPaperLiteral) ? 4 * once : once) + kLanes);
  if (has(kPaperMethod2)) apart_keys_.reserve(once + kLanes);
}

void PaperAxis::refill(std::span<const Aabb> boxes) {
  for (std::size_t i = 0; i < ids_.size() && ids_[i] != kUnchanged; ++i) {
    const std::uint32_t id = ids_[i] & ~kMaximumFlag;
    const Aabb& box = boxes[id - 1];
    values_[i] = met_[id] ? box.max[axis_] : box.min[axis_];
    met_[id] = !met_[id];
  }
}

void PaperAxis::fill_body_values(std::span<const std::uint32_t> places, std::span<const Aabb> boxes) {
  body_values_.assign(round_up(static_cast<std::uint32_t>(2 * boxes.size()), kLanes), kPaddingValue);
  for (const std::uint32_t place : places) {
    body_values_[2 * std::size_t{place}] = boxes[place].min[axis_];
    body_values_[2 * std::size_t{place} + 1] = boxes[place].max[axis_];
  }
}

PaperJob* PaperAxis::make_job(bool initial) {
  PaperJob& job = job_[0];
  job = {};
  job.values = wire_address(values_.data());
  job.ids = wire_address(ids_.data());
  job.body_values = wire_address(body_values_.data());
  job.sorted_ids = job.ids;
  job.changed = wire_address(changed_.data());
  job.keys = wire_address(keys_.data());
  job.apart_keys = wire_address(apart_keys_.data());
  job.result = wire_address(result_.data());
  job.endpoints = static_cast<std::uint32_t>(values_.size());
  job.largest_id = static_cast<std::uint32_t>(met_.size() - 1);
  job.flags = flags_ | (initial ? kPaperInitial : 0U);
  return &job;
}

}  // namespace cellsweep::cell

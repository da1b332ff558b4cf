#include "bench/first_attempt.h"

#include "cellsweep/engines.h"
#include "engines/cell/emulation.h"

extern "C" spe_program_handle_t cell_first_attempt_spu;

namespace cellsweep::bench {

using cell::kMaximumFlag;
using cell::kOverlapFlag;

Result<std::unique_ptr<FirstAttempt>> FirstAttempt::make(std::size_t bodies) {
  auto emulation = cell::make_emulation({});
  if (!emulation) return emulation.status();
  auto spes = cell::SpeGroup::make(3, cell_first_attempt_spu, std::move(*emulation));
  if (!spes) return spes.status();
  return std::unique_ptr<FirstAttempt>(new FirstAttempt(bodies, std::move(*spes)));
}

FirstAttempt::FirstAttempt(std::size_t bodies, std::unique_ptr<cell::SpeGroup> spes)
    : bodies_(bodies), spes_(std::move(spes)) {
  for (Axis& axis : axes_) {
    for (std::uint32_t id = 1; id <= bodies; ++id) {
      axis.endpoints.push_back({id, 0, 0, 0});
      axis.endpoints.push_back({id | kMaximumFlag, 0, 0, 0});
    }
    axis.events.reserve(2 * bodies * bodies + cell::kLanes);
    axis.overlaps.resize((bodies + 1) << 16);
    axis.job[0] = {cell::wire_address(axis.endpoints.data()),
                   cell::wire_address(axis.events.data()),
                   cell::wire_address(axis.result.data()),
                   static_cast<std::uint32_t>(2 * bodies),
                   {}};
  }
}

void FirstAttempt::copy_values(std::size_t axis, std::span<const Aabb> boxes) {
  for (cell::FirstAttemptEndpoint& end : axes_[axis].endpoints) {
    const Aabb& box = boxes[(end.id & ~kMaximumFlag) - 1];
    end.min = box.min[axis];
    end.max = box.max[axis];
    end.value = (end.id & kMaximumFlag) != 0 ? end.max : end.min;
  }
}

Status FirstAttempt::run(std::span<const Aabb> boxes) {
  std::array<void*, 3> jobs{};
  for (std::size_t axis = 0; axis < axes_.size(); ++axis) {
    copy_values(axis, boxes);
    jobs[axis] = axes_[axis].job.data();
  }
  return spes_->run(jobs);
}

std::size_t FirstAttempt::events() const {
  return std::size_t{axes_[0].result[0]} + axes_[1].result[0] + axes_[2].result[0];
}

std::size_t FirstAttempt::count_pairs() {
  for (Axis& axis : axes_) {
    for (const std::uint32_t event : std::span(axis.events.data(), axis.result[0])) {
      axis.overlaps[event & ~kOverlapFlag] = (event & kOverlapFlag) != 0;
    }
  }
  std::size_t pairs = 0;
  for (std::uint32_t larger = 2; larger <= bodies_; ++larger) {
    for (std::uint32_t smaller = 1; smaller < larger; ++smaller) {
      const std::uint32_t key = cell::pair_key_of_ids(smaller, larger);
      if (axes_[0].overlaps[key] && axes_[1].overlaps[key] && axes_[2].overlaps[key]) ++pairs;
    }
  }
  return pairs;
}

}  // namespace cellsweep::bench

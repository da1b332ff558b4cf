#include "engines/stream/search/sweep.h"

#include <algorithm>
#include <array>

#include "base/tuning.h"

namespace cellsweep::stream {
namespace {

/// In bytes so many times as many boxes are compared at once.
constexpr unsigned kBoxesOfLane = 4;

}  // namespace

// Where a map is not as good as it looked, it costs to sort boxes twice.
bool Sweep::find(const Kernels& kernels, std::span<const Aabb> boxes, Keys& found) {
  const bool knows = map_.is_good_for(kernels, boxes);
  if (knows) sort(kernels, boxes);
  if (!knows || !pays(kernels)) {
    map_.learn(boxes);
    if (!promises(kernels, boxes)) return false;
    sort(kernels, boxes);
    if (!pays(kernels)) return false;
  }
  const std::size_t before = found.view().size();
  const bool all = find_pairs(kernels, boxes, found.buffer());
  if (!all) found.shrink(before);
  found.leave_out();
  return all;
}

void Sweep::sort(const Kernels& kernels, std::span<const Aabb> boxes) {
  make_rows(kernels, boxes);
  sorted_.sort(rows_.view(), map_.places());
  compared_ = sorted_.comparisons();
}

void Sweep::make_rows(const Kernels& kernels, std::span<const Aabb> boxes) {
  constexpr std::size_t kEight = 8;
  rows_.renew(boxes.size() + kEight);
  SweepRow* to = rows_.data();
  std::array<Aabb, kEight> last;
  EightRows rows;
  for (std::uint32_t first = 0; first < boxes.size(); first += kEight) {
    const Aabb* eight = &boxes[first];
    if (const auto rest = boxes.subspan(first); rest.size() < kEight) {
      last.fill(kNobody);
      std::ranges::copy(rest, last.begin());
      eight = last.data();
    }
    kernels.eight_rows(eight, map_.numbers(), map_.axis(), rows);
    for (std::uint32_t i = 0; i < kEight; ++i) {
      *to = {rows.on_axis[i], rows.on_others[i], first + i};
      to += rows.there >> i & 1;
    }
  }
  rows_.shrink(static_cast<std::size_t>(to - rows_.data()));
}

// Of few boxes too little is known to tell, and to sort them takes little.
bool Sweep::promises(const Kernels& kernels, std::span<const Aabb> boxes) const {
  return boxes.size() <= tuning::kMostSweptInMotion ||
         map_.comparisons(kernels, boxes) <= kBoxesOfLane * kernels.lanes * tuning::kVectorsExpected;
}

bool Sweep::pays(const Kernels& kernels) const {
  return compared_ <= std::uint64_t{kBoxesOfLane} * kernels.lanes * tuning::kVectorsOfSwept * rows_.size();
}

bool Sweep::find_pairs(const Kernels& kernels, std::span<const Aabb> boxes, KeyBuffer& found) {
  tests_ += compared_;
  const std::uint64_t most_tests = std::uint64_t{tuning::kTestsOfSwept} * rows_.size();
  const SweepResult result = kernels.sweep(sorted_.view(boxes), most_tests, found);
  tests_ += result.tests;
  return result.found_all;
}

}  // namespace cellsweep::stream

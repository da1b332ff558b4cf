#include "engines/stream/bodies/move_check.h"

#include <algorithm>
#include <array>
#include <cstring>

#include "broadphase/input_checks.h"
#include "geometry/box_lanes.h"

namespace cellsweep::stream {
namespace {

/// Boxes given again are recognised so many at a time.
constexpr std::size_t kBlock = 32;

bool is_run(const BodyId* ids, std::size_t count) {
  bool good = true;
  for (std::size_t i = 0; i < count; ++i) good &= ids[i] == ids[0] + i;
  return good;
}

}  // namespace

bool are_clean(std::span<const Aabb> boxes) {
  Int4 clean = {-1, -1, -1, -1};
  for (const Aabb& box : boxes) clean &= clean_lanes(BoxLanes(box));
  return on_all_axes(clean);
}

void MoveCheck::run(const HeldBoxes& held, std::span<const BodyId> ids, std::span<const Aabb> boxes,
                    Share share) {
  good_ = clean_ = true;
  count_ = escapes_ = 0;
  list_.renew(share.last - share.first);
  const bool plain = held.table.is_plain();
  std::array<std::uint32_t, kBlock> slots;
  for (std::size_t first = share.first; good_ && first < share.last; first += kBlock) {
    const std::size_t last = std::min(first + kBlock, share.last);
    const auto block = boxes.subspan(first, last - first);
    if (plain && ids[last - 1] < held.boxes.size() && is_run(&ids[first], last - first)) {
      if (std::memcmp(block.data(), &held.boxes[ids[first]], block.size_bytes()) == 0) continue;
      std::copy_n(&ids[first], last - first, slots.begin());
    } else {
      for (std::size_t i = first; i < last; ++i) slots[i - first] = find(held, ids[i]);
      if (!good_) return;
    }
    check_block(held, slots.data(), block, first);
  }
}

// Bodies that are here and there: what they have is on its way while the others of the block are looked up.
std::uint32_t MoveCheck::find(const HeldBoxes& held, BodyId id) {
  const std::uint32_t slot = held.table.find(id);
  if (slot == IdTable::kNone) {
    good_ = false;
    return slot;
  }
  __builtin_prefetch(&held.boxes[slot]);
  __builtin_prefetch(&held.hulls[slot]);
  return slot;
}

void MoveCheck::check_block(const HeldBoxes& held, const std::uint32_t* slots, std::span<const Aabb> boxes,
                            std::size_t first) {
  Int4 clean = {-1, -1, -1, -1};
  const std::size_t count = count_;
  const std::size_t escapes = escapes_;
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    const BoxLanes box(boxes[i]);
    clean &= clean_lanes(box);
    note(held, slots[i], box, first + i);
  }
  if (on_all_axes(clean)) return;
  clean_ = false;  // all of it once more, as it will be kept
  count_ = count;
  escapes_ = escapes;
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    const Aabb box = canonical(boxes[i]);
    good_ &= is_valid(box);
    note(held, slots[i], BoxLanes(box), first + i);
  }
}

void MoveCheck::note(const HeldBoxes& held, std::uint32_t slot, const BoxLanes& box, std::size_t index) {
  const bool escapes = !encloses(BoxLanes(held.hulls[slot]), box);
  const bool differs = !same_bits(box, BoxLanes(held.boxes[slot]));
  list_.data()[count_] = {static_cast<std::uint32_t>(index), slot, escapes};
  count_ += differs ? 1 : 0;
  escapes_ += differs && escapes ? 1 : 0;
}

}  // namespace cellsweep::stream

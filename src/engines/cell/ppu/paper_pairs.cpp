#include "engines/cell/ppu/paper_pairs.h"

#include <algorithm>

#include "engines/cell/wire.h"

namespace cellsweep::cell {
namespace {

constexpr std::uint32_t kMatrixStep = 64;

}  // namespace

void PaperPairs::add_body(std::uint32_t id) {
  if (id >= touched_.slots()) {
    const std::uint32_t slots = round_up(std::max(id + 1, 2 * touched_.slots()), kMatrixStep);
    for (OverlapMatrix& matrix : overlaps_) matrix.grow(slots);
    touched_.grow(slots);
  }
  for (const std::uint32_t other : entered_) pairs_.add(static_cast<int>(id), static_cast<int>(other));
  entered_.push_back(id);
}

void PaperPairs::remove_body(std::uint32_t id, Changed& ended) {
  std::erase(entered_, id);
  for (OverlapMatrix& matrix : overlaps_) matrix.clear(id, [](Slot) {});
  for (const std::uint32_t other : entered_) {
    const control::PairInfo pair = pairs_.remove(static_cast<int>(id), static_cast<int>(other));
    if (pair.colliding()) ended.push_back(pair);
  }
}

void PaperPairs::clear_earlier(std::size_t axis, std::span<const std::uint32_t> ids) {
  for (const std::uint32_t id : ids) {
    overlaps_[axis].clear(id, [&](Slot other) { touched_.set(id, other); });
  }
}

void PaperPairs::apply(std::size_t axis, std::span<const std::uint32_t> keys, bool overlapping) {
  for (const std::uint32_t key : keys) {
    const std::uint32_t smaller = key & 0xffff;
    const std::uint32_t larger = key >> 16;
    touched_.set(smaller, larger);
    if (overlapping) {
      overlaps_[axis].set(smaller, larger);
    } else {
      overlaps_[axis].reset(smaller, larger);
    }
  }
}

void PaperPairs::commit(Changed& changed) {
  control::PairManager::Cursor cursor(pairs_);
  touched_.drain([&](Slot larger, Slot smaller) {
    control::PairInfo& pair =
        cursor.find(control::pair_hash(static_cast<int>(smaller), static_cast<int>(larger)));
    const bool collided = pair.colliding();
    for (std::size_t axis = 0; axis < overlaps_.size(); ++axis) {
      pair.value[axis] = overlaps_[axis].test(larger, smaller);
    }
    if (pair.colliding() != collided) changed.push_back(pair);
  });
}

std::size_t PaperPairs::bytes() const {
  std::size_t sum = size() * control::kPairMapEntryBytes + touched_.bytes();
  for (const OverlapMatrix& matrix : overlaps_) sum += matrix.bytes();
  return sum;
}

}  // namespace cellsweep::cell

#include "engines/control/pair_manager.h"

#include <algorithm>

namespace cellsweep::control {

std::uint64_t bodies_that_fit(std::uint64_t map_bytes) {
  const std::uint64_t entries = map_bytes / kPairMapEntryBytes;
  std::uint64_t bodies = 1;
  while (bodies < kPairHashIds && (bodies + 1) * bodies / 2 <= entries) ++bodies;
  return bodies;
}

void PairManager::add(int one, int other) {
  const auto [smaller, larger] = std::minmax(one, other);
  // Keys grow with the larger id, so a new body's pairs belong at the end while ids are below 2^15.
  axis_collisions_.emplace_hint(axis_collisions_.end(), pair_hash(smaller, larger),
                                PairInfo{smaller, larger, {false, false, false}});
}

PairInfo PairManager::remove(int one, int other) {
  const auto [smaller, larger] = std::minmax(one, other);
  const auto found = axis_collisions_.find(pair_hash(smaller, larger));
  const PairInfo info = found->second;
  axis_collisions_.erase(found);
  return info;
}

PairInfo& PairManager::Cursor::find(int hash) {
  for (int step = 0; step < kStepsBeforeSearch && at_ != pairs_.end() && at_->first != hash; ++step) ++at_;
  if (at_ == pairs_.end() || at_->first != hash) at_ = pairs_.find(hash);
  return at_->second;
}

PairInfo& PairManager::find(int one, int other) {
  const auto [smaller, larger] = std::minmax(one, other);
  return axis_collisions_.find(pair_hash(smaller, larger))->second;
}

}  // namespace cellsweep::control

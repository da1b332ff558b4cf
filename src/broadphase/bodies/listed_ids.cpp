#include "broadphase/bodies/listed_ids.h"

#include <algorithm>
#include <utility>

#include "base/key_sort.h"

namespace cellsweep {

bool ListedIds::list(std::span<const BodyId> ids) {
  Array<std::uint64_t> entries;
  entries.renew(ids.size());
  for (std::size_t i = 0; i < ids.size(); ++i) entries.data()[i] = std::uint64_t{ids[i]} << 32 | i;
  sort_keys(entries.view());
  const auto have_one_id = [](std::uint64_t one, std::uint64_t next) { return one >> 32 == next >> 32; };
  if (std::ranges::adjacent_find(entries.view(), have_one_id) != entries.view().end()) return false;
  entries_ = std::move(entries);
  return true;
}

Slot ListedIds::find(BodyId id) const {
  const auto entries = entries_.view();
  const auto found = std::ranges::lower_bound(entries, std::uint64_t{id} << 32);
  return found != entries.end() && *found >> 32 == id ? static_cast<Slot>(*found) : kNoSlot;
}

}  // namespace cellsweep

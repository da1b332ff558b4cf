#include "broadphase/bodies/id_choice.h"

#include <algorithm>
#include <utility>

#include "base/memory/memory.h"
#include "base/sorting/key_sort.h"

namespace cellsweep {
namespace {

/// Who has an id, also of those that are gone and whose slots wait.
class Holders {
 public:
  explicit Holders(const IdTable& table) : table_(table) {
    waiting_.reserve(table.removed().size());
    for (const Slot slot : table.removed()) waiting_.push_back(std::uint64_t{table.id(slot)} << 32 | slot);
    sort_keys(waiting_);
  }

  bool is_taken(BodyId id) const { return holder_of(id) != kNoSlot; }

  /// From a slot that nobody is in to who has its number for an id, from there to who has the number of that
  /// one's slot: no slot comes twice, nor in the way from another one, and the last one's number nobody has.
  /// Only numbering anew makes such ways, and as that keeps the order of bodies they are short but for worlds
  /// made to have long ones.
  BodyId follow(Slot slot) const {
    for (;;) {
      const Slot holder = holder_of(slot);
      if (holder == kNoSlot) return slot;
      slot = holder;
    }
  }

 private:
  Slot holder_of(BodyId id) const {
    const Slot slot = table_.find(id);
    return slot != kNoSlot ? slot : find_waiting(id);
  }

  Slot find_waiting(BodyId id) const {
    const auto found = std::ranges::lower_bound(waiting_, std::uint64_t{id} << 32);
    return found != waiting_.end() && *found >> 32 == id ? static_cast<Slot>(*found) : kNoSlot;
  }

  const IdTable& table_;
  Vector<std::uint64_t> waiting_;  // by id: each id above a slot
};

}  // namespace

void IdChoice::choose(const IdTable& table, std::span<BodyId> ids) {
  const Holders holders(table);
  const auto start = static_cast<BodyId>(table.slot_count() + ids.size());
  if (start < taken_from_ || start >= taken_to_) taken_from_ = taken_to_ = start;
  BodyId beyond = taken_to_;
  bool knows_more = false;
  for (std::size_t i = 0; i < ids.size(); ++i) {
    ids[i] = table.next_slot(i);
    if (!holders.is_taken(ids[i])) continue;
    if (all_are_chosen_) {
      ids[i] = holders.follow(ids[i]);
      continue;
    }
    do ids[i] = beyond++;
    while (holders.is_taken(ids[i]));
    if (!std::exchange(knows_more, true)) taken_to_ = ids[i];
  }
}

}  // namespace cellsweep

#include "broadphase/pairs/pair_order.h"

#include <algorithm>
#include <utility>

namespace cellsweep {
namespace {

/// The pair of two numbers of bodies, either way round, as a key.
std::uint64_t key_of(std::uint32_t one, std::uint32_t other) {
  const std::uint64_t low = std::min(one, other);
  return low << 32 | std::max(one, other);
}

}  // namespace

void PairOrder::name_pairs(Crew& crew, const IdTable& table, std::span<const SlotPair> ascending,
                           KeyParts more, Array<Pair>& pairs) {
  const std::size_t count = count_keys(more);
  if (table.is_ascending() || ascending.size() + count == 0) {
    if (count == 0) return copy_named(table, ascending, pairs);
    return sort_in_slot_order(crew, table, ascending, more, pairs);
  }
  sort_by_ids(crew, table, ascending, more, pairs);
}

void PairOrder::copy_named(const IdTable& table, std::span<const SlotPair> ascending, Array<Pair>& pairs) {
  pairs.renew(ascending.size());
  Pair* to = pairs.data();
  for (const SlotPair& pair : ascending) *to++ = {table.id(pair.a), table.id(pair.b)};
}

void PairOrder::sort_in_slot_order(Crew& crew, const IdTable& table, std::span<const SlotPair> ascending,
                                   KeyParts more, Array<Pair>& pairs) {
  if (ascending.empty()) {
    sort_pairs(crew, more, scratch_, pairs);
  } else {
    list_keys(ascending, more, [](Slot slot) { return slot; });
    const std::span<const std::uint64_t> all = std::as_const(keys_).view();
    sort_pairs(crew, {&all, 1}, scratch_, pairs);
  }
  if (table.is_identical()) return;
  for (Pair& pair : pairs.view()) pair = {table.id(pair.a), table.id(pair.b)};
}

void PairOrder::sort_by_ids(Crew& crew, const IdTable& table, std::span<const SlotPair> ascending,
                            KeyParts more, Array<Pair>& pairs) {
  list_keys(ascending, more, [&](Slot slot) { return table.id(slot); });
  const std::span<const std::uint64_t> all = std::as_const(keys_).view();
  sort_pairs(crew, {&all, 1}, scratch_, pairs);
}

// `number` is what bodies are sorted by.
template <class Number>
void PairOrder::list_keys(std::span<const SlotPair> ascending, KeyParts more, Number&& number) {
  keys_.renew(ascending.size() + count_keys(more));
  std::uint64_t* to = keys_.data();
  for (const SlotPair& pair : ascending) *to++ = key_of(number(pair.a), number(pair.b));
  for (const auto part : more) {
    for (const std::uint64_t key : part)
      *to++ = key_of(number(static_cast<Slot>(key >> 32)), number(static_cast<Slot>(key)));
  }
}

}  // namespace cellsweep

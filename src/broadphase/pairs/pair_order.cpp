#include "broadphase/pairs/pair_order.h"

#include <algorithm>
#include <utility>

#include "base/pairs/pair_of.h"

namespace cellsweep {
namespace {

/// The pair of two numbers of bodies, either way round, as a key. Which is less nobody can foretell: there is
/// no branch on it.
std::uint64_t key_of(std::uint32_t one, std::uint32_t other) {
  const std::uint32_t differ = (one ^ other) & (one < other ? 0 : ~0U);
  return std::uint64_t{one ^ differ} << 32 | (other ^ differ);
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
    list_keys(crew, ascending, more, [](Slot slot) { return slot; });
    const std::span<const std::uint64_t> all = std::as_const(keys_).view();
    sort_pairs(crew, {&all, 1}, scratch_, pairs);
  }
  if (table.is_identical()) return;
  for (Pair& pair : pairs.view()) pair = {table.id(pair.a), table.id(pair.b)};
}

void PairOrder::sort_by_ids(Crew& crew, const IdTable& table, std::span<const SlotPair> ascending,
                            KeyParts more, Array<Pair>& pairs) {
  list_keys(crew, ascending, more, [&](Slot slot) { return table.id(slot); });
  const std::span<const std::uint64_t> all = std::as_const(keys_).view();
  sort_pairs(crew, {&all, 1}, scratch_, pairs);
}

// By all workers; `number` is what bodies are sorted by.
template <class Number>
void PairOrder::list_keys(Crew& crew, std::span<const SlotPair> ascending, KeyParts more, Number&& number) {
  keys_.renew(ascending.size() + count_keys(more));
  const auto list_part = [&](unsigned worker, auto part, std::uint64_t* to, auto&& slots) {
    const Share share = Share::of(part.size(), worker, crew.active());
    for (std::size_t i = share.first; i < share.last; ++i) {
      const SlotPair pair = slots(part[i]);
      to[i] = key_of(number(pair.a), number(pair.b));
    }
  };
  crew.run([&](unsigned worker) {
    std::uint64_t* to = keys_.data();
    list_part(worker, ascending, to, [](SlotPair pair) { return pair; });
    to += ascending.size();
    for (const auto part : more) {
      list_part(worker, part, to, pair_of<SlotPair>);
      to += part.size();
    }
  });
}

}  // namespace cellsweep

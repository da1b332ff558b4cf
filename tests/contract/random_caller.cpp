#include "contract/random_caller.h"

#include <algorithm>
#include <set>

namespace cellsweep::contract {
namespace {

using testing::AssertionResult;
using testing::AssertionSuccess;

/// Ids that have tripped somebody: the ends of the range, the sign bit, equal low or high halves.
constexpr BodyId kAwkwardIds[] = {0,          0xffffffff, 0xfffffffe, 0x80000000, 0x7fffffff, 0xffff,
                                  0x10000,    0x1ffff,    0x20000,    0x2ffff,    0x00010005, 0x00020005,
                                  0x00030005, 0x00050001, 0x00050002, 1};

/// Dense ids on every other seed; on the rest the awkward ones and random 32-bit numbers.
std::vector<BodyId> choose_names(Random& random, std::size_t count) {
  std::set<BodyId> names;
  const bool dense = random.one_in(2);
  while (names.size() < count) {
    const std::size_t next = names.size();
    if (dense) {
      names.insert(static_cast<BodyId>(next));
    } else if (random.one_in(2)) {
      names.insert(kAwkwardIds[random.below(std::size(kAwkwardIds))]);
    } else {
      names.insert(static_cast<BodyId>(random.bits()));
    }
  }
  return {names.begin(), names.end()};
}

/// At most `most` of `ids`, at least one if there are any, in random order.
std::vector<BodyId> sample(Random& random, std::vector<BodyId> ids, std::size_t most) {
  random.shuffle(ids);
  const std::size_t limit = std::min(ids.size(), most);
  if (limit > 0) ids.resize(1 + random.below(limit));
  if (limit == 0) ids.clear();
  return ids;
}

}  // namespace

RandomCaller::RandomCaller(CheckedEngine& engine, const BoxKind& kind, std::size_t bodies, std::uint64_t seed)
    : engine_(engine),
      kind_(kind),
      bodies_(std::min(bodies, engine.capacity())),
      random_(seed),
      filters_(random_.one_in(2)),
      names_(choose_names(random_, 2 * bodies_ + 4)) {}

AssertionResult RandomCaller::fill() {
  std::vector<BodyId> ids = names_;
  random_.shuffle(ids);
  ids.resize(bodies_);
  return insert(ids);
}

AssertionResult RandomCaller::insert(const std::vector<BodyId>& ids) {
  const std::vector<Aabb> boxes = make_boxes(kind_, random_, ids.size());
  if (!filters_ || random_.one_in(2)) return engine_.insert(ids, boxes);
  return engine_.insert(ids, boxes, some_filters(ids.size()));
}

AssertionResult RandomCaller::calls() {
  for (std::size_t left = random_.below(7); left > 0; --left) {
    if (AssertionResult result = call(); !result) return result;
  }
  return AssertionSuccess();
}

AssertionResult RandomCaller::step() {
  if (AssertionResult made = calls(); !made) return made;
  engine_.look_at_pairs(!random_.one_in(3));
  return engine_.update();
}

AssertionResult RandomCaller::call() {
  const std::size_t held = engine_.model().boxes.size();
  switch (random_.below(18)) {
    case 0:
    case 1:
      return insert_some(1);
    case 2:
    case 3:
      return insert_some(bodies_);
    case 4:
    case 5:
      return remove_some(1);
    case 6:
      return remove_some(1 + held / 2);
    case 7:
      return replace_some(1 + held / 4);
    case 8:
      return insert_and_remove();
    case 9:
      return nothing_in_bulk();
    case 10:
      return random_.one_in(4) ? remove_all() : move_some(1);
    case 11:
    case 12:
      return move_some(1);
    case 13:
      return move_some(held);
    case 14:
      return filters_ ? filter_some(random_.one_in(2) ? 1 : 1 + held / 4) : move_some(1);
    case 15:
      return add_some(random_.one_in(2) ? 1 : bodies_);
    default:
      return move_some(1 + held / 8);
  }
}

AssertionResult RandomCaller::insert_some(std::size_t most) {
  return insert(some_absent(std::min(most, room())));
}

/// Bodies whose ids are handed out, and may be the names of this run, too.
AssertionResult RandomCaller::add_some(std::size_t most) {
  const std::size_t limit = std::min(most, room());
  const std::size_t count = limit == 0 ? 0 : 1 + random_.below(limit);
  std::vector<BodyId> ids;
  return engine_.add(make_boxes(kind_, random_, count), ids);
}

AssertionResult RandomCaller::move_some(std::size_t most) {
  std::vector<BodyId> ids = some_present(most);
  if (!ids.empty() && random_.one_in(4)) ids.push_back(random_.pick(ids));
  return engine_.move(ids, next_boxes(ids));
}

AssertionResult RandomCaller::remove_some(std::size_t most) {
  return engine_.remove(some_present(most));
}

/// Takes bodies out and puts bodies of the same ids in again, often with the same boxes: all pairs of theirs
/// must end, and those that they have now begin.
AssertionResult RandomCaller::replace_some(std::size_t most) {
  const std::vector<BodyId> ids = some_present(most);
  std::vector<Aabb> boxes = next_boxes(ids);
  if (random_.one_in(2)) {
    std::ranges::transform(ids, boxes.begin(), [&](BodyId id) { return engine_.model().boxes.at(id); });
  }
  if (AssertionResult removed = engine_.remove(ids); !removed) return removed;
  return engine_.insert(ids, boxes);
}

/// Others, the same, or of one body two.
AssertionResult RandomCaller::filter_some(std::size_t most) {
  std::vector<BodyId> ids = some_present(most);
  if (!ids.empty() && random_.one_in(4)) ids.push_back(random_.pick(ids));
  return engine_.set_filters(ids, some_filters(ids.size()));
}

/// Half of the bodies meet half of the others; a third is static.
std::vector<BodyFilter> RandomCaller::some_filters(std::size_t count) {
  std::vector<BodyFilter> filters(count);
  for (BodyFilter& filter : filters) {
    if (random_.one_in(3)) continue;
    filter.category = 1U << random_.below(3) | (random_.one_in(8) ? 0x80000000U : 0U);
    filter.mask = random_.one_in(8) ? 0 : static_cast<std::uint32_t>(random_.bits()) | 1U;
    filter.is_static = random_.one_in(3);
  }
  return filters;
}

/// Bodies that no update ever sees.
AssertionResult RandomCaller::insert_and_remove() {
  const std::vector<BodyId> ids = some_absent(std::min<std::size_t>(3, room()));
  const AssertionResult inserted = engine_.insert(ids, make_boxes(kind_, random_, ids.size()));
  return inserted ? engine_.remove(ids) : inserted;
}

AssertionResult RandomCaller::remove_all() {
  return engine_.remove(engine_.model().ids());
}

AssertionResult RandomCaller::nothing_in_bulk() {
  if (AssertionResult inserted = engine_.insert({}, {}); !inserted) return inserted;
  if (AssertionResult moved = engine_.move({}, {}); !moved) return moved;
  return engine_.remove({});
}

/// How many bodies more there may be.
std::size_t RandomCaller::room() const {
  const std::size_t most = std::min(engine_.capacity(), names_.size());
  return most - std::min(most, engine_.model().boxes.size());
}

std::vector<BodyId> RandomCaller::some_present(std::size_t most) {
  return sample(random_, engine_.model().ids(), most);
}

std::vector<BodyId> RandomCaller::some_absent(std::size_t most) {
  std::vector<BodyId> absent = names_;
  std::erase_if(absent, [&](BodyId id) { return engine_.model().boxes.contains(id); });
  return sample(random_, absent, most);
}

std::vector<Aabb> RandomCaller::next_boxes(const std::vector<BodyId>& ids) {
  const std::vector<BodyId> present = engine_.model().ids();
  std::vector<Aabb> boxes;
  for (const BodyId id : ids) {
    const Aabb& box = engine_.model().boxes.at(id);
    boxes.push_back(next_box(kind_, random_, box, engine_.model().boxes.at(random_.pick(present))));
  }
  return boxes;
}

std::string story_of(const BoxKind& kind, std::size_t bodies, std::uint64_t seed) {
  return std::string(kind.name) + ", " + std::to_string(bodies) + " bodies, seed " + std::to_string(seed);
}

}  // namespace cellsweep::contract

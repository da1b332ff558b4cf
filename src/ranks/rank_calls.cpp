#include "ranks/rank_calls.h"

#include <algorithm>

#include "cellsweep/engine/engine.h"
#include "geometry/canonical.h"
#include "ranks/refusals.h"

namespace cellsweep::ranks {
namespace {

constexpr std::uint8_t kMovedDirectly = kHeld | kOwned;

// A body that the engine can be told of at once: held, owned, and without calls that wait.
bool is_direct(std::uint8_t flags) {
  return (flags & (kMovedDirectly | kStaged)) == kMovedDirectly;
}

}  // namespace

RankCalls::Presence RankCalls::presence(GlobalId id, Local local) const {
  if (const StagedCall* call = world_.calls.find(id)) return call->exists ? Presence::here : Presence::gone;
  if (local == kNoLocal) return Presence::unknown;
  if (!world_.held.is(local, kLinked)) return Presence::here;
  if (world_.held.link(local).now.exists) return Presence::here;
  // Removed by an update that failed; others may have inserted another one since.
  return world_.held.is(local, kOwned) ? Presence::gone : Presence::unknown;
}

void RankCalls::mark_staged(GlobalId id) {
  const Local local = world_.held.find(id);
  if (local != kNoLocal) world_.held.set(local, kStaged);
}

Status RankCalls::insert(std::span<const GlobalId> ids, std::span<const Aabb> boxes,
                         std::span<const BodyFilter> filters) {
  if (ids.size() != boxes.size()) return length_status(ids.size(), boxes.size(), "boxes");
  if (!filters.empty() && ids.size() != filters.size())
    return length_status(ids.size(), filters.size(), "filters");
  if (Status status = find_invalid_boxes(ids, boxes); !status.ok()) return status;
  if (Status status = find_listed_twice(ids); !status.ok()) return status;
  std::vector<GlobalId> present;
  for (const GlobalId id : ids) {
    if (presence(id, world_.held.find(id)) == Presence::here) present.push_back(id);
  }
  if (!present.empty())
    return refuse_bodies(StatusCode::duplicate_body, std::move(present), "in the world already");
  world_.calls.reserve(ids.size());
  for (std::size_t i = 0; i < ids.size(); ++i) {
    world_.calls.insert(ids[i], canonical(boxes[i]), filters.empty() ? BodyFilter() : filters[i]);
    mark_staged(ids[i]);
  }
  return {};
}

Status RankCalls::check_present(std::span<const GlobalId> ids) const {
  std::vector<GlobalId> gone;
  for (const GlobalId id : ids) {
    if (presence(id, world_.held.find(id)) == Presence::gone) gone.push_back(id);
  }
  return refuse_bodies(StatusCode::unknown_body, std::move(gone), "in no rank's world");
}

Status RankCalls::set_filters(std::span<const GlobalId> ids, std::span<const BodyFilter> filters) {
  if (ids.size() != filters.size()) return length_status(ids.size(), filters.size(), "filters");
  if (Status status = check_present(ids); !status.ok()) return status;
  world_.calls.reserve(ids.size());
  for (std::size_t i = 0; i < ids.size(); ++i) {
    world_.calls.set_filter(ids[i], filters[i]);
    mark_staged(ids[i]);
  }
  return {};
}

Status RankCalls::remove(std::span<const GlobalId> ids) {
  if (Status status = find_listed_twice(ids); !status.ok()) return status;
  if (Status status = check_present(ids); !status.ok()) return status;
  world_.calls.reserve(ids.size());
  for (const GlobalId id : ids) {
    world_.calls.remove(id);
    mark_staged(id);
  }
  return {};
}

// Most callers name the same bodies in every frame, in the same order, but for a few that came or went.
bool RankCalls::find_all(const Region& region, std::span<const GlobalId> ids, std::span<const Aabb> boxes) {
  const HeldBodies& held = world_.held;
  before_.swap(locals_);
  locals_.resize(ids.size());
  apart_.clear();
  bool all_direct = true;
  std::size_t next = 0;
  for (std::size_t i = 0; i < ids.size(); ++i) {
    Local local = next < before_.size() ? before_[next] : kNoLocal;
    if (held.has(local, ids[i])) {
      ++next;
    } else if (next + 1 < before_.size() && held.has(before_[next + 1], ids[i])) {
      local = before_[next + 1];
      next += 2;
    } else {
      local = held.find(ids[i]);
    }
    locals_[i] = local;
    const std::uint8_t flags = local == kNoLocal ? std::uint8_t{0} : held.flags(local);
    all_direct = all_direct && is_direct(flags);
    if ((flags & kLinked) != 0 || !encloses(region, canonical(boxes[i]))) apart_.push_back(i);
  }
  return all_direct;
}

Status RankCalls::move(const Region& region, std::span<const GlobalId> ids, std::span<const Aabb> boxes) {
  if (ids.size() != boxes.size()) return length_status(ids.size(), boxes.size(), "boxes");
  const bool all_direct = find_all(region, ids, boxes);
  return all_direct ? move_own(region, boxes) : move_mixed(region, ids, boxes);
}

Status RankCalls::move_own(const Region&, std::span<const Aabb> boxes) {
  linked_.clear();
  for (const std::size_t place : apart_) linked_.push_back(locals_[place]);
  make_links(linked_);
  if (Status status = engine_.move(locals_, boxes); !status.ok()) {
    std::vector<GlobalId> ids;
    for (const Local local : locals_) ids.push_back(world_.held.id(local));
    return find_invalid_boxes(ids, boxes);
  }
  for (const std::size_t place : apart_) {
    Link& link = world_.held.link(locals_[place]);
    link.now.box = canonical(boxes[place]);
    link.must_tell = true;
  }
  for (const Local local : locals_) world_.held.set(local, kNamed);
  return {};
}

Status RankCalls::move_mixed(const Region& region, std::span<const GlobalId> ids,
                             std::span<const Aabb> boxes) {
  if (Status status = find_invalid_boxes(ids, boxes); !status.ok()) return status;
  if (Status status = check_present(ids); !status.ok()) return status;
  std::vector<Aabb> direct;
  std::size_t kept = 0;
  std::vector<std::size_t> staged;
  apart_.clear();
  for (std::size_t i = 0; i < ids.size(); ++i) {
    const Local local = locals_[i];
    if (local == kNoLocal || !is_direct(world_.held.flags(local))) {
      staged.push_back(i);
      continue;
    }
    if (world_.held.is(local, kLinked) || !encloses(region, canonical(boxes[i]))) apart_.push_back(kept);
    locals_[kept++] = local;
    direct.push_back(boxes[i]);
  }
  locals_.resize(kept);
  world_.calls.reserve(staged.size());
  if (Status status = move_own(region, direct); !status.ok()) return status;
  for (const std::size_t place : staged) {
    world_.calls.move(ids[place], canonical(boxes[place]));
    mark_staged(ids[place]);
  }
  return {};
}

// A body without a link has the filter that it had at the last update.
void RankCalls::make_links(std::span<const Local> locals) {
  world_.held.reserve(0, locals.size());
  for (const Local local : locals) {
    world_.held.touch(local);
    if (world_.held.is(local, kLinked)) continue;
    Version before;
    Version now;
    before.filter = now.filter = engine_.filter(local).value_or(BodyFilter());
    before.exists = engine_.boxes({&local, 1}, {&before.box, 1}).ok();
    now.exists = EngineAccess::next_boxes(engine_, {&local, 1}, {&now.box, 1}).ok();
    Link& link = world_.held.make_link(local);
    link.before = before;
    link.now = now;
  }
}

void RankCalls::make_all_links() {
  linked_.clear();
  for (Local local = 0; local < world_.held.locals(); ++local) {
    if ((world_.held.flags(local) & kMovedDirectly) == kMovedDirectly) linked_.push_back(local);
  }
  make_links(linked_);
}

void RankCalls::take_own_calls(Directory& directory) {
  linked_.clear();
  std::vector<GlobalId> own;
  for (const StagedCall& call : world_.calls.calls()) {
    const Local local = world_.held.find(call.id);
    const bool came_and_went = !call.must_exist && !call.exists && call.is_known;
    if (local != kNoLocal && world_.held.is(local, kOwned)) {
      own.push_back(call.id);
      linked_.push_back(local);
    } else if (came_and_went) {
      own.push_back(call.id);
    }
  }
  if (own.empty()) return;
  directory.reserve(own.size());
  StagedCalls kept = world_.calls;
  kept.forget(own);
  make_links(linked_);
  for (const StagedCall& call : world_.calls.calls()) {
    const Local local = world_.held.find(call.id);
    if (local != kNoLocal && world_.held.is(local, kOwned)) {
      take(call, local);
    } else if (call.is_known && !call.exists) {
      directory.tell(call.id, true);
    }
  }
  world_.calls = std::move(kept);
}

void RankCalls::take(const StagedCall& call, Local local) {
  Link& link = world_.held.link(local);
  world_.held.clear(local, kStaged);
  world_.held.set(local, kNamed);
  link.must_tell = true;
  link.now.exists = call.exists;
  if (!call.exists) return;
  if (call.inserted) link.renewed = link.must_renew = true;
  if (call.has_box) link.now.box = call.box;
  if (!call.has_filter) return;
  link.now.filter = call.filter;
  link.must_filter = true;
}

}  // namespace cellsweep::ranks

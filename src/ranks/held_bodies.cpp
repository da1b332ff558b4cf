#include "ranks/held_bodies.h"

#include <algorithm>
#include <random>

namespace cellsweep::ranks {
namespace {

// Grows by half at least, so that little by little is not slow.
template <class T>
void make_room_for(std::vector<T>& list, std::size_t more) {
  const std::size_t wanted = list.size() + more;
  if (wanted > list.capacity()) list.reserve(std::max(wanted, list.capacity() + list.capacity() / 2));
}

}  // namespace

std::uint64_t new_table_key() {
  std::random_device device;
  return (std::uint64_t{device()} << 32 | device()) | 1;
}

std::size_t HeldBodies::count(std::uint8_t flag) const {
  std::size_t count = 0;
  for (const std::uint8_t flags : flags_) count += (flags & flag) != 0 ? 1U : 0U;
  return count;
}

void HeldBodies::clear_all(std::uint8_t flag) {
  const auto kept = static_cast<std::uint8_t>(~flag);
  for (std::uint8_t& flags : flags_) flags &= kept;
}

void HeldBodies::commit_flags() {
  for (std::uint8_t& flags : flags_) {
    const int kept = flags & ~kWasOwned;
    flags = static_cast<std::uint8_t>(kept | (flags & kOwned) << 5);
  }
}

void HeldBodies::reserve(std::size_t bodies, std::size_t links) {
  table_.reserve(table_.size() + bodies);
  make_room_for(ids_, bodies);
  make_room_for(flags_, bodies);
  make_room_for(link_of_, bodies);
  free_.reserve(ids_.capacity());
  make_room_for(links_, links);
  free_links_.reserve(links_.capacity());
  // A body is among them once.
  touched_.reserve(ids_.capacity());
}

Local HeldBodies::add(GlobalId id) {
  Local local = static_cast<Local>(ids_.size());
  if (free_.empty()) {
    ids_.push_back(id);
    flags_.push_back(0);
    link_of_.push_back(0);
  } else {
    local = free_.back();
    free_.pop_back();
    ids_[local] = id;
  }
  table_.insert(id, local);
  return local;
}

void HeldBodies::forget(Local local) {
  if (is(local, kLinked)) drop_link(local);
  table_.erase(ids_[local]);
  flags_[local] = 0;
  free_.push_back(local);
}

Link& HeldBodies::make_link(Local local) {
  if (is(local, kLinked)) return link(local);
  set(local, kLinked);
  if (free_links_.empty()) {
    link_of_[local] = static_cast<std::uint32_t>(links_.size());
    links_.emplace_back();
  } else {
    link_of_[local] = free_links_.back();
    free_links_.pop_back();
  }
  return link(local);
}

void HeldBodies::drop_link(Local local) {
  link(local) = Link();
  free_links_.push_back(link_of_[local]);
  clear(local, kLinked);
}

void HeldBodies::touch(Local local) {
  if (is(local, kTouched)) return;
  set(local, kTouched);
  touched_.push_back(local);
}

void HeldBodies::clear_touched() {
  for (const Local local : touched_) clear(local, kTouched);
  touched_.clear();
}

std::size_t HeldBodies::bytes() const {
  return table_.bytes() + ids_.capacity() * (sizeof(GlobalId) + 1 + 4 + 2 * sizeof(Local)) +
         links_.capacity() * (sizeof(Link) + 4);
}

}  // namespace cellsweep::ranks

/// @file
/// The bodies that have moved since the broadphase was last told.
#pragma once

#include <cellsweep/aabb.h>
#include <cellsweep/pair.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

/// Each body once, with the box that it has now. Where it stands in the list its owner keeps: to tell each
/// body when the list has been emptied would be one more look at all of them, which the step has put out of
/// the caches.
class MovedList {
 public:
  /// Room for so many bodies. Throws std::bad_alloc, and nothing has changed; the others take no memory.
  void reserve(std::size_t bodies) {
    ids_.resize(bodies);
    boxes_.resize(bodies);
  }

  /// Whether a body is in the list, which once stood at this place.
  bool has(cellsweep::BodyId id, std::uint32_t place) const { return place < size_ && ids_[place] == id; }

  /// Enters a body or its next box.
  void put(cellsweep::BodyId id, const cellsweep::Aabb& box, std::uint32_t& place) {
    if (!has(id, place)) {
      place = size_++;
      ids_[place] = id;
    }
    boxes_[place] = box;
  }

  /// Takes out the one at a place; the last one, which is returned, stands there now.
  cellsweep::BodyId take_out(std::uint32_t place) {
    --size_;
    boxes_[place] = boxes_[size_];
    return ids_[place] = ids_[size_];
  }

  void clear() { size_ = 0; }

  std::span<const cellsweep::BodyId> ids() const { return {ids_.data(), size_}; }
  std::span<const cellsweep::Aabb> boxes() const { return {boxes_.data(), size_}; }

 private:
  std::vector<cellsweep::BodyId> ids_;
  std::vector<cellsweep::Aabb> boxes_;
  std::uint32_t size_ = 0;
};

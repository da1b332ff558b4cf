/// @file
/// Boxes in rows, as the kernels of queries take them: those of a cell, or all by slot.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>

#include "cellsweep/engine/cell_boxes.h"
#include "queries/world.h"

namespace cellsweep::queries {

/// Of a body in a tree's node.
inline Candidate candidate_of(const TreeNode& node, std::size_t place) {
  const auto face = [&](std::size_t number) { return node.faces[number][place]; };
  return {node.content[place], {{face(0), face(1), face(2)}, {face(3), face(4), face(5)}}};
}

/// What a kernel writes.
using Places = std::array<std::uint32_t, kRowBoxes + kMostLanes>;
using Keys = std::array<std::uint64_t, kRowBoxes + kMostLanes>;

/// Makes places in a row of boxes by slot, `first` being that of the row's first box, slots; without bodies
/// that the last update did not see. Returns how many are left.
inline std::uint32_t keep_seen(const World& world, Slot first, Places& places, std::uint32_t found) {
  std::uint32_t kept = 0;
  for (std::uint32_t i = 0; i < found; ++i) {
    const Slot slot = first + places[i];
    places[kept] = slot;
    kept += world.is_seen(slot) ? 1 : 0;
  }
  return kept;
}

/// Asks for the first boxes of a cell that will be looked at soon, so many bytes of them.
inline void prefetch(const stream::CellBoxes& cell, std::size_t bytes) {
  constexpr std::size_t kCacheLine = 64;
  const auto* const boxes = reinterpret_cast<const std::byte*>(cell.boxes);
  for (std::size_t line = 0; line < bytes; line += kCacheLine) __builtin_prefetch(boxes + line);
}

/// Calls `look(row, first)` for the boxes of a cell, `first` being the place of the row's first box, until it
/// returns false; then returns false.
template <class Look>
bool for_each_row(const stream::CellBoxes& cell, const Look& look) {
  for (std::uint32_t first = 0; first < cell.count; first += kRowBoxes) {
    const std::uint32_t count = cell.count - first < kRowBoxes ? cell.count - first : kRowBoxes;
    const auto* const from = reinterpret_cast<const std::byte*>(cell.boxes + first);
    if (!look(BoxRow{from, sizeof(stream::TaggedBox), count}, first)) return false;
  }
  return true;
}

/// The same for boxes by slot. Behind the last ones there may be nothing to read, so these are copied.
template <class Look>
bool for_each_row(std::span<const Aabb> boxes, const Look& look) {
  const std::size_t whole = boxes.size() / kMostLanes * kMostLanes;
  for (std::size_t first = 0; first < whole; first += kRowBoxes) {
    const auto count = static_cast<std::uint32_t>(whole - first < kRowBoxes ? whole - first : kRowBoxes);
    const auto* const from = reinterpret_cast<const std::byte*>(boxes.data() + first);
    if (!look(BoxRow{from, sizeof(Aabb), count}, static_cast<std::uint32_t>(first))) return false;
  }
  if (whole == boxes.size()) return true;
  std::array<Aabb, kMostLanes> last;
  last.fill(kNobody);
  std::memcpy(last.data(), boxes.data() + whole, (boxes.size() - whole) * sizeof(Aabb));
  const auto* const from = reinterpret_cast<const std::byte*>(last.data());
  const auto count = static_cast<std::uint32_t>(boxes.size() - whole);
  return look(BoxRow{from, sizeof(Aabb), count}, static_cast<std::uint32_t>(whole));
}

}  // namespace cellsweep::queries

/// @file
/// The cells of engine `stream` as those see them who find the pairs in them.
#pragma once

#include <cstddef>
#include <cstdint>

#include "cellsweep/aabb.h"
#include "cellsweep/engine/slots.h"
#include "cellsweep/export.h"

namespace cellsweep::stream {

/// A tag holds a body's slot and, above kSlotBits, on which axes the body's minimum lies in the cell. All
/// axes:
inline constexpr std::uint32_t kWholeFlags = 7;

/// A box in a cell. Boxes come into cells in no order: to write one, a single cache line is fetched.
struct alignas(32) TaggedBox {
  Aabb box;
  std::uint32_t tag;
  std::uint32_t unused;
};

/// Kernels read boxes by so many, or by fewer where their vectors hold fewer.
inline constexpr unsigned kBoxesTogether = 8;

/// The boxes of one cell. `count` of `capacity` hold something; `capacity` is a multiple of how many the
/// kernels read together.
struct CellBoxes {
  TaggedBox* boxes = nullptr;
  std::uint32_t count = 0;
  std::uint32_t capacity = 0;
};

/// Thrown where more pairs are found than asked for.
struct CELLSWEEP_API TooManyPairs {};

/// Pair keys (pair_key()), growing. The kernels write behind the end and move it.
struct KeyBuffer {
  std::uint64_t* keys = nullptr;
  std::size_t size = 0;
  std::size_t capacity = 0;
  std::size_t most = ~std::size_t{0};  // larger than this, it does not grow: TooManyPairs
  void (*grow)(KeyBuffer& buffer, std::size_t more) = nullptr;
};

// Internal, because kernels call it: src/engines/stream/kernels/body.h says why.
namespace {

/// Makes room for `more` keys behind the end.
inline void make_room(KeyBuffer& buffer, std::size_t more) {
  if (buffer.capacity - buffer.size < more) buffer.grow(buffer, more);
}

}  // namespace

}  // namespace cellsweep::stream

/// @file
/// What crosses by DMA between engine `stream` and its SPU program. As wire.h: 32-bit words only, C++17, for
/// both sides.
#pragma once

#include "engines/cell/wire.h"

namespace cellsweep::cell {

/// Boxes that an SPU holds at a time, of each of two blocks and of their successors.
inline constexpr std::uint32_t kStreamBlock = 256;

/// A box: min x, y, z, max x, y, z, tag, one word unused.
inline constexpr std::uint32_t kStreamWords = 8;
inline constexpr std::uint32_t kStreamTag = 6;

/// A block of boxes compared with itself or with another one of the same cell.
struct StreamPiece {
  WireAddress boxes;    ///< of the cell, kStreamWords words each
  std::uint32_t first;  ///< the box that the block begins with
  std::uint32_t first_count;
  std::uint32_t second;  ///< of the other block; the same as `first` for a block and itself
  std::uint32_t second_count;
  std::uint32_t unused[2];
};
static_assert(sizeof(StreamPiece) == 32);

/// Pieces that an SPU is sent at a time.
inline constexpr std::uint32_t kStreamPieces = 128;
/// Pairs that leave an SPU at a time: two words each.
inline constexpr std::uint32_t kStreamPairs = 1024;
/// The words of a pair that is none: it fills a transfer up.
inline constexpr std::uint32_t kNoStreamPair = 0xffffffff;

/// Of a tag: a body's slot, and above that a bit for each axis on which its minimum lies in the cell. A cell
/// owns a pair when together they have all three.
inline constexpr std::uint32_t kTagBits = 29;

/// What one SPU does.
struct alignas(kDmaAlign) StreamJob {
  WireAddress pieces;
  WireAddress pairs;        ///< out: slots of overlapping bodies, two words a pair
  WireAddress result;       ///< out: a StreamResult
  std::uint32_t count;      ///< of pieces
  std::uint32_t rows_done;  ///< boxes of the first block of the first piece that were compared before
  std::uint32_t room;       ///< for so many pairs, a multiple of kStreamPairs
  std::uint32_t unused[23];
};
static_assert(sizeof(StreamJob) == kDmaAlign);

/// How far an SPU came until the room was full, or through all.
struct alignas(kDmaAlign) StreamResult {
  std::uint32_t pieces_done;
  std::uint32_t rows_done;  ///< of the piece after these
  std::uint32_t pairs;      ///< written, with those that are none
  std::uint32_t unused[29];
};
static_assert(sizeof(StreamResult) == kDmaAlign);

}  // namespace cellsweep::cell

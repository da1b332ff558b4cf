/// @file
/// What crosses between host and SPUs in engine cell-resident: one job for life, records of changed bodies
/// in, words that name pairs out. 32-bit words only; C++17, for both sides.
#pragma once

#include "engines/cell/wire.h"

namespace cellsweep::cell {

/// Slots of bodies and places in a sorted axis are below this, so that two slots and a mark fit into a word.
/// A slot is here what the host's PlacedEngine calls a place.
inline constexpr std::uint32_t kResidentSlots = 32767;
inline constexpr std::uint32_t kResidentSlotBits = 15;

/// Events are sent in pieces of this many words; a main-memory buffer for events is a multiple of it.
inline constexpr std::uint32_t kResidentEventChunk = 1024;

/// Poses of four bodies, a lane each (F3).
struct alignas(16) PoseBlock {
  float orientation[4][4];   ///< quaternion: x, y, z, w
  float half_extents[3][4];  ///< by axis
  float centre[3][4];        ///< by axis
};
static_assert(sizeof(PoseBlock) == 160);

/// What encloses four bodies on one axis.
struct alignas(16) IntervalBlock {
  float low[4];
  float high[4];
};
static_assert(sizeof(IntervalBlock) == 32);

/// Blocks of poses that an SPU fetches at a time.
inline constexpr std::uint32_t kPosePiece = 16;

/// What an SPU keeps for its whole life.
struct alignas(kDmaAlign) ResidentJob {
  std::uint32_t spu;      ///< number of this SPU
  std::uint32_t spus;     ///< how many share the changed bodies
  std::uint32_t axis;     ///< the axis that it keeps sorted
  std::uint32_t bodies;   ///< room for bodies, a multiple of 16
  std::uint32_t changes;  ///< records of one order at most, a power of two, 16 at least
  WireAddress records;    ///< ResidentRecord[changes], the same for all SPUs
  WireAddress events;     ///< this SPU's own buffer for the events of one order
  WireAddress poses;      ///< PoseBlock[bodies / 4], the same for all SPUs; 0: no boxes are made
  WireAddress intervals;  ///< IntervalBlock[bodies / 4] of this SPU's axis
  std::uint32_t unused[19];
};
static_assert(sizeof(ResidentJob) == kDmaAlign);

/// One body of an order. Orders to remove use the slot only.
struct alignas(16) ResidentRecord {
  float min[3];
  std::uint32_t slot;
  float max[3];
  std::uint32_t unused;  ///< 0
};
static_assert(sizeof(ResidentRecord) == 32);

/// What a mailbox word orders: the kind in the low three bits, the number of records above. The SPU answers
/// in its interrupt mailbox with the number of events that it has put into its buffer; its first answer, 0,
/// comes without an order and says that it has its buffers and waits.
enum class ResidentOrder : std::uint32_t {
  stop = 0,    ///< end the program; no answer
  remove = 1,  ///< these bodies are gone
  move = 2,    ///< these bodies, all known, have new boxes; one may be listed several times, always the same
  insert = 3,  ///< these bodies are new
  bound = 4,   ///< enclose these poses on the SPU's axis; no events
};

inline constexpr std::uint32_t kResidentOrderBits = 3;

constexpr std::uint32_t resident_word(ResidentOrder order, std::uint32_t records) {
  return (records << kResidentOrderBits) | static_cast<std::uint32_t>(order);
}

/// An event: the pair's slots, and whether the pair began or ended. No pair occurs twice in the events of one
/// order, of all SPUs together.
inline constexpr std::uint32_t kResidentBegan = 1U << 31;

constexpr std::uint32_t resident_event(std::uint32_t flag, std::uint32_t slot, std::uint32_t other) {
  return flag | (slot << kResidentSlotBits) | other;
}

}  // namespace cellsweep::cell

/// @file
/// What crosses between host and SPUs by DMA: 32-bit words only, so that it means the same on a little-endian
/// host and a big-endian SPU. No pointer, no Eigen; C++17, for both sides.
#pragma once

#include <cstddef>
#include <cstdint>

namespace cellsweep::cell {

inline constexpr std::uint32_t kMaxTransfer = 16384;  ///< bytes of one DMA command (C4)
inline constexpr std::uint32_t kDmaAlign = 128;       ///< bytes
inline constexpr std::uint32_t kLanes = 4;            ///< 32-bit words of a vector

/// The bit pattern of +infinity: above every finite value in SSE's and in the SPU's order (C2).
inline constexpr std::uint32_t kPaddingValueBits = 0x7f800000;

/// `n` rounded up to a multiple of `to`.
constexpr std::uint32_t round_up(std::uint32_t n, std::uint32_t to) {
  return (n + to - 1) / to * to;
}

/// Bytes of `words` 32-bit words as a transfer of whole DMA lines carries them.
constexpr std::uint32_t dma_bytes(std::uint32_t words) {
  return round_up(words * 4, kDmaAlign);
}

/// A main-memory address in two words.
struct WireAddress {
  std::uint32_t high;
  std::uint32_t low;
};

// ---- cell-paper

/// The top bit of an ID word marks a maximum (C9); literal mode has plain IDs.
inline constexpr std::uint32_t kMaximumFlag = 0x80000000;

/// The ID word of padding, and of a position that did not change (C9).
inline constexpr std::uint32_t kUnchanged = 0xffffffff;

/// Largest ID, so that a key holds two (Listing 4.1). IDs start at 1.
inline constexpr std::uint32_t kLargestPaperId = 65535;

/// Listing 4.1's key of a pair: the smaller ID in the low half, the larger one in the high half.
constexpr std::uint32_t pair_key_of_ids(std::uint32_t one, std::uint32_t other) {
  return one < other ? one | (other << 16) : other | (one << 16);
}

/// Bits of PaperJob::flags.
enum PaperFlags : std::uint32_t {
  kPaperInitial = 1,  ///< the arrays are new: every ID counts as changed
  kPaperLiteral = 2,  ///< the document's own logic
  kPaperMethod2 = 4,  ///< overlap method 2 (C12)
  kPaperListDma = 8,  ///< keys go out by DMA list (C13)
};

/// What the SPU of one axis does in a frame.
struct alignas(kDmaAlign) PaperJob {
  WireAddress values;       ///< in: endpoint values, `endpoints` floats (C2)
  WireAddress ids;          ///< in: their ID words
  WireAddress body_values;  ///< in, method 2: min and max of ID at 2·ID − 2, for IDs 1 … largest_id (C12)
  WireAddress sorted_ids;   ///< out: ID words in the order of the sorted values (C3)
  WireAddress changed;      ///< out: IDs that changed, descending, each once; room for `endpoints` words
  WireAddress keys;         ///< out: keys of pairs that overlap on the axis (C11, C12)
  WireAddress apart_keys;   ///< out, method 2: keys of pairs that do not
  WireAddress result;       ///< out: a PaperResult
  std::uint32_t endpoints;  ///< with padding, a multiple of kLanes
  std::uint32_t largest_id;
  std::uint32_t flags;
  std::uint32_t unused[13];
};
static_assert(sizeof(PaperJob) == kDmaAlign);

struct alignas(kDmaAlign) PaperResult {
  std::uint32_t changed;
  std::uint32_t keys;
  std::uint32_t apart_keys;
  std::uint32_t unused[29];
};
static_assert(sizeof(PaperResult) == kDmaAlign);

/// Keys that leave the local store at a time: a chunk of one command, or a list of several (C13).
inline constexpr std::uint32_t kChunkBytes = kMaxTransfer;
inline constexpr std::uint32_t kListBytes = 2 * kMaxTransfer;

// ---- the document's first attempt (F5), for a benchmark

/// Listing 4.3's endpoint as it must be copied for an SPU: what the pointers led to.
struct FirstAttemptEndpoint {
  std::uint32_t id;  ///< with kMaximumFlag
  float value;
  float min;  ///< of the owner on this axis
  float max;
};

/// Set in a key when the pair overlaps; IDs stay below 2^15.
inline constexpr std::uint32_t kOverlapFlag = 0x80000000;

/// What the SPU of one axis does in a frame.
struct alignas(kDmaAlign) FirstAttemptJob {
  WireAddress endpoints;  ///< in, and sorted out
  WireAddress events;     ///< out: a key for every swap
  WireAddress result;     ///< out: 128 bytes, the first word is the number of events
  std::uint32_t count;    ///< of endpoints
  std::uint32_t unused[25];
};
static_assert(sizeof(FirstAttemptJob) == kDmaAlign);

// ---- cell-brute

/// Bodies are laid out in whole rows of this many, so that a row of overlap bits is a whole quadword.
inline constexpr std::uint32_t kBruteBlock = 128;

/// What one SPU of cell-brute does in a frame: tests its changed bodies against all bodies.
struct alignas(kDmaAlign) BruteJob {
  WireAddress boxes;    ///< six arrays of `bodies` floats: min x, y, z, max x, y, z
  WireAddress changed;  ///< this SPU's share of the changed bodies, one word each, padded to whole lines
  WireAddress rows;     ///< a row of bodies / 32 words for each of them: bit 31 − (j mod 32) of word j / 32
  std::uint32_t bodies;  ///< a multiple of kBruteBlock
  std::uint32_t count;
  std::uint32_t unused[24];
};
static_assert(sizeof(BruteJob) == kDmaAlign);

}  // namespace cellsweep::cell

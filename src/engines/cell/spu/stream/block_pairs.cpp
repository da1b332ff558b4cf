#include "engines/cell/spu/stream/block_pairs.h"

namespace cellsweep::cell {
namespace {

constexpr unsigned int kFaces = 6;
constexpr std::uint32_t kAllLanes = 15;
constexpr std::uint32_t kSlotMask = (1U << kTagBits) - 1;

/// Four bits, the first box's on the left: which of four boxes are apart on no axis.
inline std::uint32_t overlaps_of_four(const Columns& others, std::uint32_t four, const vec_float4* own) {
  vec_uint4 apart = spu_splats(0U);
  for (unsigned int axis = 0; axis < 3; ++axis) {
    const vec_float4 min = others.array(axis)[four];
    const vec_float4 max = others.array(axis + 3)[four];
    apart = spu_or(apart, spu_or(spu_cmpgt(own[axis], max), spu_cmpgt(min, own[axis + 3])));
  }
  return spu_extract(spu_gather(spu_nor(apart, apart)), 0);
}

inline void add_lanes(std::uint32_t lanes, std::uint32_t first, std::uint32_t tag, const Columns& others,
                      PairStream& pairs) {
  for (std::uint32_t lane = 0; lane < 4; ++lane) {
    if ((lanes & (8U >> lane)) == 0) continue;
    const std::uint32_t other = others.tag(first + lane);
    if ((tag | other) >> kTagBits == 7) pairs.add(tag & kSlotMask, other & kSlotMask);
  }
}

/// The first halves of two vectors in turns, and the second ones.
inline vec_float4 first_halves(vec_float4 a, vec_float4 b) {
  const vec_uchar16 pattern = {0, 1, 2, 3, 16, 17, 18, 19, 4, 5, 6, 7, 20, 21, 22, 23};
  return spu_shuffle(a, b, pattern);
}
inline vec_float4 second_halves(vec_float4 a, vec_float4 b) {
  const vec_uchar16 pattern = {8, 9, 10, 11, 24, 25, 26, 27, 12, 13, 14, 15, 28, 29, 30, 31};
  return spu_shuffle(a, b, pattern);
}

struct FourColumns {
  vec_float4 column[4];
};

/// The same half of four boxes: `boxes` is the first one's.
inline FourColumns columns_of_four(const vec_float4* boxes) {
  const vec_float4 low = first_halves(boxes[0], boxes[4]);
  const vec_float4 low_other = first_halves(boxes[2], boxes[6]);
  const vec_float4 high = second_halves(boxes[0], boxes[4]);
  const vec_float4 high_other = second_halves(boxes[2], boxes[6]);
  return {{first_halves(low, low_other), second_halves(low, low_other), first_halves(high, high_other),
           second_halves(high, high_other)}};
}

}  // namespace

void Columns::fill(const Block& block) {
  constexpr unsigned int kNext = kStreamBlock / 4;
  count = block.count;
  for (std::uint32_t four = 0; 4 * four < count; ++four) {
    const FourColumns front = columns_of_four(block.boxes + 8 * four);
    const FourColumns back = columns_of_four(block.boxes + 8 * four + 1);
    for (unsigned int i = 0; i < 4; ++i) arrays[i * kNext + four] = front.column[i];
    for (unsigned int i = 0; i < 3; ++i) arrays[(4 + i) * kNext + four] = back.column[i];
  }
}

void add_row(const Block& block, std::uint32_t row, const Columns& others, std::uint32_t from,
             PairStream& pairs) {
  vec_float4 own[kFaces];
  for (unsigned int face = 0; face < kFaces; ++face) own[face] = spu_splats(block.value(face, row));
  const std::uint32_t tag = block.tag(row);
  std::uint32_t wanted = kAllLanes >> (from & 3U);  // of the first four
  for (std::uint32_t first = from & ~3U; first < others.count; first += 4) {
    if (others.count - first < 4) wanted &= ~(kAllLanes >> (others.count - first));
    const std::uint32_t lanes = overlaps_of_four(others, first / 4, own) & wanted;
    if (lanes != 0) add_lanes(lanes, first, tag, others, pairs);
    wanted = kAllLanes;
  }
}

}  // namespace cellsweep::cell

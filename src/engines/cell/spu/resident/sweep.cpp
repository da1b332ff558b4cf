#include "engines/cell/spu/resident/sweep.h"

#include "engines/cell/spu/resident/search.h"

namespace cellsweep::cell {
namespace {

constexpr unsigned int kFour = 15;

/// A box against four.
struct Probe {
  explicit Probe(const BodyBox& box)
      : low{spu_splats(spu_extract(box.low, 0)), spu_splats(spu_extract(box.low, 1)),
            spu_splats(spu_extract(box.low, 2))},
        high{spu_splats(spu_extract(box.high, 0)), spu_splats(spu_extract(box.high, 1)),
             spu_splats(spu_extract(box.high, 2))} {}

  /// Bits of those that it does not overlap.
  unsigned int apart(const BoxBlock& block) const {
    const vec_uint4 x = spu_or(spu_cmpgt(block.low[0], high[0]), spu_cmpgt(low[0], block.high[0]));
    const vec_uint4 y = spu_or(spu_cmpgt(block.low[1], high[1]), spu_cmpgt(low[1], block.high[1]));
    const vec_uint4 z = spu_or(spu_cmpgt(block.low[2], high[2]), spu_cmpgt(low[2], block.high[2]));
    return mask_bits(spu_or(spu_or(x, y), z));
  }

  vec_float4 low[3];
  vec_float4 high[3];
};

}  // namespace

void Sweep::sweep(const BodyBox& own, unsigned int record) {
  const Probe probe(own);
  const unsigned int axis = axis_.axis;
  // No body of an earlier block reaches up to the box; none of those that begin above it overlaps it.
  first_ =
      count_less(axis_.reach, axis_.reach_vectors(), spu_extract(own.low, static_cast<int>(axis)), first_);
  const float end = spu_extract(own.high, static_cast<int>(axis));
  const BoxBlock* last = axis_.blocks + axis_.block_count();
  for (const BoxBlock* block = axis_.blocks + first_; block < last; ++block) {
    if (spu_extract(block->low[axis], 0) > end) break;
    const unsigned int apart = probe.apart(*block);
    if (__builtin_expect(apart != kFour, 0)) judge(*block, kFour ^ apart, own, record);
  }
}

// Only pairs that a body's own mark does not exclude: itself, and those that send the pair themselves.
void Sweep::judge(const BoxBlock& block, unsigned int hits, const BodyBox& own, unsigned int record) {
  const vec_uint4 marks = spu_rlmask(block.tag, -static_cast<int>(kMarkShift));
  const unsigned int unmarked = mask_bits(spu_cmpeq(marks, spu_splats(0U)));
  hits &= unmarked | mask_bits(spu_cmpgt(marks, spu_splats(record + 1)));
  if (hits == 0) return;
  if (elsewhere_ != nullptr) hits &= ~unmarked | Probe(elsewhere_[record]).apart(block);
  const unsigned int event = resident_event(flag_, slot_of(own), 0);
  for (unsigned int lane = 0, bit = 8; bit != 0; ++lane, bit /= 2) {
    if ((hits & bit) == 0) continue;
    const unsigned int tag = spu_extract(block.tag, static_cast<int>(lane));
    const bool both_marked = elsewhere_ != nullptr && (tag >> kMarkShift) != 0;
    if (both_marked && overlap(elsewhere_[record], elsewhere_[(tag >> kMarkShift) - 1])) continue;
    events_.append(event | (tag & kTagSlots));
  }
}

}  // namespace cellsweep::cell

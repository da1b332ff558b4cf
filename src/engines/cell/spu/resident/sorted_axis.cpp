#include "engines/cell/spu/resident/sorted_axis.h"

namespace cellsweep::cell {
namespace {

constexpr unsigned int kLowest = 0xff7fffff;  // the bits of the lowest finite value

constexpr unsigned int kVectors = sizeof(BoxBlock) / sizeof(vec_float4);
constexpr unsigned int kTagWord = 24;

/// The first of the seven words of a place; each next one is a vector further.
inline unsigned int* words_at(const SortedAxis& axis, unsigned int place) {
  return (unsigned int*)(axis.blocks + place / 4) + place % 4;
}

inline unsigned int low_word(const SortedAxis& axis) {
  return 4 * axis.axis;
}
inline unsigned int high_word(const SortedAxis& axis) {
  return 12 + 4 * axis.axis;
}

inline float key_at(const SortedAxis& axis, unsigned int place) {
  return *(const float*)(words_at(axis, place) + low_word(axis));
}

inline void note_place(SortedAxis& axis, unsigned int place) {
  axis.place[words_at(axis, place)[kTagWord] & kTagSlots] = static_cast<std::uint16_t>(place);
}

inline void copy_place(SortedAxis& axis, unsigned int to, unsigned int from) {
  unsigned int* target = words_at(axis, to);
  const unsigned int* source = words_at(axis, from);
  for (unsigned int i = 0; i < kVectors; ++i) target[4 * i] = source[4 * i];
}

inline void put_box(SortedAxis& axis, unsigned int place, const BodyBox& box) {
  unsigned int* target = words_at(axis, place);
  const auto* source = (const unsigned int*)&box;
  for (unsigned int i = 0; i < 3; ++i) {
    target[4 * i] = source[i];
    target[12 + 4 * i] = source[4 + i];
  }
  target[kTagWord] = source[3];
}

void pad_block(SortedAxis& axis) {
  for (unsigned int place = axis.count; place % 4 != 0; ++place) {
    words_at(axis, place)[low_word(axis)] = kPaddingValueBits;
    words_at(axis, place)[high_word(axis)] = kLowest;
    words_at(axis, place)[kTagWord] = 0;
  }
}

void refresh_places(SortedAxis& axis, unsigned int first) {
  for (unsigned int place = first; place < axis.count; ++place) note_place(axis, place);
}

inline vec_float4 larger(vec_float4 a, vec_float4 b) {
  return spu_sel(a, b, spu_cmpgt(b, a));
}

/// WordWriter for the seven vectors of a block, whose words stay together.
class BlockWriter {
 public:
  explicit BlockWriter(BoxBlock* out) : out_((vec_uint4*)out) {}

  void append(const vec_uint4* block, unsigned int bits) {
    const unsigned int together = held_count_ + count_bits(bits);
    const vec_uchar16 join = kJoin[held_count_];
    const vec_uchar16 rest = kRest[held_count_];
    for (unsigned int i = 0; i < kVectors; ++i) {
      const vec_uint4 chosen = spu_shuffle(block[i], block[i], kCompress[bits]);
      const vec_uint4 joined = spu_shuffle(held_[i], chosen, join);
      if (together >= 4) out_[i] = joined;
      held_[i] = together >= 4 ? spu_shuffle(chosen, chosen, rest) : joined;
    }
    out_ += together >= 4 ? kVectors : 0;
    written_ += together >= 4 ? 4 : 0;
    held_count_ = together & 3U;
  }

  unsigned int finish() {
    for (unsigned int i = 0; i < kVectors && held_count_ != 0; ++i) out_[i] = held_[i];
    return written_ + held_count_;
  }

 private:
  vec_uint4* out_;
  vec_uint4 held_[kVectors] = {};
  unsigned int held_count_ = 0;
  unsigned int written_ = 0;
};

}  // namespace

BodyBox box_at(const SortedAxis& axis, unsigned int place) {
  BodyBox box = {spu_splats(0.0F), spu_splats(0.0F)};
  auto* target = (unsigned int*)&box;
  const unsigned int* source = words_at(axis, place);
  for (unsigned int i = 0; i < 3; ++i) {
    target[i] = source[4 * i];
    target[4 + i] = source[12 + 4 * i];
  }
  target[3] = source[kTagWord];
  return box;
}

void set_tag_at(const SortedAxis& axis, unsigned int place, unsigned int tag) {
  words_at(axis, place)[kTagWord] = tag;
}

void refresh_reach(SortedAxis& axis, unsigned int first) {
  auto* reach = (float*)axis.reach;
  unsigned int block = first / 4;
  vec_float4 largest = block == 0 ? (vec_float4)spu_splats(kLowest) : spu_splats(reach[block - 1]);
  for (; block < axis.block_count(); ++block) {
    const vec_float4 high = axis.blocks[block].high[axis.axis];
    const vec_float4 pairs = larger(high, spu_shuffle(high, high, word_pattern(2, 3, 0, 1)));
    largest = larger(largest, larger(pairs, spu_shuffle(pairs, pairs, word_pattern(1, 0, 3, 2))));
    reach[block] = spu_extract(largest, 0);
  }
  for (; block % 4 != 0; ++block) ((unsigned int*)axis.reach)[block] = kPaddingValueBits;
}

unsigned int move_body(SortedAxis& axis, unsigned int place, const BodyBox& box) {
  const float key = spu_extract(box.low, static_cast<int>(axis.axis));
  unsigned int target = place;
  while (target > 0 && key_at(axis, target - 1) > key) {
    copy_place(axis, target, target - 1);
    note_place(axis, target);
    --target;
  }
  const unsigned int lowest = target;
  const bool may_rise = target == place;
  while (may_rise && target + 1 < axis.count && key_at(axis, target + 1) < key) {
    copy_place(axis, target, target + 1);
    note_place(axis, target);
    ++target;
  }
  put_box(axis, target, box);
  note_place(axis, target);
  return lowest;
}

void remove_marked(SortedAxis& axis) {
  BlockWriter writer(axis.blocks);
  const vec_uint4 numbers = {0, 1, 2, 3};
  for (unsigned int block = 0; block < axis.block_count(); ++block) {
    const vec_uint4 marked = spu_cmpgt(axis.blocks[block].tag, spu_splats(kTagSlots));
    const vec_uint4 filled = spu_cmpgt(spu_splats(axis.count - 4 * block), numbers);
    writer.append((const vec_uint4*)(axis.blocks + block), mask_bits(spu_andc(filled, marked)));
  }
  axis.count = writer.finish();
  pad_block(axis);
  refresh_places(axis, 0);
  refresh_reach(axis, 0);
}

void merge_bodies(SortedAxis& axis, const BodyBox* boxes, const int* order, unsigned int count) {
  unsigned int old_left = axis.count;
  axis.count += count;
  unsigned int out = axis.count;
  pad_block(axis);
  while (count != 0) {
    const BodyBox& box = boxes[order[count - 1]];
    const float key = spu_extract(box.low, static_cast<int>(axis.axis));
    for (; old_left != 0 && key_at(axis, old_left - 1) > key; --old_left)
      copy_place(axis, --out, old_left - 1);
    put_box(axis, --out, box);
    --count;
  }
  refresh_places(axis, out);
  refresh_reach(axis, out);
}

}  // namespace cellsweep::cell

/// @file
/// Shuffle patterns that move whole words, and the compaction of words that is built on them (F2).
#pragma once

#include <spu_intrinsics.h>

#include <cstdint>

namespace cellsweep::cell {

constexpr vec_uchar16 word_pattern(unsigned int a, unsigned int b, unsigned int c, unsigned int d) {
  vec_uchar16 pattern = {static_cast<unsigned char>(4 * a),     static_cast<unsigned char>(4 * a + 1),
                         static_cast<unsigned char>(4 * a + 2), static_cast<unsigned char>(4 * a + 3),
                         static_cast<unsigned char>(4 * b),     static_cast<unsigned char>(4 * b + 1),
                         static_cast<unsigned char>(4 * b + 2), static_cast<unsigned char>(4 * b + 3),
                         static_cast<unsigned char>(4 * c),     static_cast<unsigned char>(4 * c + 1),
                         static_cast<unsigned char>(4 * c + 2), static_cast<unsigned char>(4 * c + 3),
                         static_cast<unsigned char>(4 * d),     static_cast<unsigned char>(4 * d + 1),
                         static_cast<unsigned char>(4 * d + 2), static_cast<unsigned char>(4 * d + 3)};
  return pattern;
}

/// Moves the words of the set bits, the left word's bit first, to the left.
constexpr vec_uchar16 kCompress[16] = {
    word_pattern(0, 0, 0, 0), word_pattern(3, 3, 3, 3), word_pattern(2, 2, 2, 2), word_pattern(2, 3, 3, 3),
    word_pattern(1, 1, 1, 1), word_pattern(1, 3, 3, 3), word_pattern(1, 2, 2, 2), word_pattern(1, 2, 3, 3),
    word_pattern(0, 0, 0, 0), word_pattern(0, 3, 3, 3), word_pattern(0, 2, 2, 2), word_pattern(0, 2, 3, 3),
    word_pattern(0, 1, 1, 1), word_pattern(0, 1, 3, 3), word_pattern(0, 1, 2, 2), word_pattern(0, 1, 2, 3)};

/// The first n words of the left vector, then words of the right one.
constexpr vec_uchar16 kJoin[4] = {word_pattern(4, 5, 6, 7), word_pattern(0, 4, 5, 6),
                                  word_pattern(0, 1, 4, 5), word_pattern(0, 1, 2, 4)};

/// What kJoin left of the right vector, to the left.
constexpr vec_uchar16 kRest[4] = {word_pattern(0, 0, 0, 0), word_pattern(3, 3, 3, 3),
                                  word_pattern(2, 3, 3, 3), word_pattern(1, 2, 3, 3)};

/// How many of four bits are set.
inline unsigned int count_bits(unsigned int bits) {
  return (bits >> 3) + ((bits >> 2) & 1U) + ((bits >> 1) & 1U) + (bits & 1U);
}

/// The masks of four words as four bits, the left word's first.
inline unsigned int mask_bits(vec_uint4 mask) {
  return spu_extract(spu_gather(mask), 0);
}

/// Writes chosen words one behind the other, a whole vector at a time: compaction without a branch a word
/// (F2). The output may be the input, for it never gets ahead of it.
class WordWriter {
 public:
  explicit WordWriter(vec_uint4* out) : out_(out), held_(spu_splats(0U)) {}

  /// Appends those words of `four` whose bits are set.
  void append(vec_uint4 four, unsigned int bits) {
    const vec_uint4 chosen = spu_shuffle(four, four, kCompress[bits]);
    const vec_uint4 joined = spu_shuffle(held_, chosen, kJoin[held_count_]);
    const unsigned int together = held_count_ + count_bits(bits);
    if (together < 4) {
      held_ = joined;
      held_count_ = together;
      return;
    }
    *out_++ = joined;
    written_ += 4;
    held_ = spu_shuffle(chosen, chosen, kRest[held_count_]);
    held_count_ = together - 4;
  }

  /// Writes the words that do not fill a vector, filled up with `padding`, and returns how many words there
  /// are.
  unsigned int finish(vec_uint4 padding) {
    if (held_count_ != 0) *out_ = spu_shuffle(held_, padding, kJoin[held_count_]);
    return written_ + held_count_;
  }

 private:
  vec_uint4* out_;
  vec_uint4 held_;
  unsigned int held_count_ = 0;
  unsigned int written_ = 0;
};

}  // namespace cellsweep::cell

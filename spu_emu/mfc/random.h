/// @file
/// A small seeded generator for the order in which late transfers land.
#ifndef SPU_EMU_MFC_RANDOM_H
#define SPU_EMU_MFC_RANDOM_H

#include <cstdint>

namespace spu_emu {

/// SplitMix64 (Steele, Lea, Flood 2014): every seed gives a good sequence, the same on every machine.
class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed) {}

  std::uint64_t next() {
    std::uint64_t z = (state_ += 0x9e3779b97f4a7c15U);
    z = (z ^ (z >> 30U)) * 0xbf58476d1ce4e5b9U;
    z = (z ^ (z >> 27U)) * 0x94d049bb133111ebU;
    return z ^ (z >> 31U);
  }
  /// A number below `bound`, which is not 0 and small, so that the modulo's bias does not matter.
  std::uint64_t below(std::uint64_t bound) { return next() % bound; }

 private:
  std::uint64_t state_;
};

}  // namespace spu_emu

#endif

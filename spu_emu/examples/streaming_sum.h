// What the two sides of the streaming sum share: words only, so that it crosses byte orders.
#ifndef SPU_EMU_EXAMPLES_STREAMING_SUM_H
#define SPU_EMU_EXAMPLES_STREAMING_SUM_H

#include <cstdint>

struct alignas(128) StreamingSum {
  std::uint32_t data_high;
  std::uint32_t data_low;
  std::uint32_t blocks;
  std::uint32_t sum;
};

constexpr std::uint32_t kBlockWords = 1024;

#endif

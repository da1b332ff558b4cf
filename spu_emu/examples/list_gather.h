// What the two sides of the list gather share.
#ifndef SPU_EMU_EXAMPLES_LIST_GATHER_H
#define SPU_EMU_EXAMPLES_LIST_GATHER_H

#include <cstdint>

constexpr std::uint32_t kRecords = 64;
constexpr std::uint32_t kRecordBytes = 32;

struct alignas(128) ListGather {
  std::uint32_t table_high;
  std::uint32_t table_low;
  std::uint32_t result_high;
  std::uint32_t result_low;
  std::uint32_t picks[kRecords];
};

#endif

/// @file
/// Which lines of a local store somebody else has written since its machine looked.
#ifndef SPU_EMU_ISA_CORE_WRITTEN_LINES_H
#define SPU_EMU_ISA_CORE_WRITTEN_LINES_H

#include <array>
#include <atomic>
#include <bit>
#include <cstdint>

namespace spu_emu::isa {

/// Lines of 128 bytes, a bit each. Any thread.
class WrittenLines {
 public:
  static constexpr std::uint32_t kLine = 128;

  /// The lines that [first, first + size) touches; what lies outside the local store is left out.
  void add(std::uint32_t first, std::uint32_t size) {
    const std::uint64_t end = std::uint64_t{first} + size;
    for (std::uint64_t line = first / kLine; line * kLine < end && line < kLines; ++line)
      words_[line / 64].fetch_or(std::uint64_t{1} << (line % 64), std::memory_order_release);
  }

  /// Calls `visit(first byte)` for each line added since the last call.
  template <class Visit>
  void take(Visit&& visit) {
    for (std::uint32_t w = 0; w < words_.size(); ++w) {
      std::uint64_t bits = words_[w].exchange(0, std::memory_order_acquire);
      for (; bits != 0; bits &= bits - 1)
        visit((w * 64 + static_cast<std::uint32_t>(std::countr_zero(bits))) * kLine);
    }
  }

 private:
  static constexpr std::uint32_t kLines = 0x40000 / kLine;
  std::array<std::atomic<std::uint64_t>, kLines / 64> words_{};
};

}  // namespace spu_emu::isa

#endif

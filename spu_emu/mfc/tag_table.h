/// @file
/// Which DMA tags a program has reserved through mfc_tag_reserve.
#ifndef SPU_EMU_MFC_TAG_TABLE_H
#define SPU_EMU_MFC_TAG_TABLE_H

#include <cstdint>

namespace spu_emu {

/// How many tags an SPU's transfers can have.
inline constexpr std::uint32_t kTagCount = 32;

/// Used by the SPU's own thread only.
class TagTable {
 public:
  static constexpr std::uint32_t kInvalid = 0xffffffffU;
  static constexpr std::uint32_t kValid = 0;

  /// First of `count` neighbouring free tags, lowest first, now reserved; kInvalid when there are none.
  std::uint32_t reserve(std::uint32_t count);
  /// kValid when all of them were reserved and are now free; else kInvalid, and nothing changes.
  std::uint32_t release(std::uint32_t tag, std::uint32_t count);
  /// Bit n is set while tag n is reserved.
  std::uint32_t reserved() const { return reserved_; }

 private:
  std::uint32_t reserved_ = 0;
};

}  // namespace spu_emu

#endif

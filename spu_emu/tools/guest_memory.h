/// @file
/// Main memory for a program that runs alone: what its transfers may reach and nobody else uses.
#ifndef SPU_EMU_TOOLS_GUEST_MEMORY_H
#define SPU_EMU_TOOLS_GUEST_MEMORY_H

#include <cstddef>
#include <cstdint>

namespace spu_emu {

/// Zeroes at first. Transfers that begin within and end beyond, on either side, find no memory.
class GuestMemory {
 public:
  static constexpr std::size_t kSize = std::size_t{1} << 20U;

  /// Throws std::bad_alloc.
  GuestMemory();
  ~GuestMemory();
  GuestMemory(const GuestMemory&) = delete;
  GuestMemory& operator=(const GuestMemory&) = delete;

  std::uint32_t* words() const { return words_; }

 private:
  void* mapping_;
  std::uint32_t* words_;
};

}  // namespace spu_emu

#endif

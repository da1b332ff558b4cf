/// @file
/// The heap of an SPU program: blocks of its local store, with the bookkeeping kept outside.
#ifndef SPU_EMU_HOST_HEAP_H
#define SPU_EMU_HOST_HEAP_H

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace spu_emu {

/// Blocks are 16-aligned at least and taken lowest first. Behind each stay bytes that are nobody's, its
/// guard, for as long as there is room without them. Used by one thread at a time.
class Heap {
 public:
  /// LS addresses [first, first + kGuardBytes) behind a block.
  struct Guard {
    std::uint32_t block;  ///< where the block begins
    std::uint32_t asked;  ///< how many bytes of it were asked for
    std::uint32_t first;
  };
  static constexpr std::uint32_t kGuardBytes = 16;

  /// LS addresses [first, last) become one free range; all blocks are forgotten, the high water too.
  void reset(std::uint32_t first, std::uint32_t last);

  /// LS address of `size` bytes (at least 1) at a multiple of `alignment`, a power of two; nothing when full.
  std::optional<std::uint32_t> allocate(std::size_t size, std::size_t alignment);
  /// False when no block begins at `ls`.
  bool release(std::uint32_t ls);
  /// Size of the block that begins at `ls`; 0 for none.
  std::uint32_t size_of(std::uint32_t ls) const;
  /// The guard of the block that begins at `ls`, and all of them.
  std::optional<Guard> guard_of(std::uint32_t ls) const;
  std::vector<Guard> guards() const;

  std::uint32_t in_use() const { return in_use_; }
  std::uint32_t high_water() const { return high_water_; }
  std::uint32_t free_bytes() const { return last_ - first_ - in_use_; }
  std::uint32_t largest_free() const;  ///< once guards have given way
  std::uint32_t first() const { return first_; }
  std::uint32_t last() const { return last_; }
  /// One line for each block.
  std::string describe_blocks() const;

 private:
  struct Block {
    std::uint32_t asked;
    std::uint32_t bytes;
  };

  std::optional<std::uint32_t> place(std::size_t size, std::size_t alignment);

  std::uint32_t first_ = 0;
  std::uint32_t last_ = 0;
  std::uint32_t in_use_ = 0;
  std::uint32_t high_water_ = 0;
  std::uint32_t guard_bytes_ = kGuardBytes;
  std::map<std::uint32_t, Block> blocks_;
};

}  // namespace spu_emu

#endif

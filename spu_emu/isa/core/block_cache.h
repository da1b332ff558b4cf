/// @file
/// The decoded blocks of one local store, by the address they start at.
#ifndef SPU_EMU_ISA_CORE_BLOCK_CACHE_H
#define SPU_EMU_ISA_CORE_BLOCK_CACHE_H

#include <array>
#include <cstdint>
#include <memory>
#include <unordered_map>
#include <vector>

#include "isa/core/state.h"
#include "isa/core/zero_pages.h"

namespace spu_emu::isa {

/// For the SPU's own thread.
class BlockCache {
 public:
  /// Puts its tables into `state`, which outlives it or drops them.
  BlockCache(State& state, const std::byte* local_store);
  BlockCache(const BlockCache&) = delete;
  BlockCache& operator=(const BlockCache&) = delete;

  /// The first Op of the block at `pc`, decoded now if it is not yet. Valid until `drop` and then
  /// `free_dropped`.
  const Op* block(std::uint32_t pc);
  /// The same for a block of at most `instructions`, valid until the next call of `partial_block`.
  const Op* partial_block(std::uint32_t pc, std::uint32_t instructions);

  /// Forgets the blocks that have an instruction in these bytes; they may still be running.
  void drop(std::uint32_t first, std::uint32_t size);
  void drop_all();
  /// To be called when none is running.
  void free_dropped() { dropped_.clear(); }

 private:
  struct Block {
    std::uint32_t words;
    std::vector<Op> ops;
  };

  bool is_observed() const { return state_.observer != nullptr; }
  void forget(std::uint32_t word);
  bool has_code(std::uint32_t first, std::uint32_t end) const;

  const State& state_;
  const std::byte* local_store_;
  ZeroPages<std::array<const Op*, kWords>> entries_;
  std::unordered_map<std::uint32_t, std::unique_ptr<Block>> blocks_;  // by the word they start at
  std::array<std::uint8_t, kQuadwords> code_{};
  std::vector<std::unique_ptr<Block>> dropped_;
  std::vector<Op> partial_;
};

}  // namespace spu_emu::isa

#endif

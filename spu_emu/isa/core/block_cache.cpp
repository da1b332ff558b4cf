#include "isa/core/block_cache.h"

#include <algorithm>

#include "isa/core/decoder.h"

namespace spu_emu::isa {

BlockCache::BlockCache(State& state, const std::byte* local_store)
    : state_(state), local_store_(local_store) {
  state.entries = &*entries_;
  state.code = &code_;
  state.blocks = this;
}

const Op* BlockCache::block(std::uint32_t pc) {
  const std::uint32_t word = pc / 4;
  const Op*& entry = (*entries_)[word];
  if (entry == nullptr) {
    auto block = std::make_unique<Block>();
    block->ops = decode_block(local_store_, pc, kMaxBlock, block->words, is_observed(), state_.traps);
    for (std::uint32_t k = word / 4; k <= (word + block->words - 1) / 4; ++k) code_[k] = 1;
    entry = blocks_.emplace(word, std::move(block)).first->second->ops.data();
  }
  return entry;
}

const Op* BlockCache::partial_block(std::uint32_t pc, std::uint32_t instructions) {
  std::uint32_t words = 0;
  partial_ = decode_block(local_store_, pc, instructions, words, is_observed(), state_.traps);
  // A store into the block itself must end it, as it does in others.
  for (std::uint32_t k = pc / 16; k <= (pc + 4 * (words - 1)) / 16; ++k) code_[k] = 1;
  return partial_.data();
}

bool BlockCache::has_code(std::uint32_t first, std::uint32_t end) const {
  return std::any_of(code_.begin() + first / 16, code_.begin() + (end + 15) / 16,
                     [](std::uint8_t flag) { return flag != 0; });
}

void BlockCache::forget(std::uint32_t word) {
  const auto block = blocks_.find(word);
  dropped_.push_back(std::move(block->second));
  blocks_.erase(block);
  (*entries_)[word] = nullptr;
}

void BlockCache::drop(std::uint32_t first, std::uint32_t size) {
  const std::uint32_t end = std::min(first + size, kLocalStoreSize);
  if (first >= end || !has_code(first, end)) return;
  // Whole quadwords, as the flags are for these.
  const std::uint32_t first_word = first / 16 * 4;
  const std::uint32_t end_word = (end + 15) / 16 * 4;
  for (std::uint32_t word = first_word - std::min(first_word, kMaxBlock - 1); word < end_word; ++word) {
    if ((*entries_)[word] != nullptr && word + blocks_.at(word)->words > first_word) forget(word);
  }
  std::fill(code_.begin() + first_word / 4, code_.begin() + end_word / 4, 0);
}

void BlockCache::drop_all() {
  while (!blocks_.empty()) forget(blocks_.begin()->first);
  code_.fill(0);
}

}  // namespace spu_emu::isa

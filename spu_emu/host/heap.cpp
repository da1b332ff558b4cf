#include "host/heap.h"

#include <algorithm>

#include "mfc/format.h"

namespace spu_emu {

namespace {
constexpr std::uint64_t kGrain = 16;
constexpr std::size_t kMostLines = 40;

std::uint64_t round_up(std::uint64_t value, std::uint64_t multiple) {
  return (value + multiple - 1) / multiple * multiple;
}
}  // namespace

void Heap::reset(std::uint32_t first, std::uint32_t last) {
  first_ = first;
  last_ = last;
  in_use_ = 0;
  high_water_ = 0;
  guard_bytes_ = kGuardBytes;
  blocks_.clear();
}

std::optional<std::uint32_t> Heap::allocate(std::size_t size, std::size_t alignment) {
  if (const auto ls = place(size, alignment)) return ls;
  guard_bytes_ = 0;
  return place(size, alignment);
}

std::optional<std::uint32_t> Heap::place(std::size_t size, std::size_t alignment) {
  if (size > last_ - first_) return std::nullopt;
  const std::uint64_t bytes = round_up(std::max<std::uint64_t>(size, 1), kGrain);
  const std::uint64_t step = std::max<std::uint64_t>(alignment, kGrain);
  std::uint64_t start = round_up(first_, step);
  auto next = blocks_.begin();
  for (; next != blocks_.end() && start + bytes + guard_bytes_ > next->first; ++next) {
    start = round_up(std::uint64_t{next->first} + next->second.bytes + guard_bytes_, step);
  }
  if (start + bytes + guard_bytes_ > last_) return std::nullopt;
  blocks_.emplace_hint(next, static_cast<std::uint32_t>(start),
                       Block{static_cast<std::uint32_t>(size), static_cast<std::uint32_t>(bytes)});
  in_use_ += static_cast<std::uint32_t>(bytes);
  high_water_ = std::max(high_water_, in_use_);
  return static_cast<std::uint32_t>(start);
}

bool Heap::release(std::uint32_t ls) {
  const auto block = blocks_.find(ls);
  if (block == blocks_.end()) return false;
  in_use_ -= block->second.bytes;
  blocks_.erase(block);
  return true;
}

std::uint32_t Heap::size_of(std::uint32_t ls) const {
  const auto block = blocks_.find(ls);
  return block == blocks_.end() ? 0 : block->second.bytes;
}

std::optional<Heap::Guard> Heap::guard_of(std::uint32_t ls) const {
  const auto block = blocks_.find(ls);
  if (block == blocks_.end() || guard_bytes_ == 0) return std::nullopt;
  return Guard{ls, block->second.asked, ls + block->second.bytes};
}

std::vector<Heap::Guard> Heap::guards() const {
  std::vector<Guard> guards;
  for (const auto& [ls, block] : blocks_) {
    if (guard_bytes_ != 0) guards.push_back({ls, block.asked, ls + block.bytes});
  }
  return guards;
}

std::uint32_t Heap::largest_free() const {
  std::uint32_t largest = 0;
  std::uint32_t start = first_;
  for (const auto& [ls, block] : blocks_) {
    largest = std::max(largest, ls - start);
    start = ls + block.bytes;
  }
  return std::max(largest, last_ - start);
}

std::string Heap::describe_blocks() const {
  std::string text;
  std::size_t lines = 0;
  for (const auto& [ls, block] : blocks_) {
    if (++lines > kMostLines)
      return text + format("  ... and %zu more blocks\n", blocks_.size() - kMostLines);
    text += format("  block     0x%05x %9u bytes\n", ls, block.bytes);
  }
  return text;
}

}  // namespace spu_emu

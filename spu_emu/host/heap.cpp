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
  blocks_.clear();
}

std::optional<std::uint32_t> Heap::allocate(std::size_t size, std::size_t alignment) {
  if (size > last_ - first_) return std::nullopt;
  const std::uint64_t bytes = round_up(std::max<std::uint64_t>(size, 1), kGrain);
  const std::uint64_t step = std::max<std::uint64_t>(alignment, kGrain);
  std::uint64_t start = round_up(first_, step);
  auto place = blocks_.begin();
  for (; place != blocks_.end() && start + bytes > place->first; ++place) {
    start = round_up(std::uint64_t{place->first} + place->second, step);
  }
  if (start + bytes > last_) return std::nullopt;
  blocks_.emplace_hint(place, static_cast<std::uint32_t>(start), static_cast<std::uint32_t>(bytes));
  in_use_ += static_cast<std::uint32_t>(bytes);
  high_water_ = std::max(high_water_, in_use_);
  return static_cast<std::uint32_t>(start);
}

bool Heap::release(std::uint32_t ls) {
  const auto block = blocks_.find(ls);
  if (block == blocks_.end()) return false;
  in_use_ -= block->second;
  blocks_.erase(block);
  return true;
}

std::uint32_t Heap::size_of(std::uint32_t ls) const {
  const auto block = blocks_.find(ls);
  return block == blocks_.end() ? 0 : block->second;
}

std::uint32_t Heap::largest_free() const {
  std::uint32_t largest = 0;
  std::uint32_t start = first_;
  for (const auto& [ls, size] : blocks_) {
    largest = std::max(largest, ls - start);
    start = ls + size;
  }
  return std::max(largest, last_ - start);
}

std::string Heap::describe_blocks() const {
  std::string text;
  std::size_t lines = 0;
  for (const auto& [ls, size] : blocks_) {
    if (++lines > kMostLines)
      return text + format("  ... and %zu more blocks\n", blocks_.size() - kMostLines);
    text += format("  block     0x%05x %9u bytes\n", ls, size);
  }
  return text;
}

}  // namespace spu_emu

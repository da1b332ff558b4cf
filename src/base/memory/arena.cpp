#include "base/memory/arena.h"

#include <algorithm>

#include "base/tuning.h"

namespace cellsweep {
namespace {

constexpr std::size_t kFirstChunk = std::size_t{64} << 10;
constexpr std::size_t kLargestStep = std::size_t{8} << 20;

/// How much to take where so much is held, so that little is left over in the end: whole huge pages once they
/// are no more than that.
std::size_t next_step(std::size_t held) {
  const std::size_t least = held < kHugePage ? kFirstChunk : kHugePage;
  return std::clamp(held / tuning::kPartsOfStep, least, kLargestStep);
}

std::size_t round_up(std::size_t bytes, std::size_t unit) {
  return (bytes + unit - 1) / unit * unit;
}

}  // namespace

void* Arena::take_bytes(std::size_t bytes) {
  bytes = round_up(bytes, kMemoryAlignment);
  if (current_ < chunks_.size() && used_ + bytes <= chunks_[current_].size) {
    std::byte* place = chunks_[current_].memory.get() + used_;
    used_ += bytes;
    return place;
  }
  return take_from_next_chunk(bytes);
}

// When memory fails, the current chunk stays the current one.
void* Arena::take_from_next_chunk(std::size_t bytes) {
  const std::size_t next = chunks_.empty() ? 0 : current_ + 1;
  // A chunk that is too small is replaced: nothing behind the current one is handed out.
  if (next < chunks_.size() && chunks_[next].size < bytes) give_behind(next);
  if (next == chunks_.size()) {
    std::size_t size = std::max(bytes + bytes / 8, next_step(bytes_));
    size = round_up(size, size >= kHugePage ? kHugePage : kMemoryAlignment);
    chunks_.push_back({Memory<std::byte>(take_memory(size, kMemoryAlignment)), size});
    bytes_ += size;
  }
  current_ = next;
  used_ = bytes;
  return chunks_[current_].memory.get();
}

void Arena::release(Mark mark) {
  current_ = mark.chunk;
  used_ = mark.used;
}

void Arena::reset(std::size_t most) {
  std::size_t keep = 0;
  std::size_t kept = 0;
  while (keep < chunks_.size() && keep <= current_ && kept + chunks_[keep].size <= most + kFirstChunk) {
    kept += chunks_[keep++].size;
  }
  give_behind(keep);
  current_ = 0;
  used_ = 0;
}

// Of the chunks all but the first ones.
void Arena::give_behind(std::size_t chunks) {
  for (; chunks_.size() > chunks; chunks_.pop_back()) bytes_ -= chunks_.back().size;
}

void Arena::fit() {
  const bool is_empty = current_ == 0 && used_ == 0;
  give_behind(is_empty ? 0 : current_ + 1);
  if (chunks_.empty()) return;
  Chunk& last = chunks_.back();
  const std::size_t fits = shrink_memory(last.memory.get(), last.size, used_);
  bytes_ -= last.size - fits;
  last.size = fits;
}

}  // namespace cellsweep

#include "engines/stream/cells/keys.h"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "base/memory/memory.h"

namespace cellsweep::stream {

Keys::Keys() {
  grow = make_more_room;
}

Keys& Keys::operator=(Keys&& other) noexcept {
  std::swap(buffer(), other.buffer());
  std::swap(filters_, other.filters_);
  std::swap(allowed_, other.allowed_);
  return *this;
}

// Where filters leave much room, there is no need for more.
void Keys::make_more_room(KeyBuffer& buffer, std::size_t more) {
  static_cast<Keys&>(buffer).leave_out();
  if (buffer.size > buffer.most) throw TooManyPairs();
  if (buffer.capacity - buffer.size >= std::max(more, buffer.capacity / 4)) return;
  const std::size_t capacity = std::max(2 * buffer.capacity, buffer.size + more + 1000);
  constexpr std::size_t kBytes = sizeof(std::uint64_t);
  auto* memory = reinterpret_cast<std::byte*>(buffer.keys);
  memory = grow_memory(memory, buffer.capacity * kBytes, capacity * kBytes);
  buffer.keys = reinterpret_cast<std::uint64_t*>(memory);
  buffer.capacity = capacity;
}

void Keys::leave_out() {
  if (filters_.empty()) return;
  std::uint64_t* to = keys + allowed_;
  for (std::size_t i = allowed_; i < size; ++i) {
    const std::uint64_t key = keys[i];
    *to = key;
    const BodyFilter one = filter_of(filters_, static_cast<Slot>(key >> 32));
    to += may_pair(one, filter_of(filters_, static_cast<Slot>(key))) ? 1 : 0;
  }
  size = allowed_ = static_cast<std::size_t>(to - keys);
}

void Keys::leave_out(const std::uint8_t* marked) {
  std::uint64_t* to = keys;
  for (const std::uint64_t key : view()) {
    *to = key;
    const int mark = marked[static_cast<Slot>(key >> 32)] | marked[static_cast<Slot>(key)];
    to += mark == 0 ? 1 : 0;
  }
  shrink(static_cast<std::size_t>(to - keys));
}

void Keys::append(std::span<const std::uint64_t> more) {
  make_room(*this, more.size());
  std::copy(more.begin(), more.end(), keys + size);
  size += more.size();
  allowed_ = size;
}

void Keys::shrink(std::size_t count) {
  size = count;
  allowed_ = std::min(allowed_, count);
}

void Keys::clear() {
  constexpr std::size_t kKept = 4096;
  if (capacity > kKept && size < capacity / 8) return give_back();
  shrink(0);
}

void Keys::give_back() {
  if (keys != nullptr) give_grown(reinterpret_cast<std::byte*>(keys), bytes());
  keys = nullptr;
  capacity = 0;
  shrink(0);
}

Keys::~Keys() {
  give_back();
}

}  // namespace cellsweep::stream

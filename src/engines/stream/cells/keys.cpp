#include "engines/stream/cells/keys.h"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "base/memory/memory.h"

namespace cellsweep::stream {
namespace {

void grow_keys(KeyBuffer& buffer, std::size_t more) {
  if (buffer.size > buffer.most) throw TooManyPairs();
  const std::size_t capacity = std::max(2 * buffer.capacity, buffer.size + more + 1000);
  auto* memory = reinterpret_cast<std::byte*>(buffer.keys);
  buffer.keys = reinterpret_cast<std::uint64_t*>(grow_memory(memory, capacity * sizeof(std::uint64_t)));
  buffer.capacity = capacity;
}

}  // namespace

Keys::Keys() {
  buffer_.grow = grow_keys;
}

Keys& Keys::operator=(Keys&& other) noexcept {
  std::swap(buffer_, other.buffer_);
  return *this;
}

void Keys::clear() {
  constexpr std::size_t kKept = 4096;
  if (buffer_.capacity > kKept && buffer_.size < buffer_.capacity / 8) {
    give_memory(buffer_.keys);
    buffer_.keys = nullptr;
    buffer_.capacity = 0;
  }
  buffer_.size = 0;
}

Keys::~Keys() {
  give_memory(buffer_.keys);
}

}  // namespace cellsweep::stream

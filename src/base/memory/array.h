/// @file
/// Elements of a trivial type whose growth initialises nothing.
#pragma once

#include <algorithm>
#include <cstddef>
#include <span>
#include <utility>

#include "base/memory/memory.h"

namespace cellsweep {

template <class T>
class Array {
 public:
  /// Makes it `size` elements long; what was in it is lost. Gives memory back when much less is needed.
  void renew(std::size_t size) {
    if (size > capacity_ || size + kKept < capacity_ / 8) take_room_for(size);
    size_ = size;
  }
  /// Gives memory back where less than half of it is needed, and keeps the elements.
  void fit() {
    if (capacity_ <= 2 * size_ + kKept) return;
    Array fitting;
    fitting.renew(size_);
    std::copy_n(data(), size_, fitting.data());
    *this = std::move(fitting);
  }
  /// Keeps the first `size` elements.
  void shrink(std::size_t size) { size_ = size; }

  T* data() { return memory_.get(); }
  const T* data() const { return memory_.get(); }
  std::size_t size() const { return size_; }
  std::size_t bytes() const { return capacity_ * sizeof(T); }
  std::span<T> view() { return {memory_.get(), size_}; }
  std::span<const T> view() const { return {memory_.get(), size_}; }

 private:
  static constexpr std::size_t kKept = 4096;

  void take_room_for(std::size_t size) {
    memory_.reset();
    size_ = capacity_ = 0;
    const std::size_t wanted = size + size / 8;
    memory_.reset(reinterpret_cast<T*>(take_memory(wanted * sizeof(T), alignof(T))));
    capacity_ = wanted;
  }

  Memory<T> memory_;
  std::size_t size_ = 0;
  std::size_t capacity_ = 0;
};

/// make_room() of a container that has too little: once for each kind of container.
template <class Container>
[[gnu::noinline]] void grow_room(Container& container, std::size_t size) {
  const std::size_t more = container.capacity() + container.capacity() / 2;
  container.reserve(size > more ? size : more);
}

/// Makes room for so many elements in all; a container that grows a little at a time seldom moves.
template <class Container>
void make_room(Container& container, std::size_t size) {
  if (size > container.capacity()) grow_room(container, size);
}

}  // namespace cellsweep

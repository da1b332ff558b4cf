/// @file
/// A growing list of a trivial type whose elements nobody initialises before they are written.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <span>
#include <type_traits>
#include <utility>

#include "base/memory/memory.h"

namespace cellsweep {

/// Throws std::bad_alloc where it grows, and is then as it was.
template <class T>
class List {
  static_assert(std::is_trivially_copyable_v<T>);

 public:
  List() = default;
  List(List&& other) noexcept { swap(other); }
  List& operator=(List&& other) noexcept {
    List(std::move(other)).swap(*this);
    return *this;
  }
  ~List() {
    if (memory_ != nullptr) give_grown(reinterpret_cast<std::byte*>(memory_), bytes());
  }

  /// Room for so many elements in all; a list that grows a little at a time seldom moves.
  void reserve(std::size_t size) {
    if (size > capacity_) grow(size);
  }
  /// Within what was reserved; elements that are new hold anything.
  void set_size(std::size_t size) { size_ = size; }
  /// Elements that are new have this value.
  void resize(std::size_t size, const T& value) {
    if (size > size_) fill_up(size, value);
    size_ = size;
  }
  /// One more, for which there is room.
  void push(const T& element) { memory_[size_++] = element; }
  void clear() { size_ = 0; }

  /// More behind those that there are.
  void append(std::span<const T> elements) {
    reserve(size_ + elements.size());
    std::copy_n(elements.data(), elements.size(), data() + size_);
    size_ += elements.size();
  }
  void pop() { --size_; }
  template <class Is>
  void erase_if(const Is& is) {
    size_ = static_cast<std::size_t>(std::remove_if(begin(), end(), is) - begin());
  }

  T* data() { return memory_; }
  const T* data() const { return memory_; }
  T* begin() { return data(); }
  T* end() { return data() + size_; }
  const T* begin() const { return data(); }
  const T* end() const { return data() + size_; }
  T& operator[](std::size_t place) { return memory_[place]; }
  const T& operator[](std::size_t place) const { return memory_[place]; }
  std::size_t size() const { return size_; }
  std::size_t capacity() const { return capacity_; }
  bool empty() const { return size_ == 0; }
  std::size_t bytes() const { return capacity_ * kBytes; }
  std::span<T> view() { return {memory_, size_}; }
  std::span<const T> view() const { return {memory_, size_}; }

 private:
  static constexpr std::size_t kBytes = sizeof(T);  // NOLINT(bugprone-sizeof-expression): of a pointer, too

  // Once, not wherever a list may grow.
  [[gnu::noinline]] void grow(std::size_t size) {
    const std::size_t more = capacity_ + capacity_ / 2;
    const std::size_t wanted = size > more ? size : more;
    memory_ =
        reinterpret_cast<T*>(grow_memory(reinterpret_cast<std::byte*>(memory_), bytes(), wanted * kBytes));
    capacity_ = wanted;
  }

  // Cold to be small, as a program has one for each kind of list. Bytes all at once: a loop would read the
  // list's own members again after each of them, as a byte may be a part of anything.
  [[gnu::cold]] void fill_up(std::size_t size, T value) {
    reserve(size);
    if constexpr (kBytes == 1) {
      std::memset(memory_ + size_, static_cast<unsigned char>(value), size - size_);
    } else {
      std::fill_n(memory_ + size_, size - size_, value);
    }
  }

  void swap(List& other) {
    std::swap(memory_, other.memory_);
    std::swap(size_, other.size_);
    std::swap(capacity_, other.capacity_);
  }

  T* memory_ = nullptr;
  std::size_t size_ = 0;
  std::size_t capacity_ = 0;
};

}  // namespace cellsweep

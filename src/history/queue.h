/// @file
/// A list of a trivial type that grows at its end and loses its beginning.
#pragma once

#include <algorithm>
#include <cstddef>
#include <span>

#include "base/memory/list.h"

namespace cellsweep {

/// Memory is at most for twice the elements that there were at one time, and half as many again.
template <class T>
class Queue {
 public:
  /// Room for so many more, after which push() cannot fail. Throws std::bad_alloc, and is then as it was.
  void make_room(std::size_t more) {
    if (first_ >= size()) forget_gone();
    list_.reserve(list_.size() + more);
  }
  void push(const T& element) { list_.push(element); }

  /// Forgets the first `count` elements.
  void pop(std::size_t count) { first_ += count; }

  std::size_t size() const { return list_.size() - first_; }
  std::span<const T> view() const { return list_.view().subspan(first_); }

 private:
  // Moves what is left to the front: seldom, and no more than has gone.
  void forget_gone() {
    const std::span<const T> left = view();
    std::copy(left.begin(), left.end(), list_.data());
    list_.set_size(left.size());
    first_ = 0;
  }

  List<T> list_;
  std::size_t first_ = 0;
};

}  // namespace cellsweep

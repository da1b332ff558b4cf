/// @file
/// A C caller's arrays as the library's spans, copied only where they lie apart.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <string>
#include <vector>

#include "base/memory/array.h"
#include "bindings/boxes_of_world.h"
#include "cellsweep/box_view.h"
#include "cellsweep/broadphase.h"
#include "cellsweep/c/boxes.h"
#include "cellsweep/c/broadphase.h"
#include "cellsweep/filter.h"
#include "cellsweep/pair.h"
#include "cellsweep/status.h"

namespace cellsweep::c {

/// An array of one language's structs as that of the other's, which are the same to the byte. The compiler is
/// told that it does not know where the address comes from, as it does not in a call from another library.
template <class To, class From>
To* seen_as(From* array) {
  static_assert(sizeof(To) == sizeof(From));    // NOLINT(misc-redundant-expression): not for all types
  static_assert(alignof(To) == alignof(From));  // NOLINT(misc-redundant-expression)
  void* address = const_cast<void*>(static_cast<const void*>(array));
  asm volatile("" : "+r"(address) : : "memory");
  return static_cast<To*>(address);
}

template <class To, class From>
std::span<To> seen_as(From* array, std::size_t count) {
  return {seen_as<To>(array), count};
}

/// Elements of the caller's; `stride` bytes from one to the next.
template <class Element>
class Strided {
 public:
  /// Errors: bad_input for elements without an address, which are called by `name`.
  template <class From>
  Status read(const From* first, std::ptrdiff_t stride, std::size_t count, const char* name);

  std::span<const Element> view() const { return view_; }

 private:
  Array<Element> own_;
  std::span<const Element> view_;
};

template <class Element>
template <class From>
Status Strided<Element>::read(const From* first, std::ptrdiff_t stride, std::size_t count, const char* name) {
  static_assert(sizeof(Element) == sizeof(From));
  if (count == 0) return {};
  if (first == nullptr) return Status::bad_input(std::string("NULL was given for `") + name + "`.");
  const bool is_aligned = reinterpret_cast<std::uintptr_t>(first) % alignof(Element) == 0;
  if (stride == sizeof(Element) && is_aligned) {
    view_ = seen_as<const Element>(first, count);
    return {};
  }
  own_.renew(count);
  const auto* byte = reinterpret_cast<const std::byte*>(first);
  for (std::size_t i = 0; i < count; ++i) {
    std::memcpy(own_.data() + i, byte + static_cast<std::ptrdiff_t>(i) * stride, sizeof(Element));
  }
  view_ = own_.view();
  return {};
}

/// Boxes as one-shot calls take them. Errors: bad_input for dimensions or numbers that are none.
Result<BoxView> view_of(const cellsweep_boxes& boxes);

/// What a call that changes a world is given.
struct Bodies {
  Strided<BodyId> ids;
  Strided<BodyFilter> filters;
  std::vector<Aabb> own_boxes;
  std::span<const Aabb> boxes;

  Status read(const cellsweep_ids& from);
  Status read(const cellsweep_filters& from);
  Status read(const cellsweep_boxes& from);
};

/// The library's changes for a C caller; the lists stay where they are.
inline cellsweep_changes changes_of(const PairChanges& changes) {
  return {seen_as<const cellsweep_pair>(changes.began.data()), changes.began.size(),
          seen_as<const cellsweep_pair>(changes.ended.data()), changes.ended.size()};
}

}  // namespace cellsweep::c

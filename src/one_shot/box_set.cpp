#include "one_shot/box_set.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include "base/text.h"
#include "cellsweep/engine/slots.h"
#include "geometry/box_lanes.h"
#include "geometry/canonical.h"

namespace cellsweep::one_shot {
namespace {

/// Coordinates of a view. In two dimensions the third one is 0 for all.
template <class Number>
class Reader {
 public:
  explicit Reader(const BoxView& view) {
    for (std::size_t face = 0; face < 6; ++face) {
      const bool is_there = face % 3 < view.axes();
      faces_[face] =
          is_there ? view.face(face) : BoxView::Face{reinterpret_cast<const std::byte*>(&kZero), 0};
    }
  }

  Number at(std::size_t face, std::size_t index) const {
    Number number;
    std::memcpy(&number, faces_[face].first + static_cast<std::ptrdiff_t>(index) * faces_[face].stride,
                sizeof number);
    return number;
  }

  /// A box of numbers as they are compared.
  Box<Number, 3> operator[](std::size_t index) const {
    Box<Number, 3> box;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      box.min[axis] = compared(at(axis, index));
      box.max[axis] = compared(at(axis + 3, index));
    }
    return box;
  }

 private:
  static constexpr Number kZero = 0;

  static float compared(float number) { return canonical(number); }
  static double compared(double number) { return number; }

  std::array<BoxView::Face, 6> faces_;
};

template <class Number>
bool is_valid_box(const Box<Number, 3>& box) {
  constexpr Number kMost = std::numeric_limits<Number>::max();
  bool valid = true;
  // A NaN fails every comparison.
  for (std::size_t axis = 0; axis < 3; ++axis) {
    valid &= box.min[axis] >= -kMost;
    valid &= box.min[axis] <= box.max[axis];
    valid &= box.max[axis] <= kMost;
  }
  return valid;
}

/// With as many digits as it takes to name it.
template <class Number>
std::string digits_of(Number number) {
  std::array<char, 400> digits;  // NOLINT(*-member-init): as far as it is written
  return {digits.data(), std::to_chars(digits.data(), digits.data() + digits.size(), number).ptr};
}

template <class Number>
[[gnu::cold]] std::string describe_fault_of(const Reader<Number>& reader, std::size_t index) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const Number low = reader.at(axis, index);
    const Number high = reader.at(axis + 3, index);
    const char name = "xyz"[axis];
    if (!std::isfinite(low) || !std::isfinite(high)) {
      return text("its ", name, " interval [", digits_of(low), ", ", digits_of(high), "] is not finite");
    }
    if (low > high) {
      return text("its minimum on ", name, ", ", digits_of(low), ", is above its maximum, ", digits_of(high));
    }
  }
  return {};
}

/// Which set is meant, in a sentence.
std::string_view name_of_set(Sets sets, std::size_t set) {
  if (sets.size() == 1) return "";
  return set == 0 ? " of the first set" : " of the second set";
}

/// All that are invalid, by their places in their set.
template <class Number>
[[gnu::cold]] Status refuse_invalid(Sets sets, std::size_t set) {
  const Reader<Number> reader(sets[set]);
  std::vector<BodyId> bad;
  std::string faults;
  for (std::size_t i = 0; i < sets[set].size(); ++i) {
    if (is_valid_box(reader[i])) continue;
    bad.push_back(static_cast<BodyId>(i));
    if (bad.size() > Status::kMostBodies) continue;
    if (bad.size() > 1) faults += text("; box ", i, ": ");
    faults += describe_fault_of(reader, i);
  }
  if (bad.size() > Status::kMostBodies) faults += text("; and ", bad.size() - Status::kMostBodies, " more");
  return Status::bad_bodies(StatusCode::invalid_box,
                            text("Box ", bad.front(), name_of_set(sets, set), " is refused: ", faults, "."),
                            bad);
}

/// The view's boxes, if they are an array of Aabb; else null.
const Aabb* as_array(const BoxView& view) {
  const std::byte* const first = view.face(0).first;
  if (view.is_double() || view.axes() != 3 || reinterpret_cast<std::uintptr_t>(first) % alignof(Aabb) != 0)
    return nullptr;
  for (std::size_t face = 0; face < 6; ++face) {
    if (view.face(face).stride != sizeof(Aabb)) return nullptr;
    if (reinterpret_cast<std::uintptr_t>(view.face(face).first) !=
        reinterpret_cast<std::uintptr_t>(first) + face * sizeof(float)) {
      return nullptr;
    }
  }
  return reinterpret_cast<const Aabb*>(first);
}

bool are_all_clean(std::span<const Aabb> boxes) {
  Int4 clean = {-1, -1, -1, -1};
  for (const Aabb& box : boxes) clean &= clean_lanes(BoxLanes(box));
  return on_all_axes(clean);
}

std::size_t count_boxes(Sets sets) {
  std::size_t count = 0;
  for (const BoxView& set : sets) count += set.size();
  return count;
}

/// False when one is invalid. `AnyBox` is Aabb or ExactBox.
template <class Number, class AnyBox>
bool read_boxes(const BoxView& view, AnyBox* to) {
  const Reader<Number> reader(view);
  bool valid = true;
  for (std::size_t i = 0; i < view.size(); ++i) {
    const Box<Number, 3> box = reader[i];
    valid &= is_valid_box(box);
    to[i] = {box.min, box.max};
  }
  return valid;
}

bool read_array(std::span<const Aabb> boxes, Aabb* to) {
  std::copy(boxes.begin(), boxes.end(), to);
  return are_all_clean(boxes);
}

template <class Number, class AnyBox>
Status read_sets(Sets sets, AnyBox* to) {
  for (std::size_t set = 0; set < sets.size(); ++set) {
    const std::size_t count = sets[set].size();
    if constexpr (std::is_same_v<AnyBox, Aabb>) {
      const Aabb* const array = as_array(sets[set]);
      if (array != nullptr && read_array({array, count}, to)) {
        to += count;
        continue;
      }
    }
    if (!read_boxes<Number>(sets[set], to)) return refuse_invalid<Number>(sets, set);
    to += count;
  }
  return {};
}

}  // namespace

Status check_sets(Sets sets) {
  for (std::size_t set = 0; set < sets.size(); ++set) {
    for (std::size_t face = 0; face < 6; ++face) {
      if (face % 3 >= sets[set].axes() || sets[set].size() == 0 || sets[set].face(face).first != nullptr)
        continue;
      return Status::bad_input(text("The ", face < 3 ? "minima" : "maxima", " on ", "xyz"[face % 3],
                                    " of the ", sets[set].size(), " boxes", name_of_set(sets, set),
                                    " have no address: the pointer to them is null."));
    }
  }
  if (sets.size() == 2 && (sets[0].is_double() != sets[1].is_double() || sets[0].axes() != sets[1].axes())) {
    return Status::bad_input(text("The first set has ", sets[0].axes(), " axes of ",
                                  sets[0].is_double() ? "doubles" : "floats", ", the second one ",
                                  sets[1].axes(), " of ", sets[1].is_double() ? "doubles" : "floats",
                                  "; give both the same."));
  }
  const std::size_t count = count_boxes(sets);
  // Either alone may overflow the sum.
  const bool overflows = count < sets[0].size();
  if (count <= kSlotMask && !overflows) return {};
  return Status::over_capacity(
      text("There are ", count, " boxes; one search takes ", kSlotMask, ", both sets together."), count,
      kSlotMask);
}

Status read_floats(Sets sets, SearchedBoxes& boxes) {
  boxes.are_two = sets.size() == 2;
  boxes.second = boxes.second_place = static_cast<std::uint32_t>(sets[0].size());
  if (const Aabb* const array = as_array(sets[0]); array != nullptr && sets.size() == 1) {
    boxes.boxes = {array, sets[0].size()};
    if (are_all_clean(boxes.boxes)) return {};
  }
  boxes.own.renew(count_boxes(sets));
  boxes.boxes = boxes.own.view();
  return read_sets<float>(sets, boxes.own.data());
}

Status read_doubles(Sets sets, Array<ExactBox>& boxes) {
  boxes.renew(count_boxes(sets));
  return read_sets<double>(sets, boxes.data());
}

}  // namespace cellsweep::one_shot

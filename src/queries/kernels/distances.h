/// @file
/// Distances of boxes from one, to the last bit those that arithmetic.h computes: doubles are subtracted,
/// multiplied, added and rooted in the same order, four boxes at a time.
#pragma once

#include "queries/kernels/kernel.h"

namespace cellsweep::queries {
namespace {

using FourFloats [[gnu::vector_size(16)]] = float;

/// The faces of four boxes.
struct FourBoxes {
  FourFloats min[3];
  FourFloats max[3];

  FourBoxes(const Aabb* boxes, const std::uint32_t (&slots)[4]) {
    const auto load = [&](unsigned box, unsigned face) {
      FourFloats faces;
      __builtin_memcpy(&faces, reinterpret_cast<const float*>(boxes + slots[box]) + face, sizeof(faces));
      return faces;
    };
    const auto low = [&](unsigned box) { return load(box, 0); };   // minima and the first maximum
    const auto high = [&](unsigned box) { return load(box, 2); };  // the last minimum and maxima
    const FourFloats xy_01 = unpack_low(low(0), low(1)), xy_23 = unpack_low(low(2), low(3));
    const FourFloats zx_01 = unpack_high(low(0), low(1)), zx_23 = unpack_high(low(2), low(3));
    const FourFloats yz_01 = unpack_high(high(0), high(1)), yz_23 = unpack_high(high(2), high(3));
    min[0] = halves_low(xy_01, xy_23);
    min[1] = halves_high(xy_01, xy_23);
    min[2] = halves_low(zx_01, zx_23);
    max[0] = halves_high(zx_01, zx_23);
    max[1] = halves_low(yz_01, yz_23);
    max[2] = halves_high(yz_01, yz_23);
  }

 private:
  static FourFloats unpack_low(FourFloats a, FourFloats b) {
    return __builtin_shufflevector(a, b, 0, 4, 1, 5);
  }
  static FourFloats unpack_high(FourFloats a, FourFloats b) {
    return __builtin_shufflevector(a, b, 2, 6, 3, 7);
  }
  static FourFloats halves_low(FourFloats a, FourFloats b) {
    return __builtin_shufflevector(a, b, 0, 1, 4, 5);
  }
  static FourFloats halves_high(FourFloats a, FourFloats b) {
    return __builtin_shufflevector(a, b, 2, 3, 6, 7);
  }
};

/// The squares of the distances of as many of four boxes as there are lanes, from `half` on. `faces_of(face)`
/// are theirs, side by side.
template <class Lanes, class FacesOf>
typename Lanes::Doubles squares(const FacesOf& faces_of, const float* from, unsigned half) {
  using Doubles = typename Lanes::Doubles;
  Doubles sum{};
  for (unsigned axis = 0; axis < 3; ++axis) {
    const Doubles above = double{from[axis]} - Lanes::doubles(faces_of(axis + 3), half);
    const Doubles below = Lanes::doubles(faces_of(axis), half) - double{from[axis + 3]};
    const Doubles farther = above > below ? above : below;
    const Doubles gap = farther > Doubles{} ? farther : Doubles{};
    sum = axis == 0 ? gap * gap : sum + gap * gap;
  }
  return sum;
}

template <class Lanes, class FacesOf>
void measure_four(const FacesOf& faces_of, const Aabb& from, double* distances) {
  constexpr unsigned kLanes = sizeof(typename Lanes::Doubles) / sizeof(double);
  for (unsigned half = 0; half < kDistancesAtOnce; half += kLanes) {
    const auto roots = Lanes::roots(squares<Lanes>(faces_of, reinterpret_cast<const float*>(&from), half));
    __builtin_memcpy(distances + half, &roots, sizeof(roots));
  }
}

template <class Lanes>
void distances(const Aabb* boxes, const std::uint32_t* slots, std::uint32_t count, const Aabb& from,
               double* distances) {
  for (std::uint32_t first = 0; first < count; first += kDistancesAtOnce) {
    const auto slot = [=](std::uint32_t i) { return slots[first + i < count ? first + i : first]; };
    const FourBoxes four(boxes, {slot(0), slot(1), slot(2), slot(3)});
    measure_four<Lanes>([&](unsigned face) { return face < 3 ? four.min[face] : four.max[face - 3]; }, from,
                        distances + first);
  }
}

template <class Lanes>
void node_distances(const TreeNode& node, const Aabb& from, double* distances) {
  for (unsigned first = 0; first < TreeNode::kBoxes; first += kDistancesAtOnce) {
    const auto faces_of = [&](unsigned face) {
      FourFloats faces;
      __builtin_memcpy(&faces, node.faces[face] + first, sizeof(faces));
      return faces;
    };
    measure_four<Lanes>(faces_of, from, distances + first);
  }
}

}  // namespace
}  // namespace cellsweep::queries

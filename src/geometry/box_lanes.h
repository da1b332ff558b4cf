/// @file
/// A box as two vectors of four, for what is asked of every box: three axes at a time, without branches.
#pragma once

#include <cfloat>
#include <cstddef>
#include <cstdint>
#include <cstring>

#ifdef __SSE2__
#include <emmintrin.h>
#endif

#include "cellsweep/aabb.h"

namespace cellsweep {

using Float4 [[gnu::vector_size(16)]] = float;
using Int4 [[gnu::vector_size(16)]] = std::int32_t;

/// Four floats of a box, from `skip` on.
inline Float4 load4(const Aabb& box, std::size_t skip) {
  Float4 vector;
  std::memcpy(&vector, reinterpret_cast<const char*>(&box) + skip * sizeof(float), sizeof vector);
  return vector;
}

template <class Vector, class Number>
void store4(Vector vector, Number (&to)[4]) {
  static_assert(sizeof to == sizeof vector);
  std::memcpy(to, &vector, sizeof vector);
}

/// The second number where they are equal or one is NaN. Not a choice between numbers, which compilers make
/// of four instructions where there is one.
inline Float4 smaller(Float4 one, Float4 other) {
#ifdef __SSE2__
  return reinterpret_cast<Float4>(_mm_min_ps(reinterpret_cast<__m128>(one), reinterpret_cast<__m128>(other)));
#else
  return one < other ? one : other;
#endif
}
inline Float4 larger(Float4 one, Float4 other) {
#ifdef __SSE2__
  return reinterpret_cast<Float4>(_mm_max_ps(reinterpret_cast<__m128>(one), reinterpret_cast<__m128>(other)));
#else
  return one > other ? one : other;
#endif
}

inline Float4 magnitude(Float4 values) {
  return reinterpret_cast<Float4>(reinterpret_cast<Int4>(values) & 0x7fffffff);
}

/// canonical() of each lane.
inline Float4 canonical(Float4 values) {
  const Int4 is_normal = magnitude(values) >= FLT_MIN;
  return reinterpret_cast<Float4>(reinterpret_cast<Int4>(values) & is_normal);
}

/// Into which of the cells 0 to `top` each coordinate falls, `scale` of them for each unit of length from
/// `origin` on: never a lower one for a higher coordinate, whatever rounding does. NaN becomes 0.
inline Int4 cells_of(Float4 coordinates, Float4 origin, Float4 scale, Float4 top) {
  const Float4 zero{};
  Float4 cells = (coordinates - origin) * scale;
  cells = cells > zero ? cells : zero;
  cells = cells < top ? cells : top;
  return __builtin_convertvector(cells, Int4);
}

/// The numbers of a box as they lie in memory: the first four and the last four.
struct BoxNumbers {
  Float4 first_four;
  Float4 last_four;

  explicit BoxNumbers(const Aabb& box) : first_four(load4(box, 0)), last_four(load4(box, 2)) {}

  /// The same of a box that the caller has only just written, perhaps number by number. A load that lies in
  /// one store gets its number from there; one that spans several waits until all of them are in the cache,
  /// and with it everything that depends on it: 12 ns of the 70 that it took whether anything is between two
  /// points (Xeon, scene `clustered`).
  static BoxNumbers just_written(const Aabb& box) { return BoxNumbers(box.min.data(), box.max.data()); }

 private:
#ifdef __SSE2__
  BoxNumbers(const float* min, const float* max) {
    const auto two = [](const float& low, const float& high) {
      return _mm_unpacklo_ps(_mm_load_ss(&low), _mm_load_ss(&high));
    };
    const __m128 middle = two(min[2], max[0]);
    first_four = reinterpret_cast<Float4>(_mm_movelh_ps(two(min[0], min[1]), middle));
    last_four = reinterpret_cast<Float4>(_mm_movelh_ps(middle, two(max[1], max[2])));
  }
#else
  BoxNumbers(const float* min, const float* max)
      : first_four{min[0], min[1], min[2], max[0]}, last_four{min[2], max[0], max[1], max[2]} {}
#endif
};

/// Lanes 0 to 2 are the axes; what lane 3 holds must not matter.
struct BoxLanes {
  Float4 min;
  Float4 max;

  explicit BoxLanes(const Aabb& box) : BoxLanes(BoxNumbers(box)) {}
  explicit BoxLanes(const BoxNumbers& box)
      : min(box.first_four), max(__builtin_shufflevector(box.last_four, box.last_four, 1, 2, 3, 0)) {}
};

/// The box of such lanes. A copy of it, which is 16 bytes and then 8, is made of these stores; of one for
/// each end it would wait until both are in the cache. EPYC, all fat boxes made anew: 0.84 of the time.
inline Aabb box_of(Float4 min, Float4 max) {
  const Float4 first_four = __builtin_shufflevector(min, max, 0, 1, 2, 4);
  const Float4 last_two = __builtin_shufflevector(max, max, 1, 2, 1, 2);
  Aabb box;
  auto* const numbers = reinterpret_cast<float*>(&box);
  std::memcpy(numbers, &first_four, 4 * sizeof(float));
  std::memcpy(numbers + 4, &last_two, 2 * sizeof(float));
  return box;
}

/// True when a comparison holds on all three axes.
inline bool on_all_axes(Int4 mask) {
#ifdef __SSE2__
  return (_mm_movemask_ps(reinterpret_cast<__m128>(mask)) & 7) == 7;
#else
  return (mask[0] & mask[1] & mask[2]) != 0;
#endif
}

/// True when a comparison holds on one of them.
inline bool on_any_axis(Int4 mask) {
#ifdef __SSE2__
  return (_mm_movemask_ps(reinterpret_cast<__m128>(mask)) & 7) != 0;
#else
  return (mask[0] | mask[1] | mask[2]) != 0;
#endif
}

inline bool overlap(const BoxLanes& one, const BoxLanes& other) {
  return on_all_axes((one.min <= other.max) & (other.min <= one.max));
}

inline bool encloses(const BoxLanes& fat, const BoxLanes& box) {
  return on_all_axes((fat.min <= box.min) & (box.max <= fat.max));
}

inline bool same_bits(const BoxLanes& one, const BoxLanes& other) {
  return on_all_axes((reinterpret_cast<Int4>(one.min) == reinterpret_cast<Int4>(other.min)) &
                     (reinterpret_cast<Int4>(one.max) == reinterpret_cast<Int4>(other.max)));
}

/// Lanes on which a box is what is_valid() says.
inline Int4 valid_lanes(const BoxLanes& box) {
  return (box.min >= -FLT_MAX) & (box.min <= box.max) & (box.max <= FLT_MAX);
}

/// Lanes that canonical() leaves as they are, and that are finite.
inline Int4 clean_lanes(Float4 values) {
  // Twice the bits, which is without the sign, from twice the least normal number up to twice infinity; the
  // shift puts that range at the lower end of the signed numbers.
  constexpr std::uint32_t kLeast = 0x01000000;
  constexpr std::uint32_t kSpan = 0xff000000 - kLeast;
  constexpr std::uint32_t kShift = 0x80000000;
  using Unsigned4 [[gnu::vector_size(16)]] = std::uint32_t;
  const auto bits = reinterpret_cast<Unsigned4>(values);
  const auto shifted = reinterpret_cast<Int4>(bits + bits + (kShift - kLeast));
  return (shifted < static_cast<std::int32_t>(kSpan - kShift)) | reinterpret_cast<Int4>(bits == 0);
}

/// Lanes whose values are clean_lanes(), the minimum not above the maximum.
inline Int4 clean_lanes(const BoxLanes& box) {
  return clean_lanes(box.min) & clean_lanes(box.max) & (box.min <= box.max);
}

}  // namespace cellsweep

/// @file
/// A vector of endpoint values with the IDs that belong to them, position by position (C2).
#pragma once

#include <vmx2spu.h>

#include <cstdint>

namespace cellsweep::cell::paper {

struct Tracked {
  vec_float4 values;
  vec_uint4 ids;
};

inline Tracked load(const float* values, const std::uint32_t* ids, std::uint32_t vector_index) {
  return {reinterpret_cast<const vec_float4*>(values)[vector_index],
          reinterpret_cast<const vec_uint4*>(ids)[vector_index]};
}

inline void store(const Tracked& tracked, float* values, std::uint32_t* ids, std::uint32_t vector_index) {
  reinterpret_cast<vec_float4*>(values)[vector_index] = tracked.values;
  reinterpret_cast<vec_uint4*>(ids)[vector_index] = tracked.ids;
}

}  // namespace cellsweep::cell::paper

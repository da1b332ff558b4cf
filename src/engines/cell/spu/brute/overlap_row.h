/// @file
/// One body against all bodies in SIMD.
#pragma once

#include <spu_intrinsics.h>

#include <cstdint>

namespace cellsweep::cell {

/// Writes bodies / 32 words: bit 31 − (j mod 32) of word j / 32 says that the closed boxes of `body` and j
/// overlap (so its own bit is set). `boxes` holds six arrays of `bodies` floats, a multiple of 128: min x, y,
/// z, max x, y, z.
void overlap_row(const vec_float4* boxes, std::uint32_t bodies, std::uint32_t body, std::uint32_t* row);

}  // namespace cellsweep::cell

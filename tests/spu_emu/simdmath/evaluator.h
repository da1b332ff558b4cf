// Whoever computes the functions of the SIMD math library: the host engine's headers, real SPU code, a PPU.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace simdmath_test {

/// A register as words, the leftmost first.
using Words = std::array<std::uint32_t, 4>;

/// Arguments of one call, and its results.
using Call = std::array<Words, 3>;
using Result = std::array<Words, 2>;

/// The names of all functions; a function's number is its place here.
const std::vector<std::string>& function_names();
unsigned number_of(const std::string& name);

/// By the headers, compiled for the host engine, in the rounding of the SPU.
std::vector<Result> evaluate_on_host(unsigned function, const std::vector<Call>& calls);
/// The same compiled with SPU_EMU_PRECISE, for which exponent 255 is a number.
std::vector<Result> evaluate_precisely_on_host(unsigned function, const std::vector<Call>& calls);

}  // namespace simdmath_test

// Inputs for calls of unknown intrinsics: edges of all element widths and float classes among random bits.
#pragma once

#include <cstdint>
#include <random>
#include <vector>

namespace differential {

// Words of `quadwords` quadwords, as values; the same for the same seed.
std::vector<std::uint32_t> make_words(std::size_t quadwords, std::uint64_t seed);

}  // namespace differential

/// @file
/// How tests look at recordings: equal bit for bit, and refused for a given reason.
#pragma once

#include <gmock/gmock.h>

#include <array>
#include <bit>
#include <cstdint>
#include <string>
#include <vector>

#include "cellsweep/world/recording.h"

namespace cellsweep {

/// The bits of all boxes: unlike the numbers, they tell −0 from +0.
inline std::vector<std::uint32_t> bits_of(std::span<const Aabb> boxes) {
  std::vector<std::uint32_t> bits;
  for (const Aabb& box : boxes) {
    for (const auto& corner : {box.min, box.max}) {
      for (const float number : corner) bits.push_back(std::bit_cast<std::uint32_t>(number));
    }
  }
  return bits;
}

MATCHER_P(RefusedWith, message, "") {
  if (arg.ok()) {
    *result_listener << "which was accepted";
    return false;
  }
  const Status status = arg.status();
  *result_listener << "whose message is " << status.message;
  return status.code == StatusCode::bad_input &&
         testing::ExplainMatchResult(message, status.message, result_listener);
}

}  // namespace cellsweep

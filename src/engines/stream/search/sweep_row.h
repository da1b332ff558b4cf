/// @file
/// A box in small numbers.
#pragma once

#include <cstdint>

#include "cellsweep/engine/slots.h"

namespace cellsweep::stream {

/// Its numbers are packed as EightRows says.
struct SweepRow {
  std::uint32_t on_axis;
  std::uint32_t on_others;
  Slot slot;

  std::uint32_t low() const { return on_axis & 0xffffU; }
  std::uint32_t high() const { return on_axis >> 16; }
};

}  // namespace cellsweep::stream

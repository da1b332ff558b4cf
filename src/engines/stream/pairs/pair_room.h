/// @file
/// Room for pairs while an update finds what changed among them.
#pragma once

#include <cstddef>

#include "base/memory/array.h"
#include "cellsweep/engine/slots.h"

namespace cellsweep::stream {

/// Two lists as long as the candidates, for whoever needs some at the time: each may write over what the last
/// one left there. What an update found lies there at its end, so that what goes on behind that for later
/// updates must not be given it.
struct PairRoom {
  Array<SlotPair> one;
  Array<SlotPair> other;

  std::size_t bytes() const { return one.bytes() + other.bytes(); }
};

}  // namespace cellsweep::stream

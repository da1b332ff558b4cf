/// @file
/// Questions in a world that moves: frames in which some bodies move and rays are asked then.
#pragma once

#include <cstddef>
#include <span>

#include "bench/queries/query_world.h"

namespace cellsweep::bench {

struct FrameSuite {
  std::span<const std::size_t> bodies = kQueryBodies;
  std::size_t questions = 1'000;  ///< in a frame
  std::size_t frames = 300;
  std::size_t turns = 3;  ///< of those that are compared
};

/// Registers a row `frames/WORLD/N/rays/PERCENT/NAME` for everybody who answers rays: that share of the
/// bodies moves in each frame, always the same ones, and then it is asked which body rays meet first.
///
/// A row's time is that of a frame in the mean, after some that are not counted: moves, whatever is done then
/// for the questions' sake, and the questions. Counters: `ask`, nanoseconds of a question; `move`,
/// milliseconds of the rest; whether that is done for the `pairs` anyway. The answers of the last frame are
/// compared as in rows `queries`, and their hash is the label.
void register_frame_suite(const FrameSuite& suite);

}  // namespace cellsweep::bench

/// @file
/// Compares engines with the oracle, frame by frame.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "cellsweep/broadphase.h"
#include "cellsweep/world/frame_source.h"
#include "report/hand_over.h"
#include "report/judge.h"

namespace cellsweep::report {

/// An empty engine, and what it is handed.
struct FedEngine {
  Broadphase engine;
  Shape shape = Shape::boxes;
};

/// Runs engines side by side over frame 0 and up to `updates` more; an interrupted run ends after the frame
/// it is at. An engine that is given poses is judged by the boxes that it hands out. Errors: those of the
/// engines and of insert_all().
Result<std::vector<VerifyReport>> verify_engines(std::span<FedEngine> engines, FrameSource& source,
                                                 std::size_t updates);

}  // namespace cellsweep::report

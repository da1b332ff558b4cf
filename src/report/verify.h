/// @file
/// Compares engines with the oracle, frame by frame.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "cellsweep/broadphase.h"
#include "cellsweep/world/frame_source.h"
#include "report/run_engine.h"

namespace cellsweep::report {

/// A pair on which an engine and the oracle disagree.
struct Difference {
  std::size_t frame = 0;
  Pair pair;
  bool missed = false;  ///< the oracle has it and the engine has not; else the other way round
  Aabb box_a;
  Aabb box_b;
};

/// How an engine did against the oracle.
struct VerifyReport {
  std::string engine;
  std::size_t frames = 0;      ///< frames compared, frame 0 included
  std::uint64_t pairs = 0;     ///< the oracle's pairs, summed over the frames
  std::uint64_t missed = 0;    ///< pairs the engine did not report, summed
  std::uint64_t invented = 0;  ///< pairs it reported that do not overlap, or twice, summed
  std::uint64_t wrong_changes =
      0;  ///< began and ended pairs that are not the difference of the frames, summed
  std::optional<Difference> first;

  bool exact() const { return missed == 0 && invented == 0 && wrong_changes == 0; }
};

/// Runs empty engines side by side over frame 0 and up to `updates` more. An engine that is given poses is
/// judged by the boxes that it hands out. Errors: those of the engines and of insert_all().
Result<std::vector<VerifyReport>> verify_engines(std::span<const std::unique_ptr<Broadphase>> engines,
                                                 FrameSource& source, std::size_t updates,
                                                 Shape shape = Shape::boxes);

/// A sentence for a person: which frame, which pair, which boxes.
std::string describe(const Difference& difference);

}  // namespace cellsweep::report

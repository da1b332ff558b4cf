/// @file
/// What engines say against what is true, frame by frame.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "cellsweep/aabb.h"
#include "cellsweep/broadphase.h"

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

/// A sentence for a person: which frame, which pair, which boxes.
std::string describe(const Difference& difference);

/// One engine's side of the comparison; keeps what the engine said the frame before.
class Judge {
 public:
  explicit Judge(std::string_view engine) { report_.engine = engine; }

  /// What an engine says of the next frame: its pairs in any order, and what changed. `truth` is the oracle's
  /// list, ascending; the boxes are by id.
  void compare(std::span<const Pair> said, const PairChanges& changes, const std::vector<Pair>& truth,
               std::span<const Aabb> boxes);

  const VerifyReport& report() const { return report_; }

 private:
  void note(Pair pair, bool missed, std::span<const Aabb> boxes);
  std::size_t wrong_changes(const PairChanges& changes, const std::vector<Pair>& found) const;

  VerifyReport report_;
  std::vector<Pair> before_;
};

}  // namespace cellsweep::report

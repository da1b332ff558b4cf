/// @file
/// Who is given the bodies that may be on a path, and how far the path goes.
#pragma once

#include <cstdint>
#include <new>
#include <span>

#include "queries/paths/path_numbers.h"
#include "queries/paths/path_walk.h"
#include "queries/world.h"

namespace cellsweep::queries {

class PathTaker {
 public:
  PathTaker(const Path& path, Take take) : numbers_(path), end_(path.end), take_(take) {}

  const CastNumbers& numbers() const { return numbers_.numbers(); }
  double end() const { return end_; }

  /// So many can be given at a time: those that were put into the first places.
  static constexpr std::uint32_t kGiven = TreeNode::kBoxes;
  void put(std::uint32_t place, const Candidate& candidate) {
    ::new (&candidates_.list[place]) Candidate(candidate);
  }
  /// Whether the path still goes anywhere.
  bool give(std::uint32_t count) {
    if (count == 0) return true;
    const double end = take_({candidates_.list, count});
    if (end < end_) {
      end_ = end;
      if (end >= 0) numbers_.end(end);
    }
    return end_ >= 0;
  }

 private:
  /// Room that nobody initialises: a question looks at few of them or none.
  union Candidates {
    Candidates() {}  // NOLINT(modernize-use-equals-default): that would be no constructor
    Candidate list[kGiven];
  };

  PathNumbers numbers_;
  double end_;
  Take take_;
  Candidates candidates_;
};

}  // namespace cellsweep::queries

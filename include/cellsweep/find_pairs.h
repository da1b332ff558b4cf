/// @file
/// Overlapping pairs of boxes at once, with no object to keep: of one set, or between two.
///
/// Each function sees exactly the pairs that comparing all boxes with all boxes would find, each once, on any
/// input, whatever the threads and the machine. Boxes are closed: touching counts. Boxes are called by their
/// places in the call, 0, 1, ....
///
/// Boxes of floats are compared as Broadphase compares them: -0 and denormal values count as +0. Boxes of
/// doubles are compared as they are given, in doubles. In two dimensions the third axis is left out. Both
/// sets of a call have the same dimensions and the same numbers.
///
/// Errors: bad_option (FindPairsOptions), bad_input (coordinates without an address; sets of different
/// kinds), capacity (more than 2^29 - 1 boxes, both sets together; more pairs than
/// FindPairsOptions::max_pairs) and invalid_box (a coordinate that is not finite, or a minimum above its
/// maximum, with the first boxes at fault by their places in Status::bodies). Boxes are checked before
/// anything is found.
///
/// Threads: calls are independent of each other. A call returns when all that it started has ended.
/// std::bad_alloc may leave it, as may what a visitor or the caller's executor throws.
#pragma once

#include <compare>
#include <concepts>
#include <cstdint>
#include <memory>
#include <type_traits>
#include <vector>

#include "cellsweep/box_view.h"
#include "cellsweep/executor.h"
#include "cellsweep/export.h"
#include "cellsweep/function_ref.h"
#include "cellsweep/pair.h"
#include "cellsweep/status.h"
#include "cellsweep/vector_isa.h"

namespace cellsweep {

/// A box of the first set and one of the second that overlap, by their places.
struct CrossPair {
  std::uint32_t a = 0;
  std::uint32_t b = 0;

  // NOLINTNEXTLINE(modernize-use-nullptr): the comparison that is generated has no pointer in it.
  friend auto operator<=>(const CrossPair&, const CrossPair&) = default;
};

struct FindPairsOptions {
  /// Threads, the caller's included. 0: as many as the machine has, 16 at most, where they pay; N: that many,
  /// as soon as each has 16 boxes to do; some 2,000 boxes are searched by the caller's alone. With an
  /// `executor`: at most so many of its tasks at a time.
  unsigned threads = 0;

  /// The caller's job system; null: threads of the library's own, which a call takes over from those before.
  /// Of several calls at once all but two start theirs, in some tenths of a millisecond.
  std::shared_ptr<Executor> executor{};

  VectorIsa isa = VectorIsa::best;

  /// The most pairs that there may be; 0 for no limit. A call that finds more stops there and returns
  /// StatusCode::capacity. Whether one is refused depends on the pairs alone, not on threads; a visitor has
  /// then seen so many.
  std::uint64_t max_pairs = 0;
};

/// All pairs of one set, `a < b`, ascending.
CELLSWEEP_API Result<std::vector<Pair>> find_pairs(const BoxView& boxes,
                                                   const FindPairsOptions& options = {});
/// All pairs of a box of the first set and one of the second, ascending by the first, then by the second; `a`
/// may be more or less than `b`, or as much.
CELLSWEEP_API Result<std::vector<CrossPair>> find_pairs(const BoxView& a, const BoxView& b,
                                                        const FindPairsOptions& options = {});

/// How many there are. No pair is kept.
CELLSWEEP_API Result<std::uint64_t> count_pairs(const BoxView& boxes, const FindPairsOptions& options = {});
CELLSWEEP_API Result<std::uint64_t> count_pairs(const BoxView& a, const BoxView& b,
                                                const FindPairsOptions& options = {});

/// What takes a pair and says whether to go on, or says nothing and sees them all.
template <class Visit, class AnyPair>
concept VisitsPairs = std::invocable<Visit&, AnyPair> &&
    (std::convertible_to<std::invoke_result_t<Visit&, AnyPair>, bool> ||
     std::is_void_v<std::invoke_result_t<Visit&, AnyPair>>);

CELLSWEEP_API Status visit_pairs(const BoxView& boxes, FunctionRef<bool(Pair)> visit,
                                 const FindPairsOptions& options = {});
CELLSWEEP_API Status visit_pairs(const BoxView& a, const BoxView& b, FunctionRef<bool(CrossPair)> visit,
                                 const FindPairsOptions& options = {});

/// Tells a visitor that says nothing from one that says whether to go on.
template <class AnyPair, class Visit>
bool goes_on_after(Visit& visit, AnyPair pair) {
  if constexpr (std::is_void_v<std::invoke_result_t<Visit&, AnyPair>>) {
    visit(pair);
    return true;
  } else {
    return static_cast<bool>(visit(pair));
  }
}

/// Calls `visit(pair)` with each pair, once, in no stated order, on the calling thread, until it returns
/// false; that is no error. No pair is kept. It runs with default floating-point settings, and what it throws
/// leaves the call.
template <VisitsPairs<Pair> Visit>
Status visit_pairs(const BoxView& boxes, Visit&& visit, const FindPairsOptions& options = {}) {
  const auto see = [&](Pair pair) { return goes_on_after(visit, pair); };
  return visit_pairs(boxes, FunctionRef<bool(Pair)>(see), options);
}
template <VisitsPairs<CrossPair> Visit>
Status visit_pairs(const BoxView& a, const BoxView& b, Visit&& visit, const FindPairsOptions& options = {}) {
  const auto see = [&](CrossPair pair) { return goes_on_after(visit, pair); };
  return visit_pairs(a, b, FunctionRef<bool(CrossPair)>(see), options);
}

}  // namespace cellsweep

/// @file
/// Step C9: which endpoints changed their place in the order of an axis.
#pragma once

#include <cstdint>

namespace cellsweep::cell::paper {

/// C9's ruling: among equal values minima come before maxima, and within each smaller IDs first, which is the
/// unsigned order of the ID words. Then the order of two endpoints says all about their bodies' overlap. The
/// values must be sorted.
void order_equal_values(const float* values, std::uint32_t* ids, std::uint32_t count);

/// One axis before and after the sort; `count` elements, whole vectors.
struct BeforeAndAfter {
  const float* values_before;
  const float* values_after;
  const std::uint32_t* ids_after;
  std::uint32_t count;
};

/// C9, Listing 4.11: `ids`, the ID words before the sort, become plain IDs where the value or the ID word at
/// a position changed, and kUnchanged elsewhere. An endpoint that left its place is reported under its own
/// ID.
void compare_changes(const BeforeAndAfter& axis, std::uint32_t* ids);

/// Listing 4.11 as it stands: values only, on plain IDs. Misses touches that begin or end (C9).
void compare_changes_literal(const BeforeAndAfter& axis, std::uint32_t* ids);

/// For arrays that are new: every position with an endpoint counts as changed.
void mark_all_changed(std::uint32_t* ids, std::uint32_t count);

}  // namespace cellsweep::cell::paper

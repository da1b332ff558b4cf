/// @file
/// How many SPEs the Cell engines use.
#pragma once

namespace cellsweep::cell {

/// As many has cell-paper always, and cell-resident at least: one for each.
inline constexpr unsigned kAxes = 3;
/// What an engine chooses that is not told.
inline constexpr unsigned kDefaultSpus = 3;
/// What two Cells have, on a blade.
inline constexpr unsigned kMostSpus = 16;

}  // namespace cellsweep::cell

/// @file
/// The settings of the engines on SPEs, by name: a table for each options struct.
#pragma once

#include <span>

#include "base/settings.h"
#include "cellsweep/cell.h"

namespace cellsweep::cell {

/// Every member that may be set by name.
template <class Options>
std::span<const SettingRow<Options>> setting_rows();

template <>
std::span<const SettingRow<CellPaperOptions>> setting_rows();
template <>
std::span<const SettingRow<CellBruteOptions>> setting_rows();
template <>
std::span<const SettingRow<CellResidentOptions>> setting_rows();
template <>
std::span<const SettingRow<CellStreamOptions>> setting_rows();

}  // namespace cellsweep::cell

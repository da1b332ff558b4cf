/// @file
/// Which engines of the table have which settings.
#pragma once

#include <string_view>

#include "cellsweep/engines.h"

namespace cellsweep::report {

bool has_setting(const EngineInfo& engine, std::string_view setting);

/// Those of the values that are for settings of this engine; none for a name that is not in the table.
SettingValues values_for(std::string_view engine, const SettingValues& values);

/// The last value that a setting is given; empty when it is given none.
std::string_view value_of(const SettingValues& values, std::string_view setting);

}  // namespace cellsweep::report

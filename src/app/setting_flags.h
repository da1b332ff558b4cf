/// @file
/// The settings of engines as flags of the command: `pair_map_bytes` is --pair-map-bytes.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "cellsweep/engines.h"

namespace cellsweep::app {

/// A setting, and which engines of the table have it.
struct SharedSetting {
  SettingInfo info;  ///< as the first of them describes it
  std::vector<std::string_view> engines;
};

/// Every setting of every engine of the table once, in the table's order.
std::vector<SharedSetting> shared_settings();

/// "--pair-map-bytes".
std::string flag_of(std::string_view setting);

/// What stands for its value in help: "SIZE", "host|isa"; empty for one that is there or not.
std::string value_name(const SettingInfo& info);

/// What help says of it: what it is for, what it is by default, and which engines have it.
std::string help_of(const SharedSetting& setting);

/// "control, cell-paper".
std::string names_text(const std::vector<std::string_view>& names);

/// A value as the library takes it, from one that a person typed: sizes such as 512M, `off` for no local
/// store's limit. What is no size stays as it is, for the library to refuse.
std::string value_from_typed(const SettingInfo& info, const std::string& typed);

/// Words of the library with flags in the place of the settings that they name; those whose names are words
/// of every day only if `about` names them.
std::string with_flags(std::string words, std::string_view about = {});

/// The message of a status in these words.
std::string message_with_flags(const Status& status);

}  // namespace cellsweep::app

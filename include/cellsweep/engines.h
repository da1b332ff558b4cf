/// @file
/// The table of engines by name, for programs that let their users choose one.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "cellsweep/broadphase.h"
#include "cellsweep/export.h"

namespace cellsweep {

/// What kind of text a setting takes.
enum class SettingKind {
  flag,    ///< "true" or "false"
  number,  ///< a whole number, 0 or more
  bytes,   ///< a number of bytes
  length,  ///< a length in world units, 0 or more, as 0.25
  choice,  ///< one of SettingInfo::choices
  text,
  texts  ///< may be given several times
};

/// A setting of an engine: a member of its options struct.
struct SettingInfo {
  std::string_view name;  ///< the member's: `pair_map_bytes`
  SettingKind kind = SettingKind::text;
  std::string_view initial{};  ///< what it is when it is not given
  std::string_view help{};     ///< a phrase for a person
  std::vector<std::string_view> choices{};
};

/// Names and values of settings, as texts.
using SettingValues = std::vector<std::pair<std::string, std::string>>;

/// One row of the table. The texts are literals.
struct EngineInfo {
  std::string_view name;
  std::string_view summary;  ///< one sentence for a person
  std::vector<SettingInfo> settings;
  Result<Broadphase> (*make)(const SettingValues& settings) = nullptr;
};

/// All engines that this program has: those of this library, `control`, `stream` and `oracle`, and those that
/// other libraries added. In the order in which they were added. Valid until the next call of add_engine().
CELLSWEEP_API std::span<const EngineInfo> engine_table();

/// Adds a row, or replaces the one of that name. What other libraries offer calls it: add_cell_engines(),
/// add_embree_engine(). Before other threads use the table.
CELLSWEEP_API void add_engine(EngineInfo info);

/// The row of that name; null when there is none.
CELLSWEEP_API const EngineInfo* find_engine(std::string_view name);

/// An empty broadphase with an engine of the table. Errors: bad_option for a name that is not in the table
/// (the message lists those that are), for a setting that the engine does not have, and for a value that is
/// none or out of range.
CELLSWEEP_API Result<Broadphase> make_broadphase(std::string_view engine, const SettingValues& settings = {});

}  // namespace cellsweep

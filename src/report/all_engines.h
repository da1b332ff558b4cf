/// @file
/// The engines of every library that this build has, and what only those on SPEs can do: nothing above knows
/// which libraries there are.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "cellsweep/cell.h"
#include "cellsweep/engines.h"

namespace cellsweep::report {

/// Adds to engine_table() what the other libraries of this build offer. Again and again is as good as once.
void add_all_engines();

/// cell_statistics(), also in a build without engines on SPEs: nothing there.
std::optional<CellStatistics> statistics_of_spes(const Broadphase& engine);

/// local_store_map(), also in a build without engines on SPEs: bad_option there.
Result<LocalStoreMap> local_store_of(std::string_view engine, const SettingValues& settings,
                                     std::uint64_t bodies);

/// LocalStoreMap::used(), also in a build without engines on SPEs.
std::uint64_t used_bytes(const LocalStoreMap& map);

/// insert_poses() and move_poses(), also in a build without engines on SPEs: bad_option there.
Status insert_posed(Broadphase& engine, std::span<const BodyId> ids, std::span<const BodyPose> poses);
Status move_posed(Broadphase& engine, std::span<const BodyId> ids, std::span<const BodyPose> poses);

}  // namespace cellsweep::report

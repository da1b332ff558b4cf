/// @file
/// The sentences that refuse a call, and who is at fault: looked for only once a call is known to be bad.
#pragma once

#include <cstddef>
#include <functional>
#include <span>

#include "broadphase/bodies/id_table.h"
#include "cellsweep/aabb.h"
#include "cellsweep/broadphase.h"

namespace cellsweep {

/// For spans that should be equally long; `what` are those that are not ids, in the plural.
[[gnu::cold]] Status length_status(std::size_t ids, std::size_t others, std::string_view what = "boxes");

/// All boxes that are invalid, or an ok status. One body each; `ids` may be empty, then bodies are called by
/// their places in the call.
[[gnu::cold]] Status find_invalid_boxes(std::span<const BodyId> ids, std::span<const Aabb> boxes);

/// All ids that are not in the table, or an ok status.
Status find_unknown(const IdTable& table, std::span<const BodyId> ids);

/// All ids of which `is_unseen` says that no update has seen their bodies, or an ok status.
[[gnu::cold]] Status find_unseen(std::span<const BodyId> ids, const std::function<bool(BodyId)>& is_unseen);

/// All ids that are in the table already, or an ok status.
[[gnu::cold]] Status find_held(const IdTable& table, std::span<const BodyId> ids);

/// All ids that the call lists more than once, or an ok status.
[[gnu::cold]] Status find_listed_twice(std::span<const BodyId> ids);

/// Refuses when there would be more bodies than `capacity` allows.
Status check_capacity(std::string_view engine, const Capacity& capacity, std::uint64_t wanted);

/// True when each id is above the one before: the callers' usual order, in which none can be listed twice.
bool ascends(std::span<const BodyId> ids);

}  // namespace cellsweep

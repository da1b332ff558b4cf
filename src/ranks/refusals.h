/// @file
/// The sentences that refuse a call on the rank where it was made.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "cellsweep/ranks.h"

namespace cellsweep::ranks {

/// For spans that should be equally long; `what` are those that are not ids, in the plural.
Status length_status(std::size_t ids, std::size_t others, const char* what);

/// All boxes that are invalid, or an ok status.
Status find_invalid_boxes(std::span<const GlobalId> ids, std::span<const Aabb> boxes);

/// Of the bodies at fault, or an ok status where there is none: "Body 3 is WHY."
Status refuse_bodies(StatusCode code, std::vector<GlobalId> bodies, const char* why);

/// All ids that the call lists more than once, or an ok status.
Status find_listed_twice(std::span<const GlobalId> ids);

}  // namespace cellsweep::ranks

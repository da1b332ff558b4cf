/// @file
/// Boxes of two sets that the other set does not come near need no search.
#pragma once

#include "one_shot/box_set.h"

namespace cellsweep::one_shot {

/// Leaves out boxes of two sets that lie apart from all of the other set, as far as a coarse grid tells,
/// where that is worth it. The boxes are SearchedBoxes::own.
void leave_out_apart(SearchedBoxes& boxes);

}  // namespace cellsweep::one_shot

/// @file
/// Suite `tuning/`: the numbers of src/base/tuning.h, measured anew on this machine.
#pragma once

namespace cellsweep::bench {

/// Where a constant is a cost, a row is named after it, and its counter `measured` is in the unit of the
/// constant, which stands beside it as `in_code`. Where it is a limit at which one way gives place to
/// another, rows NAME/VALUE stand to both sides of it: their counters say what the two ways take there, or,
/// when only one of them can be gone there, what that takes. Choices without a row are judged by the suites
/// that tuning.h names, with another value compiled in.
void register_tuning_suite();

}  // namespace cellsweep::bench

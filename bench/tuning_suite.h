/// @file
/// Suite `tuning/`: the numbers of src/base/tuning.h, measured anew on this machine.
#pragma once

namespace cellsweep::bench {

/// Each row's counter `measured` is in the unit of the constant that it is named after, which stands beside
/// it as `in_code`. Constants that are choices and not costs have no row: they are judged by the suites that
/// tuning.h names, with another value compiled in.
void register_tuning_suite();

}  // namespace cellsweep::bench

/// @file
/// Test programs with this file know all engines of the build from their start.
#include "report/all_engines.h"

namespace {

[[maybe_unused]] const bool kAdded = [] {
  cellsweep::report::add_all_engines();
  return true;
}();

}  // namespace

/// @file
/// Places in the project's pages that hold what was measured.
#pragma once

#include <string>

#include "cellsweep/status.h"

namespace cellsweep::bench {

/// The text with what stands between the lines `<!-- NAME: begin -->` and `<!-- NAME: end -->` replaced.
/// Errors: bad_input when it has no such lines.
Result<std::string> replace_between_marks(std::string text, const std::string& name,
                                          const std::string& content);

}  // namespace cellsweep::bench

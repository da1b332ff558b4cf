/// @file
/// What is said of a file that could not be written.
#pragma once

#include <string>
#include <system_error>

#include "base/text.h"
#include "cellsweep/status.h"

namespace cellsweep::ranks {

inline Status write_fault(const std::string& path, const std::string& why) {
  Status status;
  status.code = StatusCode::write_failed;
  status.message = text("Cannot write ", path, ": ", why, ".");
  return status;
}

/// `error` is errno's.
inline Status write_fault(const std::string& path, int error) {
  return write_fault(path, std::generic_category().message(error));
}

}  // namespace cellsweep::ranks

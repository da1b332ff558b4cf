/// @file
/// One program at a time in a folder of results.
#pragma once

#include <filesystem>

#include "cellsweep/status.h"

namespace cellsweep::report {

/// Keeps other programs that ask for the same folder from writing there until it goes, or its program ends,
/// however that is. It leaves nothing in the folder.
class FolderLock {
 public:
  FolderLock() = default;
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;
  ~FolderLock();

  /// Makes the folder unless it is there. Errors: those of make_folder(), and bad_input when another program
  /// writes there. A file system that knows no locks has none.
  Status take(const std::filesystem::path& folder);

 private:
  int folder_ = -1;
};

}  // namespace cellsweep::report

#include "report/folder_lock.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>

#include "base/text.h"
#include "report/text_file.h"

namespace cellsweep::report {

FolderLock::~FolderLock() {
  if (folder_ >= 0) ::close(folder_);
}

Status FolderLock::take(const std::filesystem::path& folder) {
  if (Status status = make_folder(folder); !status.ok()) return status;
  folder_ = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (folder_ < 0 || ::flock(folder_, LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK) return {};
  return Status::bad_input(text(
      folder.string(), ": another cellsweep writes there now; wait for its end, or choose another folder."));
}

}  // namespace cellsweep::report

#include "cellsweep/engine/new_file.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <new>
#include <system_error>

#include "base/text.h"

namespace cellsweep {
namespace {

constexpr int kMostNames = 1000;
constexpr mode_t kNewMode = 0666;  // less what the user's umask takes
constexpr mode_t kAllModes = 07777;
constexpr mode_t kAnyWriter = 0222;

[[gnu::cold]] std::string temporary_name(const std::string& folder, int number) {
  return text(folder, "/.cellsweep-", number, ".tmp");
}

bool is_same_file(const struct stat& one, const struct stat& other) {
  return one.st_dev == other.st_dev && one.st_ino == other.st_ino;
}

// Writers hold a lock on what has a temporary name, which goes with them however they end. In between, the
// file may have got its own name, and another the temporary one.
[[gnu::cold]] void remove_leftover(const std::string& name) {
  const int file = ::open(name.c_str(), O_RDONLY | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK);
  if (file < 0) return;
  struct stat locked {};
  struct stat named {};
  if (::flock(file, LOCK_EX | LOCK_NB) == 0 && ::fstat(file, &locked) == 0 &&
      ::lstat(name.c_str(), &named) == 0 && is_same_file(locked, named))
    ::unlink(name.c_str());
  ::close(file);
}

[[gnu::cold]] void remove_leftovers(const std::string& folder) {
  for (int number = 0; number < kMostNames; ++number) {
    const std::string name = temporary_name(folder, number);
    if (::access(name.c_str(), F_OK) != 0) return;
    remove_leftover(name);
  }
}

// Whether it is the path that is to blame, and not the disk.
[[gnu::cold]] bool is_of_the_path(int error) {
  switch (error) {
    case ENOENT:
    case ENOTDIR:
    case EISDIR:
    case EACCES:
    case EPERM:
    case EROFS:
    case ELOOP:
    case ENAMETOOLONG:
    case EINVAL:
    case ENXIO:
      return true;
    default:
      return false;
  }
}

[[gnu::cold]] std::string message_of(const std::string& path, std::string_view reason) {
  return text(path, ": cannot be written: ", reason, ".");
}

[[gnu::cold]] Status write_failed(const std::string& path, int error) {
  Status status = Status::bad_input(message_of(path, std::generic_category().message(error)));
  status.code = StatusCode::write_failed;
  return status;
}

[[gnu::cold]] Status refuse(const std::string& path, int error) {
  Status status = write_failed(path, error);
  if (is_of_the_path(error)) status.code = StatusCode::bad_input;
  return status;
}

/// No signal ends the program on this thread between a temporary name and the file's own.
class SignalPause {
 public:
  SignalPause() {
    sigset_t all;
    sigfillset(&all);
    pthread_sigmask(SIG_BLOCK, &all, &before_);
  }
  SignalPause(const SignalPause&) = delete;
  SignalPause& operator=(const SignalPause&) = delete;
  ~SignalPause() { pthread_sigmask(SIG_SETMASK, &before_, nullptr); }

 private:
  sigset_t before_{};
};

}  // namespace

struct NewFile::Target {
  struct stat status {};
  bool is_there = false;
};

NewFile::~NewFile() {
  forget();
}

void NewFile::forget() {
  if (!name_.empty()) ::unlink(name_.c_str());
  name_.clear();
  if (file_ >= 0) ::close(file_);
  file_ = -1;
}

Status NewFile::fail(int error) {
  forget();
  return write_failed(path_, error);
}

Status NewFile::look_at_target(Target& target) const {
  target.is_there = ::stat(target_.c_str(), &target.status) == 0;
  if (!target.is_there) return errno == ENOENT ? Status() : refuse(path_, errno);
  if (S_ISDIR(target.status.st_mode)) return Status::bad_input(message_of(path_, "it is a folder"));
  // root may write to any file; who made one read-only meant root, too.
  if (S_ISREG(target.status.st_mode) &&
      ((target.status.st_mode & kAnyWriter) == 0 || ::access(target_.c_str(), W_OK) != 0))
    return Status::bad_input(message_of(path_, "it is read-only, and stays as it is"));
  return {};
}

Status NewFile::open(const std::string& path) {
  path_ = path;
  if (path.empty()) return refuse("\"\"", ENOENT);
  const std::unique_ptr<char, void (*)(void*)> real(::realpath(path.c_str(), nullptr), std::free);
  if (!real && errno == ENOMEM) throw std::bad_alloc();
  target_ = real ? real.get() : path;
  const std::size_t slash = target_.rfind('/');
  folder_ = slash == std::string::npos ? "." : target_.substr(0, slash + 1);
  Target target;
  if (Status status = look_at_target(target); !status.ok()) return status;
  is_device_ = target.is_there && !S_ISREG(target.status.st_mode);
  if (!is_device_) return open_file();
  file_ = ::open(target_.c_str(), O_WRONLY | O_CLOEXEC | O_NOCTTY);
  return file_ < 0 ? refuse(path_, errno) : Status();
}

Status NewFile::open_file() {
  remove_leftovers(folder_);
#ifdef O_TMPFILE
  // Its name is given by way of /proc.
  if (::access("/proc/self/fd", X_OK) == 0) {
    file_ = ::open(folder_.c_str(), O_TMPFILE | O_WRONLY | O_CLOEXEC, kNewMode);
    if (file_ >= 0) return {};
    if (errno != EOPNOTSUPP && errno != EISDIR && errno != EINVAL) return refuse(path_, errno);
  }
#endif
  return open_named() ? Status() : refuse(path_, errno);
}

// Before it is locked, another program may take it for a leftover.
bool NewFile::open_named() {
  for (int number = 0; number < kMostNames; ++number) {
    name_ = temporary_name(folder_, number);
    file_ = ::open(name_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC | O_NOFOLLOW, kNewMode);
    struct stat made {};
    if (file_ >= 0) {
      ::flock(file_, LOCK_EX | LOCK_NB);
      if (::fstat(file_, &made) == 0 && made.st_nlink == 1) return true;
      ::close(file_);
    } else if (errno != EEXIST) {
      break;
    }
  }
  file_ = -1;
  name_.clear();
  return false;
}

Status NewFile::write(std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(file_, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) return fail(written < 0 ? errno : EIO);
    bytes.remove_prefix(static_cast<std::size_t>(written));
  }
  return {};
}

Status NewFile::commit() {
  if (!is_device_) {
    Target target;
    if (Status status = look_at_target(target); !status.ok()) {
      forget();
      return status;
    }
    if (!keep_owner_and_mode(target) || ::fsync(file_) != 0 || !publish(target)) return fail(errno);
  }
  const int file = file_;
  file_ = -1;
  return ::close(file) == 0 || errno == EINTR ? Status() : write_failed(path_, errno);
}

// A change of the owner takes rights away, and comes first.
bool NewFile::keep_owner_and_mode(const Target& target) const {
  if (!target.is_there) return true;
  struct stat mine {};
  if (::fstat(file_, &mine) != 0) return false;
  const bool is_mine = mine.st_uid == target.status.st_uid && mine.st_gid == target.status.st_gid;
  if (!is_mine && ::fchown(file_, target.status.st_uid, target.status.st_gid) != 0) return false;
  return ::fchmod(file_, target.status.st_mode & kAllModes) == 0;
}

bool NewFile::publish(const Target& target) {
  const SignalPause no_signals;
  const std::string nameless = text("/proc/self/fd/", file_);
  if (name_.empty()) {
    const auto link_as = [&](const std::string& name) {
      return ::linkat(AT_FDCWD, nameless.c_str(), AT_FDCWD, name.c_str(), AT_SYMLINK_FOLLOW) == 0;
    };
    if (!target.is_there && link_as(target_)) return true;
    if (!target.is_there && errno != EEXIST) return false;
    if (!take_name()) return false;
  }
  if (std::rename(name_.c_str(), target_.c_str()) != 0) return false;
  name_.clear();
  return true;
}

bool NewFile::take_name() {
  ::flock(file_, LOCK_EX | LOCK_NB);
  const std::string nameless = text("/proc/self/fd/", file_);
  for (int number = 0; number < kMostNames; ++number) {
    const std::string name = temporary_name(folder_, number);
    if (::linkat(AT_FDCWD, nameless.c_str(), AT_FDCWD, name.c_str(), AT_SYMLINK_FOLLOW) == 0) {
      name_ = name;
      return true;
    }
    if (errno != EEXIST) return false;
  }
  return false;
}

}  // namespace cellsweep

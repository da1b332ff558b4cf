// The functions of POSIX that newlib leaves to the host.
#include <fcntl.h>
#include <sched.h>
#include <sys/stat.h>
#include <sys/time.h>
#include <time.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <vector>

#include "isa/libc/library_calls.h"

namespace spu_emu::isa {

namespace {
enum class Posix : unsigned {
  close = 2,
  fstat = 4,
  getpagesize = 6,
  gettimeofday = 7,
  lseek = 9,
  lstat = 10,
  open = 15,
  read = 16,
  stat = 23,
  unlink = 24,
  write = 27,
  ftruncate = 28,
  access = 29,
  dup = 30,
  nanosleep = 32,
  mkdir = 35,
  rmdir = 36,
  chmod = 37,
  getcwd = 43,
  fsync = 48,
  truncate = 52,
  sched_yield = 61,
  pread = 65,
  pwrite = 66
};

struct Call {
  StoreBytes& store;
  HostFiles& files;
  std::uint32_t block;

  std::uint32_t word(std::uint32_t index) const { return argument(store, block, index); }
  std::int32_t number(std::uint32_t index) const { return static_cast<std::int32_t>(word(index)); }
  std::string text(std::uint32_t index) const { return store.text(word(index)); }
};

CallResult checked(std::int64_t value) {
  return {static_cast<std::uint32_t>(value), value == -1 ? errno : 0};
}

/// The flags of open as newlib sends them: those of Linux on PowerPC and x86 alike.
CallResult open_file(const Call& call) {
  constexpr int kAllowed = O_ACCMODE | O_CREAT | O_EXCL | O_NOCTTY | O_TRUNC | O_APPEND | O_NONBLOCK | O_SYNC;
  const int flags = (call.number(1) & kAllowed) | O_CLOEXEC;
  return checked(call.files.add_descriptor(::open(call.text(0).c_str(), flags, call.word(2) & 0777U)));
}

/// read and pread: descriptor, buffer, size, offset.
CallResult read_file(const Call& call, bool at_offset) {
  const std::uint32_t size = call.word(2);
  call.store.read(call.word(1), size);  // The whole buffer must be there, whatever will be read.
  std::vector<std::byte> buffer(size);
  const ssize_t done = at_offset ? ::pread(call.number(0), buffer.data(), size, call.number(3))
                                 : ::read(call.number(0), buffer.data(), size);
  if (done > 0) call.store.write(call.word(1), std::span(buffer).first(static_cast<std::size_t>(done)));
  return checked(done);
}

/// What the C functions wrote before goes out before.
CallResult write_file(const Call& call, bool at_offset) {
  const auto bytes = call.store.read(call.word(1), call.word(2));
  std::fflush(stdout);
  return checked(at_offset ? ::pwrite(call.number(0), bytes.data(), bytes.size(), call.number(3))
                           : ::write(call.number(0), bytes.data(), bytes.size()));
}

/// Thirteen words, in the order of newlib's own struct for this.
CallResult put_status(const Call& call, int result, const struct stat& status) {
  if (result != 0) return checked(result);
  std::uint32_t at = call.word(1);
  const auto put = [&](auto value) {
    call.store.set_word(at, static_cast<std::uint32_t>(value));
    at += 4;
  };
  put(status.st_dev);
  put(status.st_ino);
  put(status.st_mode);
  put(status.st_nlink);
  put(status.st_uid);
  put(status.st_gid);
  put(status.st_rdev);
  put(status.st_size);
  put(status.st_blksize);
  put(status.st_blocks);
  put(status.st_atime);
  put(status.st_mtime);
  put(status.st_ctime);
  return {};
}

/// Times are newlib's since its version 3: seconds in 64 bits, then a word.
CallResult tell_time(const Call& call) {
  timeval now{};
  gettimeofday(&now, nullptr);
  call.store.set_doubleword(call.word(0), static_cast<std::uint64_t>(now.tv_sec));
  call.store.set_word(call.word(0) + 8, static_cast<std::uint32_t>(now.tv_usec));
  return {};
}

CallResult sleep_for(const Call& call) {
  const std::uint32_t wanted = call.word(0);
  const timespec time{static_cast<time_t>(call.store.doubleword(wanted)),
                      static_cast<long>(call.store.word(wanted + 8))};
  return checked(::nanosleep(&time, nullptr));
}

CallResult tell_directory(const Call& call) {
  std::vector<char> name(4096);
  if (::getcwd(name.data(), name.size()) == nullptr) return {0, errno};
  const std::span<const char> text(name.data(), std::string_view(name.data()).size() + 1);
  if (text.size() > call.word(1)) return {0, ERANGE};
  call.store.write(call.word(0), std::as_bytes(text));
  return {call.word(0), 0};
}

CallResult call_on_descriptor(const Call& call, Posix number) {
  const int descriptor = call.number(0);
  if (!call.files.owns(descriptor)) return refused(EBADF);
  struct stat status {};
  switch (number) {
    case Posix::close:
      return checked(call.files.close_descriptor(descriptor));
    case Posix::fstat:
      return put_status(call, ::fstat(descriptor, &status), status);
    case Posix::lseek:
      return checked(::lseek(descriptor, call.number(1), call.number(2)));
    case Posix::read:
      return read_file(call, false);
    case Posix::pread:
      return read_file(call, true);
    case Posix::write:
      return write_file(call, false);
    case Posix::pwrite:
      return write_file(call, true);
    case Posix::ftruncate:
      return checked(::ftruncate(descriptor, call.number(1)));
    case Posix::dup:
      return checked(call.files.add_descriptor(::dup(descriptor)));
    default:
      return checked(::fsync(descriptor));
  }
}

/// The calls that name files of the host.
CallResult call_naming_files(const Call& call, Posix number) {
  if (!call.files.allowed()) return refused(EACCES);
  const std::string name = call.text(0);
  struct stat status {};
  switch (number) {
    case Posix::open:
      return open_file(call);
    case Posix::stat:
      return put_status(call, ::stat(name.c_str(), &status), status);
    case Posix::lstat:
      return put_status(call, ::lstat(name.c_str(), &status), status);
    case Posix::unlink:
      return checked(::unlink(name.c_str()));
    case Posix::access:
      return checked(::access(name.c_str(), call.number(1)));
    case Posix::mkdir:
      return checked(::mkdir(name.c_str(), call.word(1) & 0777U));
    case Posix::rmdir:
      return checked(::rmdir(name.c_str()));
    case Posix::chmod:
      return checked(::chmod(name.c_str(), call.word(1) & 0777U));
    default:
      return checked(::truncate(name.c_str(), call.number(1)));
  }
}
}  // namespace

CallResult call_posix(StoreBytes& store, HostFiles& files, unsigned int code, std::uint32_t arguments) {
  const Call call{store, files, arguments};
  const auto number = static_cast<Posix>(code);
  switch (number) {
    case Posix::close:
    case Posix::fstat:
    case Posix::lseek:
    case Posix::read:
    case Posix::pread:
    case Posix::write:
    case Posix::pwrite:
    case Posix::ftruncate:
    case Posix::dup:
    case Posix::fsync:
      return call_on_descriptor(call, number);
    case Posix::open:
    case Posix::stat:
    case Posix::lstat:
    case Posix::unlink:
    case Posix::access:
    case Posix::mkdir:
    case Posix::rmdir:
    case Posix::chmod:
    case Posix::truncate:
      return call_naming_files(call, number);
    case Posix::getpagesize:
      return {static_cast<std::uint32_t>(::getpagesize()), 0};
    case Posix::gettimeofday:
      return tell_time(call);
    case Posix::nanosleep:
      return sleep_for(call);
    case Posix::sched_yield:
      return checked(::sched_yield());
    case Posix::getcwd:
      return files.allowed() ? tell_directory(call) : CallResult{0, EACCES};
    default:
      return refused(ENOSYS);
  }
}

}  // namespace spu_emu::isa

/// @file
/// A library to preload (LD_PRELOAD) that makes a chosen call of the system's library fail, or kills the
/// program before it. It speaks by the environment, and asks for no memory itself:
///   CELLSWEEP_FAIL="KIND N WHAT"   the N-th call of a kind, from 1 on; N "after" 5 as "5+": that and all
///   later ones CELLSWEEP_CALLS=FILE           where the number of calls of each kind is written at the end
/// WHAT is a number of <errno.h>, "short" for a write of half of the bytes, or "signal-" and a signal's
/// number. KIND is one of kKinds, or "file" for all of them but memory.
#include <dlfcn.h>
#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdarg>
#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <cstring>

extern "C" {
void* __libc_malloc(std::size_t);                           // NOLINT: glibc's names
void* __libc_calloc(std::size_t, std::size_t);              // NOLINT
void* __libc_realloc(void*, std::size_t);                   // NOLINT
void* __libc_memalign(std::size_t alignment, std::size_t);  // NOLINT
}

namespace {

enum Kind : std::size_t {
  kOpen,
  kWrite,
  kRead,
  kSync,
  kOwner,
  kMode,
  kLink,
  kRename,
  kClose,
  kMap,
  kMemory,
  kFile
};
constexpr std::array<const char*, 12> kKinds = {"open", "write",  "read",  "fsync", "fchown", "fchmod",
                                                "link", "rename", "close", "mmap",  "malloc", "file"};

struct Plan {
  std::size_t kind = kKinds.size();
  long number = 0;
  bool and_later = false;
  int error = 0;
  int signal = 0;
  bool is_short = false;
};

std::array<std::atomic<long>, kKinds.size()> calls;
std::atomic<int> ready = 0;
Plan plan;

void read_plan(const char* words) {
  const char* const number = std::strchr(words, ' ');
  if (number == nullptr) return;
  for (std::size_t kind = 0; kind < kKinds.size(); ++kind) {
    const auto length = static_cast<std::size_t>(number - words);
    if (std::strlen(kKinds[kind]) == length && std::strncmp(words, kKinds[kind], length) == 0)
      plan.kind = kind;
  }
  char* rest = nullptr;
  plan.number = std::strtol(number, &rest, 10);
  plan.and_later = *rest == '+';
  if (plan.and_later) ++rest;
  while (*rest == ' ') ++rest;
  plan.is_short = std::strcmp(rest, "short") == 0;
  if (std::strncmp(rest, "signal-", 7) == 0) {
    plan.signal = std::atoi(rest + 7);
  } else {
    plan.error = std::atoi(rest);
  }
}

// Before libc has the environment, nothing is counted.
bool is_ready() {
  if (ready == 0 && environ != nullptr) {
    ready = 1;
    if (const char* words = std::getenv("CELLSWEEP_FAIL")) read_plan(words);
  }
  return ready != 0;
}

bool is_planned(std::size_t kind, long number) {
  return kind == plan.kind && (number == plan.number || (plan.and_later && number > plan.number));
}

// Whether this call is to fail.
bool fails(Kind kind) {
  if (!is_ready()) return false;
  const bool is_mine = is_planned(kind, ++calls[kind]);
  const bool is_anyones = kind != kMemory && is_planned(kFile, ++calls[kFile]);
  if (!is_mine && !is_anyones) return false;
  if (plan.signal != 0) {
    raise(plan.signal);
    return false;
  }
  errno = plan.error;
  return true;
}

template <class Function>
Function* next(Function*, const char* name) {
  return reinterpret_cast<Function*>(dlsym(RTLD_NEXT, name));
}

[[gnu::destructor]] void tell_calls() {
  const char* const path = std::getenv("CELLSWEEP_CALLS");
  if (path == nullptr) return;
  plan.kind = kKinds.size();
  const int file = next(&open, "open")(path, O_WRONLY | O_CREAT | O_TRUNC, 0666);
  for (std::size_t kind = 0; kind < kKinds.size(); ++kind)
    dprintf(file, "%s %ld\n", kKinds[kind], calls[kind].load());
}

}  // namespace

// Other programs that this one starts are left alone.
[[gnu::constructor]] static void stay_here() {
  unsetenv("LD_PRELOAD");
}

extern "C" {

int open(const char* path, int flags, ...) {
  va_list rest;
  va_start(rest, flags);
  const bool makes = (flags & O_CREAT) != 0 || (flags & O_TMPFILE) == O_TMPFILE;
  const mode_t mode = makes ? va_arg(rest, mode_t) : 0;
  va_end(rest);
  static const auto real = next(&open, "open");
  return fails(kOpen) ? -1 : real(path, flags, mode);
}

FILE* fopen(const char* path, const char* mode) {
  static const auto real = next(&fopen, "fopen");
  return fails(kOpen) ? nullptr : real(path, mode);
}

ssize_t write(int file, const void* bytes, std::size_t size) {
  static const auto real = next(&write, "write");
  const bool is_failing = fails(kWrite);
  if (is_failing && plan.is_short) return real(file, bytes, size > 1 ? size / 2 : size);
  return is_failing ? -1 : real(file, bytes, size);
}

ssize_t pwrite(int file, const void* bytes, std::size_t size, off_t offset) {
  static const auto real = next(&pwrite, "pwrite");
  const bool is_failing = fails(kWrite);
  if (is_failing && plan.is_short) return real(file, bytes, size > 1 ? size / 2 : size, offset);
  return is_failing ? -1 : real(file, bytes, size, offset);
}

ssize_t pread(int file, void* bytes, std::size_t size, off_t offset) {
  static const auto real = next(&pread, "pread");
  const bool is_failing = fails(kRead);
  if (is_failing && plan.is_short) return real(file, bytes, size > 1 ? size / 2 : size, offset);
  return is_failing ? -1 : real(file, bytes, size, offset);
}

std::size_t fread(void* bytes, std::size_t size, std::size_t count, FILE* file) {
  static const auto real = next(&fread, "fread");
  if (!fails(kRead) || plan.is_short)
    return real(bytes, size, count, file);  // which goes on to the end itself
  constexpr int kErrorSeen = 0x20;          // glibc's, what ferror() asks for
  file->_flags |= kErrorSeen;
  return 0;
}

int fsync(int file) {
  static const auto real = next(&fsync, "fsync");
  return fails(kSync) ? -1 : real(file);
}

int fchown(int file, uid_t owner, gid_t group) noexcept {
  static const auto real = next(&fchown, "fchown");
  return fails(kOwner) ? -1 : real(file, owner, group);
}

int fchmod(int file, mode_t mode) noexcept {
  static const auto real = next(&fchmod, "fchmod");
  return fails(kMode) ? -1 : real(file, mode);
}

int linkat(int from_folder, const char* from, int to_folder, const char* to, int flags) noexcept {
  static const auto real = next(&linkat, "linkat");
  return fails(kLink) ? -1 : real(from_folder, from, to_folder, to, flags);
}

int rename(const char* from, const char* to) noexcept {
  static const auto real = next(&rename, "rename");
  return fails(kRename) ? -1 : real(from, to);
}

int close(int file) {
  static const auto real = next(&close, "close");
  if (!fails(kClose)) return real(file);
  real(file);
  errno = plan.error;
  return -1;
}

void* mmap(void* address, std::size_t size, int protection, int flags, int file, off_t offset) noexcept {
  static const auto real = next(&mmap, "mmap");
  return fails(kMap) ? MAP_FAILED : real(address, size, protection, flags, file, offset);
}

void* malloc(std::size_t size) noexcept {
  return fails(kMemory) ? nullptr : __libc_malloc(size);
}

void* calloc(std::size_t count, std::size_t size) noexcept {
  return fails(kMemory) ? nullptr : __libc_calloc(count, size);
}

void* realloc(void* memory, std::size_t size) noexcept {
  return fails(kMemory) ? nullptr : __libc_realloc(memory, size);
}

void* aligned_alloc(std::size_t alignment, std::size_t size) noexcept {
  return fails(kMemory) ? nullptr : __libc_memalign(alignment, size);
}

void* memalign(std::size_t alignment, std::size_t size) noexcept {
  return fails(kMemory) ? nullptr : __libc_memalign(alignment, size);
}

int posix_memalign(void** memory, std::size_t alignment, std::size_t size) noexcept {
  if (fails(kMemory)) return ENOMEM;
  *memory = __libc_memalign(alignment, size);
  return *memory == nullptr ? ENOMEM : 0;
}

}  // extern "C"

// Preloaded into the ranks of a job: one of them is killed, or its call fails for want of room, when it makes
// a certain call for the n-th time. BROKEN_RANK=RANK BROKEN_CALL=NAME BROKEN_AT=N, and BROKEN_HOW=fails or
// killed.
#include <dlfcn.h>
#include <fcntl.h>
#include <mpi.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>

namespace {

const char* setting(const char* name) {
  const char* value = std::getenv(name);
  return value == nullptr ? "" : value;
}

bool is_this_rank() {
  return std::strcmp(setting("OMPI_COMM_WORLD_RANK"), setting("BROKEN_RANK")) == 0;
}

/// True when the call is to fail.
bool breaks(const char* name) {
  static std::atomic<int> calls{0};
  static const bool is_here = is_this_rank();
  if (!is_here || std::strcmp(name, setting("BROKEN_CALL")) != 0) return false;
  if (++calls != std::atoi(setting("BROKEN_AT"))) return false;
  if (std::strcmp(setting("BROKEN_HOW"), "killed") == 0) std::raise(SIGKILL);
  errno = ENOSPC;
  return true;
}

template <class Function>
Function next(const char* name, Function) {
  return reinterpret_cast<Function>(dlsym(RTLD_NEXT, name));
}

}  // namespace

extern "C" {

int MPI_Allreduce(const void* from, void* to, int count, MPI_Datatype type, MPI_Op op, MPI_Comm comm) {
  breaks("MPI_Allreduce");
  static const auto call = next("MPI_Allreduce", &MPI_Allreduce);
  return call(from, to, count, type, op, comm);
}

int MPI_File_write_at(MPI_File file, MPI_Offset at, const void* bytes, int count, MPI_Datatype type,
                      MPI_Status* status) {
  if (breaks("MPI_File_write_at")) return MPI_ERR_NO_SPACE;
  static const auto call = next("MPI_File_write_at", &MPI_File_write_at);
  return call(file, at, bytes, count, type, status);
}

ssize_t pwrite(int file, const void* bytes, size_t count, off_t at) {
  if (breaks("pwrite")) return -1;
  static const auto call = next("pwrite", &pwrite);
  return call(file, bytes, count, at);
}

ssize_t pwrite64(int file, const void* bytes, size_t count, off64_t at) {
  if (breaks("pwrite")) return -1;
  static const auto call = next("pwrite64", &pwrite64);
  return call(file, bytes, count, at);
}

int posix_fallocate(int file, off_t at, off_t bytes) {
  if (breaks("posix_fallocate")) return ENOSPC;
  static const auto call = next("posix_fallocate", &posix_fallocate);
  return call(file, at, bytes);
}

int fsync(int file) {
  if (breaks("fsync")) return -1;
  static const auto call = next("fsync", &fsync);
  return call(file);
}

int rename(const char* from, const char* to) noexcept {
  if (breaks("rename")) return -1;
  static const auto call = next("rename", &rename);
  return call(from, to);
}
}

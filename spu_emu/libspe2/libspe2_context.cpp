// libspe2: contexts, gangs, program images, areas and machine information.
#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <memory>
#include <new>
#include <thread>

#include "isa/elf/elf_loader.h"
#include "libspe2/context.h"
#include "libspe2/load_program.h"
#include "libspe2/program_image.h"
#include "spe/settings.h"

namespace {

using spu_emu::fail;

constexpr int kSpesPerNode = 8;

/// A handle with the size of its mapping behind it.
struct ImageHandle {
  spe_program_handle_t program{};
  std::size_t size = 0;
};

int node_count() {
  const int processors = static_cast<int>(std::thread::hardware_concurrency());
  return processors <= kSpesPerNode ? 1 : (processors + kSpesPerNode - 1) / kSpesPerNode;
}

/// An open file's whole content, or MAP_FAILED with errno.
void* map_program(int file, std::size_t& size) {
  struct stat status {};
  if (fstat(file, &status) != 0) return MAP_FAILED;
  constexpr std::size_t kSmallest = 64;
  size = static_cast<std::size_t>(status.st_size);
  errno = EINVAL;
  if (size < kSmallest) return MAP_FAILED;
  errno = EACCES;
  if ((status.st_mode & (S_IXUSR | S_IXGRP | S_IXOTH)) == 0) return MAP_FAILED;
  void* image = mmap(nullptr, size, PROT_READ, MAP_PRIVATE, file, 0);
  if (image == MAP_FAILED) return image;
  const spu_emu::ImageKind kind = spu_emu::image_kind(image);
  if (kind == spu_emu::ImageKind::host_module && spu_emu::image_size(image) <= size) return image;
  if (kind == spu_emu::ImageKind::spu_elf &&
      spu_emu::isa::read_elf({static_cast<const std::byte*>(image), size}).program) {
    return image;
  }
  munmap(image, size);
  errno = EINVAL;
  return MAP_FAILED;
}

std::uint32_t area_offset(ps_area area) {
  switch (area) {
    case SPE_MSSYNC_AREA:
      return spu_emu::kMsSyncArea;
    case SPE_MFC_COMMAND_AREA:
      return spu_emu::kMfcCommandArea;
    case SPE_CONTROL_AREA:
      return spu_emu::kControlArea;
    case SPE_SIG_NOTIFY_1_AREA:
      return spu_emu::kSignal1Area;
    case SPE_SIG_NOTIFY_2_AREA:
      return spu_emu::kSignal2Area;
  }
  return spu_emu::kProblemStateSize;
}

}  // namespace

spu_emu::WaitPoint& spu_emu::event_point() {
  static WaitPoint point;
  return point;
}

spe_context_ptr_t spe_context_create(unsigned int flags, spe_gang_context_ptr_t gang) {
  if ((flags & (SPE_ISOLATE | SPE_ISOLATE_EMULATE)) != 0) {
    errno = (flags & SPE_ISOLATE) != 0 ? ENODEV : EINVAL;
    return nullptr;
  }
  try {
    auto context = std::make_unique<spe_context>(flags, gang, spu_emu::current_settings());
    if (gang != nullptr) gang->members.fetch_add(1);
    return context.release();
  } catch (const std::bad_alloc&) {
    errno = ENOMEM;
    return nullptr;
  }
}

spe_context_ptr_t spe_context_create_affinity(unsigned int flags, spe_context_ptr_t,
                                              spe_gang_context_ptr_t gang) {
  if (gang == nullptr) {
    errno = ESRCH;
    return nullptr;
  }
  return spe_context_create(flags, gang);
}

int spe_context_destroy(spe_context_ptr_t spe) {
  if (spe == nullptr) return fail(ESRCH);
  if (spe->running.load()) return fail(EBUSY);
  spu_emu::forget_in_event_handlers(spe);
  if (spe->gang != nullptr) spe->gang->members.fetch_sub(1);
  delete spe;
  return 0;
}

spe_gang_context_ptr_t spe_gang_context_create(unsigned int) {
  auto* gang = new (std::nothrow) spe_gang_context;
  if (gang == nullptr) errno = ENOMEM;
  return gang;
}

int spe_gang_context_destroy(spe_gang_context_ptr_t gang) {
  if (gang == nullptr) return fail(ESRCH);
  if (gang->members.load() != 0) return fail(EBUSY);
  delete gang;
  return 0;
}

spe_program_handle_t* spe_image_open(const char* filename) {
  if (filename == nullptr) {
    errno = EINVAL;
    return nullptr;
  }
  const int file = open(filename, O_RDONLY | O_CLOEXEC);
  if (file < 0) return nullptr;
  std::size_t size = 0;
  void* image = map_program(file, size);
  const int error = errno;
  close(file);
  errno = error;
  if (image == MAP_FAILED) return nullptr;
  auto handle = std::make_unique<ImageHandle>();
  handle->program = {sizeof(spe_program_handle_t), image, nullptr};
  handle->size = size;
  return &handle.release()->program;
}

int spe_image_close(spe_program_handle_t* program) {
  if (program == nullptr) return fail(EINVAL);
  const std::unique_ptr<ImageHandle> handle(reinterpret_cast<ImageHandle*>(program));
  return munmap(handle->program.elf_image, handle->size);
}

int spe_program_load(spe_context_ptr_t spe, spe_program_handle_t* program) {
  if (spe == nullptr) return fail(ESRCH);
  if (program == nullptr) return fail(EINVAL);
  if (spe->running.load()) return fail(EBUSY);
  const int error = spe->spe.load(*program, &spu_emu::load_program);
  return error == 0 ? 0 : fail(error);
}

void* spe_ls_area_get(spe_context_ptr_t spe) {
  if (spe == nullptr) {
    errno = ESRCH;
    return nullptr;
  }
  return spe->spe.arena().base();
}

int spe_ls_size_get(spe_context_ptr_t spe) {
  if (spe == nullptr) return fail(ESRCH);
  return static_cast<int>(spe->spe.store_size());
}

void* spe_ps_area_get(spe_context_ptr_t spe, enum ps_area area) {
  errno = 0;
  if (spe == nullptr)
    errno = ESRCH;
  else if (area_offset(area) == spu_emu::kProblemStateSize)
    errno = EINVAL;
  else if ((spe->flags & SPE_MAP_PS) == 0)
    errno = EACCES;
  if (errno != 0) return nullptr;
  return spe->spe.arena().base() + spu_emu::kProblemStateOffset + area_offset(area);
}

int spe_cpu_info_get(int info_requested, int cpu_node) {
  const bool known = info_requested == SPE_COUNT_PHYSICAL_CPU_NODES ||
                     info_requested == SPE_COUNT_PHYSICAL_SPES || info_requested == SPE_COUNT_USABLE_SPES;
  if (!known || cpu_node < -1 || cpu_node >= node_count()) return fail(EINVAL);
  if (info_requested == SPE_COUNT_PHYSICAL_CPU_NODES) return cpu_node == -1 ? node_count() : fail(EINVAL);
  return cpu_node == -1 ? node_count() * kSpesPerNode : kSpesPerNode;
}

int spe_mssync_start(spe_context_ptr_t spe) {
  return spe == nullptr ? fail(ESRCH) : 0;
}

int spe_mssync_status(spe_context_ptr_t spe) {
  return spe == nullptr ? fail(ESRCH) : 0;
}

spu_emu::SpeStatistics spu_emu::statistics(spe_context_ptr_t spe) {
  return spe->spe.statistics();
}

spu_emu::CycleProfile spu_emu::cycle_profile(spe_context_ptr_t spe) {
  return spe->spe.cycle_profile();
}

std::string spu_emu::last_fault(spe_context_ptr_t spe) {
  return spe->spe.last_fault();
}

std::string spu_emu::local_store_map(spe_context_ptr_t spe) {
  return spe->spe.store_map();
}

std::string spu_emu::where(spe_context_ptr_t spe) {
  return spe->spe.loaded() ? spe->spe.program()->where() : std::string();
}

std::string spu_emu::registers(spe_context_ptr_t spe) {
  return spe->spe.loaded() ? spe->spe.program()->registers() : std::string();
}

void spu_emu::write_trace(std::ostream& out) {
  Trace::instance().write(out);
}

void spu_emu::write_trace_events(std::ostream& out, std::chrono::steady_clock::time_point origin) {
  Trace::instance().write_events(out, origin);
}

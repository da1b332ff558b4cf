// libspe2: contexts, gangs, program images, areas and machine information.
#include <pthread.h>

#include <memory>
#include <new>
#include <thread>

#include "libspe2/context.h"
#include "libspe2/load_program.h"
#include "libspe2/mapped_access.h"
#include "libspe2/process_time_limit.h"
#include "libspe2/program_image.h"
#include "spe/settings.h"

namespace {

using spu_emu::fail;

using spu_emu::kSpesPerNode;

int load_image(spe_context_ptr_t spe, const spu_emu::ProgramImage& image) {
  if (spe->running.load()) return fail(EBUSY);
  const int error = spe->spe.load(image, &spu_emu::load_program);
  return error == 0 ? 0 : fail(error);
}

int node_count() {
  const int processors = static_cast<int>(std::thread::hardware_concurrency());
  return processors <= kSpesPerNode ? 1 : (processors + kSpesPerNode - 1) / kSpesPerNode;
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

namespace {

/// A context of the gang, if there is one, beside `neighbor`, if there is one.
spe_context_ptr_t create(unsigned int flags, spe_context_ptr_t neighbor, spe_gang_context_ptr_t gang) {
  if ((flags & (SPE_ISOLATE | SPE_ISOLATE_EMULATE)) != 0) {
    errno = (flags & SPE_ISOLATE) != 0 ? ENODEV : EINVAL;
    return nullptr;
  }
  if (gang != nullptr) errno = gang->affinity.check(flags, neighbor);
  if (gang != nullptr && errno != 0) return nullptr;
  try {
    spu_emu::start_process_time_limit();
    auto context = std::make_unique<spe_context>(flags, gang, spu_emu::current_settings());
    if (gang != nullptr) {
      gang->members.fetch_add(1);
      gang->affinity.add(context.get(), neighbor);
    }
    return context.release();
  } catch (const std::bad_alloc&) {
    errno = ENOMEM;
    return nullptr;
  }
}

}  // namespace

spe_context_ptr_t spe_context_create(unsigned int flags, spe_gang_context_ptr_t gang) {
  if ((flags & SPE_AFFINITY_MEMORY) != 0 && gang == nullptr) {
    errno = EINVAL;
    return nullptr;
  }
  return create(flags, nullptr, gang);
}

spe_context_ptr_t spe_context_create_affinity(unsigned int flags, spe_context_ptr_t affinity_neighbor,
                                              spe_gang_context_ptr_t gang) {
  if (gang == nullptr) {
    errno = ESRCH;
    return nullptr;
  }
  return create(flags, affinity_neighbor, gang);
}

/// In a child of the process that made it, a context's locks may be held by threads that are not there: its
/// memory is left to the child's end.
int spe_context_destroy(spe_context_ptr_t spe) {
  if (spe == nullptr) return fail(ESRCH);
  if (!spu_emu::is_here(spe)) {
    if (spe->gang != nullptr) spe->gang->members.fetch_sub(1);
    return 0;
  }
  if (spe->running.load()) return fail(EBUSY);
  spu_emu::forget_in_event_handlers(spe);
  spu_emu::unmap_problem_state(spe);
  if (spe->gang != nullptr) {
    spe->gang->affinity.remove(spe);
    spe->gang->members.fetch_sub(1);
  }
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
  return spu_emu::open_image(filename);
}

int spe_image_close(spe_program_handle_t* program) {
  const int error = spu_emu::close_image(program);
  return error == 0 ? 0 : fail(error);
}

int spe_program_load(spe_context_ptr_t spe, spe_program_handle_t* program) {
  if (!spu_emu::is_here(spe)) return fail(ESRCH);
  if (program == nullptr) return fail(EINVAL);
  const spu_emu::ImageBytes image = spu_emu::image_bytes(*program);
  const bool has_toe = program->handle_size >= sizeof *program;
  const int result = load_image(spe, {image.bytes, has_toe ? program->toe_shadow : nullptr});
  if (!image.error.empty() && result != 0 && errno == EINVAL) spe->spe.set_last_fault(image.error);
  return result;
}

int spu_emu::program_load(spe_context_ptr_t spe, const void* image, std::size_t size) {
  if (!spu_emu::is_here(spe)) return fail(ESRCH);
  return load_image(spe, {{static_cast<const std::byte*>(image), size}});
}

void* spe_ls_area_get(spe_context_ptr_t spe) {
  if (!spu_emu::is_here(spe)) {
    errno = ESRCH;
    return nullptr;
  }
  return spe->spe.arena().base();
}

int spe_ls_size_get(spe_context_ptr_t spe) {
  if (!spu_emu::is_here(spe)) return fail(ESRCH);
  return static_cast<int>(spe->spe.store_size());
}

void* spe_ps_area_get(spe_context_ptr_t spe, enum ps_area area) {
  errno = 0;
  if (!spu_emu::is_here(spe))
    errno = ESRCH;
  else if (area_offset(area) == spu_emu::kProblemStateSize)
    errno = EINVAL;
  else if ((spe->flags & SPE_MAP_PS) == 0)
    errno = EACCES;
  if (errno != 0) return nullptr;
  spu_emu::map_problem_state(spe);
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
  return spu_emu::is_here(spe) ? 0 : fail(ESRCH);
}

int spe_mssync_status(spe_context_ptr_t spe) {
  return spu_emu::is_here(spe) ? 0 : fail(ESRCH);
}

spu_emu::SpeStatistics spu_emu::statistics(spe_context_ptr_t spe) {
  return spe->spe.statistics();
}

spu_emu::CycleProfile spu_emu::cycle_profile(spe_context_ptr_t spe) {
  return spe->spe.cycle_profile();
}

std::uint64_t spu_emu::forks_before() {
  static std::atomic<std::uint64_t> forks{0};
  [[maybe_unused]] static const int registered =
      pthread_atfork(nullptr, nullptr, [] { forks.fetch_add(1, std::memory_order_relaxed); });
  return forks.load(std::memory_order_relaxed);
}

std::string spu_emu::last_fault(spe_context_ptr_t spe) {
  if (!is_here(spe)) {
    return "the SPE belongs to the process that made it, of which this one is a child: SPEs do not "
           "come along with fork(); make new ones here";
  }
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

// libspe2: running a context, and the library calls of its program.
#include <array>
#include <bit>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <new>
#include <optional>
#include <utility>

#include "libspe2/context.h"

namespace {

using spu_emu::fail;
using spu_emu::LibraryCall;
using spu_emu::Stop;

constexpr unsigned kCallCount = 256;
constexpr unsigned kReservedCalls = 4;

/// Stands for the calls 0x2100-0x2102 in the table while the host program has put no handler there: the
/// program's engine serves them.
int served_by_engine(void*, unsigned int) {
  return 1;
}

struct CallTable {
  std::mutex mutex;
  std::array<LibraryCall, kCallCount> handlers{&served_by_engine, &served_by_engine, &served_by_engine};
};

CallTable& calls() {
  static CallTable table;
  return table;
}

int stop_status(unsigned code) {
  return static_cast<int>((code << 16U) | SPE_SPU_STOPPED_BY_STOP);
}

using RegisterWords = std::array<unsigned int, 12>;

/// What the caller gave for r3 to r5, word by word as the registers have it. Declared as doublewords, each
/// has its high word first there, whatever the byte order of this machine.
RegisterWords user_registers(spe_context_ptr_t spe, const void* argp) {
  RegisterWords words{};
  std::memcpy(words.data(), argp, sizeof words);
  const bool is_swapped = std::endian::native == std::endian::little &&
                          spe->spe.settings().user_registers == spu_emu::UserRegisters::doublewords;
  for (std::size_t i = 0; is_swapped && i < words.size(); i += 2) std::swap(words[i], words[i + 1]);
  return words;
}

/// `registers` is empty, or outlives what is returned.
spu_emu::Arguments make_arguments(spe_context_ptr_t spe, const std::optional<RegisterWords>& registers,
                                  void* argp, void* envp) {
  if (!registers) {
    return {reinterpret_cast<std::uintptr_t>(spe), reinterpret_cast<std::uintptr_t>(argp),
            reinterpret_cast<std::uintptr_t>(envp), nullptr};
  }
  const auto value = [&](std::size_t i) {
    return (static_cast<unsigned long long>((*registers)[i]) << 32U) | (*registers)[i + 1];
  };
  return {value(0), value(4), value(8), registers->data()};
}

int report_exit(const Stop& stop, spe_stop_info_t& info) {
  info.stop_reason = SPE_EXIT;
  info.result.spe_exit_code = static_cast<int>(stop.code & 0xffU);
  info.spu_status = stop_status(stop.code);
  return 0;
}

int report_signal(const Stop& stop, spe_stop_info_t& info) {
  info.stop_reason = SPE_STOP_AND_SIGNAL;
  info.result.spe_signal_code = static_cast<int>(stop.code);
  info.spu_status = stop_status(stop.code);
  return static_cast<int>(stop.code);
}

int report_call_error(const Stop& stop, int value, spe_stop_info_t& info) {
  info.stop_reason = SPE_CALLBACK_ERROR;
  info.result.spe_callback_error = value;
  info.spu_status = stop_status(stop.code);
  return fail(EFAULT);
}

/// The signal by which a Cell's kernel tells a program without SPE_EVENTS_ENABLE; 0 where it tells none.
int kernel_signal(const spu_emu::StopReport& report) {
  if (report.reason == SPE_RUNTIME_EXCEPTION) {
    return report.value == SPE_DMA_STORAGE || report.value == SPE_DMA_SEGMENTATION ? SIGSEGV : SIGBUS;
  }
  const bool is_no_instruction = report.reason == SPE_RUNTIME_ERROR && report.value == SPE_SPU_INVALID_INSTR;
  return is_no_instruction ? SIGILL : 0;
}

/// Raises the signal, which by itself says nothing of the reason. When a handler took it, the run ends as a
/// system call that a signal has interrupted.
int report_by_signal(spe_context_ptr_t spe, int signal, spe_stop_info_t& info) {
  std::fprintf(stderr, "spu_emu: %s\n", spe->spe.last_fault().c_str());
  std::raise(signal);
  info.stop_reason = SPE_RUNTIME_FATAL;
  info.result.spe_runtime_fatal = EINTR;
  info.spu_status = -1;
  return fail(EFAULT);
}

int report_fault(spe_context_ptr_t spe, const Stop& stop, spe_stop_info_t& info) {
  const int signal = spe->events_enabled() ? 0 : kernel_signal(stop.report);
  if (signal != 0) return report_by_signal(spe, signal, info);
  info.stop_reason = stop.report.reason;
  info.result.spe_runtime_error = stop.report.value;
  if (stop.report.reason != SPE_RUNTIME_EXCEPTION) {
    info.spu_status = stop.report.reason == SPE_RUNTIME_ERROR ? stop.report.value : -1;
    return fail(EFAULT);
  }
  info.spu_status = -1;
  return fail(EIO);
}

int call_library(spe_context_ptr_t spe, const Stop& stop) {
  const LibraryCall handler = spu_emu::library_call(stop.code & 0xffU);
  if (handler == nullptr || handler == &served_by_engine) {
    return spe->spe.program()->serve_library_call(stop);
  }
  return handler(spe_ls_area_get(spe), stop.argument);
}

/// Runs until a stop that concerns the caller.
int run(spe_context_ptr_t spe, Stop stop, unsigned flags, spe_stop_info_t& info) {
  while (stop.kind == Stop::Kind::library_call && (flags & SPE_NO_CALLBACKS) == 0) {
    const int value = call_library(spe, stop);
    if (value != 0) return report_call_error(stop, value, info);
    stop = spe->spe.resume(spe->spe.program()->entry_after_call());
  }
  switch (stop.kind) {
    case Stop::Kind::exit:
      return report_exit(stop, info);
    case Stop::Kind::fault:
      return report_fault(spe, stop, info);
    default:
      return report_signal(stop, info);
  }
}

void publish_stop(spe_context_ptr_t spe, const spe_stop_info_t& info) {
  if (!spe->events_enabled()) return;
  {
    const std::lock_guard lock(spe->stop_mutex);
    spe->stops.push_back(info);
  }
  spe->spe.channels().changed().notify();
}

/// Holds the context's running flag.
struct Running {
  explicit Running(spe_context_ptr_t spe_) : spe(spe_), taken(!spe_->running.exchange(true)) {}
  ~Running() {
    if (taken) spe->running.store(false);
  }
  Running(const Running&) = delete;
  Running& operator=(const Running&) = delete;
  spe_context_ptr_t spe;
  bool taken;
};

int run_context(spe_context_ptr_t spe, unsigned int& entry, unsigned int flags, void* argp, void* envp,
                spe_stop_info_t& info) {
  int result = 0;
  {
    const Running running(spe);
    if (!running.taken) return fail(EBUSY);
    const bool fresh = entry == SPE_DEFAULT_ENTRY || spe->spe.program()->begins_at(entry);
    if (!fresh && !spe->spe.program()->can_resume(entry)) return fail(EINVAL);
    std::optional<RegisterWords> registers;
    if (fresh && (flags & SPE_RUN_USER_REGS) != 0) {
      if (argp == nullptr) return fail(EINVAL);
      registers = user_registers(spe, argp);
    }
    if (spe->gang != nullptr) spe->gang->affinity.note_run(spe);
    info = {};
    const Stop stop =
        fresh ? spe->spe.start(make_arguments(spe, registers, argp, envp)) : spe->spe.resume(entry);
    result = run(spe, stop, flags, info);
    entry = spe->spe.program()->resume_entry();
    spe->status.store(info.spu_status);
  }
  const int error = errno;
  publish_stop(spe, info);
  errno = error;
  return result;
}

}  // namespace

LibraryCall spu_emu::library_call(unsigned int number) {
  const std::lock_guard lock(calls().mutex);
  return calls().handlers[number];
}

int spe_context_run(spe_context_ptr_t spe, unsigned int* entry, unsigned int runflags, void* argp, void* envp,
                    spe_stop_info_t* stopinfo) {
  if (!spu_emu::is_here(spe)) return fail(ESRCH);
  if (entry == nullptr || !spe->spe.loaded()) return fail(EINVAL);
  spe_stop_info_t unused{};
  spe_stop_info_t& info = stopinfo != nullptr ? *stopinfo : unused;
  try {
    return run_context(spe, *entry, runflags, argp, envp, info);
  } catch (const std::bad_alloc&) {
    return fail(ENOMEM);
  }
}

int spe_stop_info_read(spe_context_ptr_t spe, spe_stop_info_t* stopinfo) {
  if (!spu_emu::is_here(spe)) return fail(ESRCH);
  if (!spe->events_enabled()) return fail(ENOTSUP);
  if (stopinfo == nullptr) return fail(EINVAL);
  const std::lock_guard lock(spe->stop_mutex);
  if (spe->stops.empty()) return fail(EAGAIN);
  *stopinfo = spe->stops.front();
  spe->stops.pop_front();
  return 0;
}

int spe_callback_handler_register(void* handler, unsigned int callnum, unsigned int mode) {
  if (callnum >= kCallCount || (mode != SPE_CALLBACK_NEW && mode != SPE_CALLBACK_UPDATE)) return fail(EINVAL);
  const std::lock_guard lock(calls().mutex);
  LibraryCall& slot = calls().handlers[callnum];
  if (mode == SPE_CALLBACK_NEW && (callnum < kReservedCalls || slot != nullptr)) return fail(EACCES);
  if (mode == SPE_CALLBACK_UPDATE && slot == nullptr) return fail(ESRCH);
  if (handler == nullptr) return fail(EINVAL);
  slot = reinterpret_cast<LibraryCall>(handler);
  return 0;
}

int spe_callback_handler_deregister(unsigned int callnum) {
  if (callnum >= kCallCount) return fail(EINVAL);
  if (callnum < kReservedCalls) return fail(EACCES);
  const std::lock_guard lock(calls().mutex);
  if (calls().handlers[callnum] == nullptr) return fail(ESRCH);
  calls().handlers[callnum] = nullptr;
  return 0;
}

void* spe_callback_handler_query(unsigned int callnum) {
  errno = 0;
  if (callnum >= kCallCount) {
    errno = EINVAL;
    return nullptr;
  }
  const LibraryCall handler = spu_emu::library_call(callnum);
  if (handler == nullptr) errno = ESRCH;
  return reinterpret_cast<void*>(handler);
}

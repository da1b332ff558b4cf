#include "libspe2/mapped_access.h"

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <map>
#include <memory>
#include <mutex>

#include "libspe2/context.h"
#include "libspe2/mapped_registers.h"
#include "libspe2/word_access.h"

namespace spu_emu {

namespace {
/// The address of each mapped problem state. A fault there comes from the host program's own instruction,
/// never from within a lock of this library.
struct MappedAreas {
  std::mutex mutex;
  std::map<std::uintptr_t, std::shared_ptr<MappedRegisters>> areas;
  struct sigaction before {};
};

MappedAreas& mapped() {
  static MappedAreas instance;
  return instance;
}

struct Found {
  std::shared_ptr<MappedRegisters> registers;
  std::uint32_t offset = 0;
};

Found find(std::uintptr_t address) {
  const std::lock_guard lock(mapped().mutex);
  const auto behind = mapped().areas.upper_bound(address);
  if (behind == mapped().areas.begin()) return {};
  const auto& [first, registers] = *std::prev(behind);
  if (address - first >= kProblemStateSize) return {};
  return {registers, static_cast<std::uint32_t>(address - first)};
}

bool serve(const Found& found, void* context) {
  const auto access = word_access_of(context);
  if (!access) return false;
  std::uint32_t value = 0;
  const bool is_done = access->is_store ? found.registers->write(found.offset, access->value)
                                        : found.registers->read(found.offset, value);
  if (is_done) finish_access(context, *access, value);
  return is_done;
}

void hand_on(int signal, siginfo_t* info, void* context) {
  const struct sigaction& before = mapped().before;
  if ((before.sa_flags & SA_SIGINFO) != 0) return before.sa_sigaction(signal, info, context);
  if (before.sa_handler != SIG_DFL && before.sa_handler != SIG_IGN) return before.sa_handler(signal);
  // The instruction fails again when the handler returns, or the signal that was sent comes again.
  std::signal(signal, SIG_DFL);
  if (info->si_code <= 0) std::raise(signal);
}

void on_fault(int signal, siginfo_t* info, void* context) {
  const int error = errno;
  const bool is_fault = info->si_code > 0;
  const Found found = is_fault ? find(reinterpret_cast<std::uintptr_t>(info->si_addr)) : Found{};
  if (found.registers && serve(found, context)) {
    errno = error;
    return;
  }
  if (found.registers) {
    const RegisterName name = register_name(found.offset);
    std::fprintf(stderr,
                 "spu_emu: an instruction that is no load or store of a word, or that the register does not "
                 "take, used "
                 "%s at offset 0x%05x of a mapped problem state; call %s instead\n",
                 name.name, found.offset, name.function);
  }
  errno = error;
  hand_on(signal, info, context);
}

void install() {
  struct sigaction wanted {};
  wanted.sa_sigaction = &on_fault;
  wanted.sa_flags = SA_SIGINFO | SA_ONSTACK;
  sigemptyset(&wanted.sa_mask);
  sigaction(SIGSEGV, &wanted, &mapped().before);
}

std::uintptr_t area_of(spe_context_ptr_t spe) {
  return reinterpret_cast<std::uintptr_t>(spe->spe.arena().base()) + kProblemStateOffset;
}
}  // namespace

void map_problem_state(spe_context_ptr_t spe) {
  static std::once_flag installed;
  std::call_once(installed, &install);
  const std::lock_guard lock(mapped().mutex);
  auto& registers = mapped().areas[area_of(spe)];
  if (!registers) registers = std::make_shared<MappedRegisters>(spe);
}

void unmap_problem_state(spe_context_ptr_t spe) {
  const std::lock_guard lock(mapped().mutex);
  mapped().areas.erase(area_of(spe));
}

}  // namespace spu_emu

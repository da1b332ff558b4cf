/// @file
/// What a libspe2 context is: an SPE and what the library keeps about it.
#ifndef SPU_EMU_LIBSPE2_CONTEXT_H
#define SPU_EMU_LIBSPE2_CONTEXT_H

#include <libspe2.h>

#include <atomic>
#include <cstdint>
#include <deque>
#include <mutex>

#include "libspe2/affinity.h"
#include "spe/spe.h"

namespace spu_emu {

inline constexpr int kSpesPerNode = 8;

/// Notified by every change in any SPE that an event handler may wait for.
WaitPoint& event_point();

/// Takes a context out of all event handlers.
void forget_in_event_handlers(spe_context_ptr_t spe);

/// The handler of library call 0x2100 + `number`, or null.
using LibraryCall = int (*)(void* ls_base, unsigned int word_address);
LibraryCall library_call(unsigned int number);

/// Counts the forks between the first process and this one. A child has no thread of its parent's but one,
/// and whatever another held locked stays locked there.
std::uint64_t forks_before();

/// Whether there is such a context and this process made it.
bool is_here(spe_context_ptr_t spe);

/// Sets errno and returns -1.
inline int fail(int error) {
  errno = error;
  return -1;
}

}  // namespace spu_emu

struct spe_gang_context {
  std::atomic<int> members{0};
  spu_emu::Affinity affinity;
};

struct spe_context {
  spe_context(unsigned int flags_, spe_gang_context_ptr_t gang_, const spu_emu::EmulationSettings& settings)
      : flags(flags_), gang(gang_), spe(settings, flags_, &spu_emu::event_point()) {}

  bool events_enabled() const { return (flags & SPE_EVENTS_ENABLE) != 0; }

  const std::uint64_t made_after_forks = spu_emu::forks_before();
  const unsigned int flags;
  spe_gang_context_ptr_t const gang;
  spu_emu::Spe spe;
  std::atomic<bool> running{false};
  /// The status register after the last stop.
  std::atomic<int> status{0};
  std::mutex stop_mutex;
  std::deque<spe_stop_info_t> stops;
  /// Proxy tags used and not yet reported done; under the proxy mutex.
  unsigned int used_tags = 0;
};

inline bool spu_emu::is_here(spe_context_ptr_t spe) {
  return spe != nullptr && spe->made_after_forks == forks_before();
}

#endif

// What the SDK has no name for: how SPEs are emulated, what they did, and why one stopped.
#ifndef SPU_EMU_EMULATION_H
#define SPU_EMU_EMULATION_H

#include <libspe2.h>

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <iosfwd>
#include <optional>
#include <string>

#include "spu_emu/cycles.h"
#include "spu_emu/dma_mode.h"

#pragma GCC visibility push(default)
namespace spu_emu {

/// Which library calls (stop codes 0x2100-0x2105) of a program for the instruction-level engine are served,
/// when the host program has not registered handlers of its own. `console`: formatted text, the three
/// standard streams, time; `files`: those of the host too, as the calling user.
enum class LibraryCallAccess { none, console, files };

/// A debugger for real SPU code, which stands at the program's first instruction and asks what to do.
struct DebuggerSettings {
  /// A file of commands, one a line, after which the program runs on; empty: from standard input.
  std::string commands;
};

/// Settings of one SPE, fixed when its context is created. Sizes are in bytes.
struct EmulationSettings {
  DmaMode dma_mode = DmaMode::eager;
  /// Chooses the order of late transfers; contexts of the same seed and the same program behave the same.
  std::uint64_t seed = 1;
  /// All of code, data, heap and stack must fit in; a multiple of 128. 0 is off: 1 GB on the host engine.
  /// Real SPU code never gets more than 256 KB.
  std::uint32_t local_store_limit = 256 * 1024;
  /// What the program's code and constants are taken to occupy.
  std::uint32_t code_reserve = 48 * 1024;
  /// What the stack is taken to occupy; DMA reaches stack buffers within it. A multiple of 128.
  std::uint32_t stack_reserve = 16 * 1024;
  /// Library calls of real SPU code; the host engine's programs call their C library directly.
  LibraryCallAccess library_calls = LibraryCallAccess::files;
  /// Real SPU code: a program that has executed this many instructions since its start is stopped with
  /// SPE_RUNTIME_FATAL and ETIMEDOUT. 0 is no limit.
  std::uint64_t instruction_limit = 0;
  /// A program that has run for so long since its start, waits for mailboxes and the like included and the
  /// time in which it stood still not, is stopped with SPE_RUNTIME_FATAL and ETIMEDOUT. 0 is no limit; at
  /// most a year. In a sanitizer's build the host engine notices it in waits only.
  std::chrono::milliseconds time_limit{0};
  /// Host engine: a program that uses a bad address or more than its stack, divides by zero, or aborts is
  /// stopped with SPE_RUNTIME_FATAL; the process lives. Off, such a program ends the process where it stands,
  /// as in a sanitizer's build, for whoever wants to see it there. Takes handlers of SIGSEGV, SIGBUS, SIGFPE,
  /// SIGILL and SIGABRT, which hand on what is no program's to those before them.
  bool contain_faults = true;
  /// Decrementer ticks per second.
  double timebase_hertz = 79.8e6;
  /// Keep a timeline for write_trace.
  bool trace = false;
  /// Real SPU code: count what it would take on a Cell, for cycle_profile(). Runs several times slower.
  std::optional<CycleParameters> cycles{};
  /// Real SPU code: debug it. Without one, SPU_EMU_DEBUG=NUMBER in the environment asks for it for the SPE of
  /// this number, the first of the process being 0, and SPU_EMU_DEBUG_COMMANDS=FILE for its commands.
  std::optional<DebuggerSettings> debugger{};
};

/// Settings of contexts created from now on; process-wide, any thread. Throws std::invalid_argument, and
/// changes nothing, when the reserves do not fit into the limit, a size is no multiple of 128 or a number of
/// `cycles` cannot be.
void set_default_settings(const EmulationSettings& settings);
EmulationSettings default_settings();

/// Settings of the contexts that the constructing thread creates during this object's life; scopes nest.
/// Throws like set_default_settings.
class SettingsScope {
 public:
  explicit SettingsScope(const EmulationSettings& settings);
  ~SettingsScope();
  SettingsScope(const SettingsScope&) = delete;
  SettingsScope& operator=(const SettingsScope&) = delete;

 private:
  const EmulationSettings* outer_;
  EmulationSettings settings_;
};

/// spe_program_load of an image of `size` bytes, beyond which nothing is read whatever its headers say: how a
/// file that somebody else made is loaded from memory.
int program_load(spe_context_ptr_t spe, const void* image, std::size_t size);

/// What one SPE has done since its context was created. Commands and bytes count when they move.
struct SpeStatistics {
  std::uint64_t gets = 0;
  std::uint64_t puts = 0;
  std::uint64_t bytes_in = 0;
  std::uint64_t bytes_out = 0;
  std::uint64_t list_elements = 0;
  /// Commands that found the queue full.
  std::uint64_t queue_stalls = 0;
  std::uint64_t proxy_gets = 0;
  std::uint64_t proxy_puts = 0;
  std::uint64_t tag_waits = 0;
  /// Channel accesses that had to wait.
  std::uint64_t mailbox_waits = 0;
  std::uint64_t signal_waits = 0;
  std::uint64_t event_waits = 0;
  std::uint64_t atomics = 0;
  std::uint64_t failed_atomics = 0;
  /// Local store in use at most, in bytes: code reserve, data, heap blocks, stack reserve. Of real SPU code:
  /// its image, and quadwords behind it that were not zero at a stop.
  std::uint32_t local_store_high_water = 0;
  /// Of the loaded program, since its start, as of its last stop; 0 on the host engine.
  std::uint64_t instructions = 0;
};

/// May be called while the SPE runs; the numbers are then of about now.
SpeStatistics statistics(spe_context_ptr_t spe);

/// The rule that the context's last failing call broke, with LS address, EA, size, tag and source line as far
/// as known; empty when there was none. Not while the context runs.
std::string last_fault(spe_context_ptr_t spe);

/// Code, data, heap, stack and free bytes of the local store, one line each. Not while the context runs.
std::string local_store_map(spe_context_ptr_t spe);

/// Of real SPU code: the instruction at which it stopped, with its address and the symbol before it, in one
/// line (last_fault has it too); and all 128 registers, two a line. Empty on the host engine. Not while the
/// context runs.
std::string where(spe_context_ptr_t spe);
std::string registers(spe_context_ptr_t spe);

/// Writes everything traced so far, of all contexts, as Chrome trace JSON (opens in Perfetto), and forgets
/// it.
void write_trace(std::ostream& out);

/// The same events without the document around them, to become part of another: each in a line, a comma
/// behind it; times from `origin`.
void write_trace_events(std::ostream& out, std::chrono::steady_clock::time_point origin);

}  // namespace spu_emu
#pragma GCC visibility pop

#endif
